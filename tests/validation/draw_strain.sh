#!/usr/bin/env bash
# Draws the last state of a run: plastic strain above, materials below, the ground before as a line.
#   draw_strain.sh RUN_FOLDER CASE.json PICTURE.png [X_FROM X_TO]
# Needs hdf5-tools and gnuplot.
set -euo pipefail

[[ $# -eq 3 || $# -eq 5 ]] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
run=$1 case=$2 picture=$3
from=${4:-$(jq '.ground[0][0]' "$case")} to=${5:-$(jq '.ground[-1][0]' "$case")}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

size=$(h5dump -H -d x "$run/fields.h5" | sed -n 's/.*SIMPLE { ( \([0-9]*\), \([0-9]*\) ).*/\1 \2/p')
frames=${size% *} particles=${size#* }
for field in x z plastic_strain material; do
  h5dump -y -w 1 -d "$field" -s "$((frames - 1)),0" -c "1,$particles" -m '%.4g' "$run/fields.h5" |
    sed -n '/DATA {/,/}/p' | grep -oE '^ *-?[0-9.]+(e[-+]?[0-9]+)?' >"$scratch/$field"
done
paste "$scratch"/{x,z,plastic_strain,material} >"$scratch/points"
jq -r '.ground[] | @tsv' "$case" >"$scratch/ground"

low=$(jq '.base_m' "$case") high=$(jq '[.ground[][1]] | max' "$case")
height=$(awk -v w="$(echo "$to $from" | awk '{print $1 - $2}')" -v h="$(echo "$high $low" | awk '{print $1 - $2}')" \
  'BEGIN { print int(1100 * (1.25 * h) / w) + 75 }')
gnuplot <<G
set terminal png size 1200,$((2 * height)) font ",9"
set output "$picture"
set multiplot layout 2,1 margins 0.04,0.9,0.1,0.97 spacing 0,0.09
set xrange [$from:$to]; set yrange [$low:$high + 0.2 * ($high - $low)]
if ($to - $from > 25 * ($high - $low)) { set ytics 20; set cbtics 1 }
set size ratio -1; unset key; set tics out nomirror
set palette defined (0 "#e8e8e8", 0.15 "#9ecae1", 0.5 "#2171b5", 1 "#f16913", 1.6 "#cb181d", 2.5 "#3f0007")
set cbrange [-1:2]; set label 1 "log10 of the plastic strain" at graph 0.01, graph 0.92
plot "$scratch/points" using 1:2:(log10(\$3 > 0.1 ? \$3 : 0.1)) with points pt 5 ps 0.25 palette, \
  "$scratch/ground" with lines lc rgb "black" lw 1
unset colorbox; unset label 1; set xlabel "m" offset 0,0.8
colour(m) = m == 0 ? 0xd9a441 : m == 1 ? 0x7fb4c9 : 0x5b5f97
plot "$scratch/points" using 1:2:(colour(\$4)) with points pt 5 ps 0.25 lc rgb variable, \
  "$scratch/ground" with lines lc rgb "black" lw 1
G
