#!/usr/bin/env bash
# Draws convergence.png: distances over the cell, each share of its section's finest, from runs.csv.
# Needs gnuplot.
set -euo pipefail
cd "$(dirname "$0")"
means=$(mktemp)
trap 'rm -f "$means"' EXIT
# section, cells a band, R mean, R least, R most, L mean: default particles and step
awk -F, 'NR > 1 && $3 == 4 && $4 == 0.65 {
    k = $1 " " 2 / $2; n[k]++; r[k] += $7; l[k] += $8
    if (!(k in least) || $7 < least[k]) least[k] = $7
    if ($7 > most[k]) most[k] = $7 }
  END { for (k in n) print k, r[k] / n[k], least[k], most[k], l[k] / n[k] }' runs.csv | sort >"$means"
gnuplot <<G
set terminal pngcairo size 900,380 font "sans,10"
set output "convergence.png"
set multiplot layout 1,2
set xlabel "cells over the band of 2 m"
set xrange [1.5:6.5]
set xtics (2, 3, 4, 6)
set key bottom right
set grid y
set title "retrogression, m (mean, least and most over seeds)"
set yrange [0:200]
plot "< grep sainte-monique $means" using 2:3:4:5 with yerrorlines pt 7 title "Sainte-Monique AA'", \
     "< grep bank-10m $means" using 2:3:4:5 with yerrorlines pt 5 title "bank of 10 m"
set title "runout from the toe, m"
set yrange [0:50]
plot "< grep sainte-monique $means" using 2:6 with linespoints pt 7 title "Sainte-Monique AA'", \
     "< grep bank-10m $means" using 2:6 with linespoints pt 5 title "bank of 10 m"
G
