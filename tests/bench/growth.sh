#!/usr/bin/env bash
# How cost grows: `leda simulate` on Sainte-Monique AA' with ever smaller cells, 2 s simulated
# (ns_per_particle_step: without the way to the initial stress), and regions of ever more short
# sections through the server (cells of 2 m, 0.5 s).
#   growth.sh LEDA FOLDER   writes growth_particles.csv, growth_sections.csv and growth.svg beside
#                           this script; FOLDER is scratch
set -euo pipefail
[[ $# == 2 ]] || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
for tool in gnuplot jq; do
  command -v $tool >/dev/null || { echo "growth.sh needs $tool" >&2; exit 2; }
done
leda=$(realpath "$1") out=$2
here=$(dirname "$(realpath "$0")")
mkdir -p "$out"

particles=$here/growth_particles.csv sections=$here/growth_sections.csv
# Processor time of the case with cells of $1 m and $2 s simulated; its result is in $out/run.
TIMEFORMAT=%U
processor_time() {
  jq --argjson cell "$1" --argjson time "$2" '.resolution.cell_m = $cell | .stop.max_time_s = $time' \
    "$here/../data/cases/sainte-monique-AA.json" >"$out/case.json"
  rm -rf "$out/run"
  { time "$leda" simulate "$out/case.json" --out "$out/run" >"$out/said" 2>&1; } 2>&1
}
echo "cell_m,particles,steps,processor_s,initial_s,ns_per_particle_step" >"$particles"
for cell in 2 1 0.5 0.25 0.2; do
  initial=$(processor_time $cell 0.001)
  all=$(processor_time $cell 2)
  jq -r --argjson cell $cell --argjson all "$all" --argjson initial "$initial" \
    '[$cell, .particles, .steps, $all, $initial,
      (1e9 * ($all - $initial) / .particles / .steps * 10 | round / 10)] | @csv' \
    "$out/run/result.json" >>"$particles"
done

echo "sections,simulated,cell_m,wall_s,processor_s,server_peak_MiB" >"$sections"
for count in 10 100 1000; do
  rm -rf "$out/region-$count"
  "$here/region.sh" "$leda" "$out/region-$count" $count 2 0.5 all >>"$sections"
done

gnuplot <<PLOT
set terminal svg size 960,420 font "sans,12" background "white"
set output "$here/growth.svg"
set datafile separator ","
set logscale xy
set format "10^{%L}"
set grid
set key bottom right opaque
set multiplot layout 1,2
set title "One section, 2 s simulated"
set xlabel "particles"
set ylabel "processor time, s"
stats "$particles" using (log(\$2)):(log(\$4)) every ::1 name "P" nooutput
plot [3e3:1e6] "$particles" using 2:4 every ::1 with linespoints pt 7 title "all", \
  "$particles" using 2:5 every ::1 with linespoints pt 6 title "to the initial stress", \
  exp(P_mean_y) * (x / exp(P_mean_x)) ** 1.5 dt 2 title "particles^{1.5}: as steps grow with 1/cell"
set title "A region of short sections, 2 cores"
set xlabel "sections"
set ylabel "s"
stats "$sections" using (log(\$1)):(log(\$4)) every ::1 name "S" nooutput
plot [7:1500] "$sections" using 1:4 every ::1 with linespoints pt 7 title "DEM to zones", \
  "$sections" using 1:5 every ::1 with linespoints pt 6 title "processor time", \
  exp(S_mean_y) * x / exp(S_mean_x) dt 2 title "proportional to sections"
unset multiplot
PLOT
echo "$particles, $sections and growth.svg beside them"
