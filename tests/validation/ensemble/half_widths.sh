#!/usr/bin/env bash
# How well P50 and P90 of a section's retrogression are known, against what it costs, by sobol, latin
# and random: leaves half_widths.tsv and half_widths.svg in DIR beside the ensembles.
#   half_widths.sh LEDA CASE.json DIR [MOST_MEMBERS]
# CASE.json has an "ensemble"; its sampling and its rule to end are replaced. Needs jq and gnuplot.
set -euo pipefail

[[ $# -eq 3 || $# -eq 4 ]] || { sed -n '2,5s/^# //p' "$0" >&2; exit 2; }
leda=$1 case=$2 out=$3 most=${4:-128}
mkdir -p "$out"

# Half the range by replicates, m; "-" where the members know no upper end.
half_width() { jq -r --argjson p "$1" '.retrogression.quantiles[] | select(.exceedance == $p)
  | .by_replicates_m | if .[1] == null then "-" else (.[1] - .[0]) / 2 end' "$2"; }

printf 'method\tmembers\tcore_s\thalf_width_P50_m\thalf_width_P90_m\n' >"$out/half_widths.tsv"
for method in sobol latin random; do
  spent=0
  for ((members = 32; members <= most; members *= 2)); do
    jq --arg method "$method" --argjson members "$members" '.ensemble.sampling = {method: $method, seed: 1}
      | .ensemble.exceedance = [0.1, 0.5] | del(.ensemble.check)
      | .ensemble.stop = {min_members: 32, max_members: $members, half_width: 0.001}' \
      "$case" >"$out/$method.json"
    # Time of the processor, runs included; members that stand cost nothing again.
    TIMEFORMAT=%U
    { time "$leda" ensemble "$out/$method.json" --out "$out/$method" --workers 1 >/dev/null; } 2>"$out/user_s"
    spent=$(awk -v a="$spent" -v b="$(tail -n 1 "$out/user_s")" 'BEGIN { print a + b }')
    answer=$out/$method/ensemble.json
    printf '%s\t%d\t%.0f\t%s\t%s\n' "$method" "$members" "$spent" "$(half_width 0.5 "$answer")" \
      "$(half_width 0.1 "$answer")" >>"$out/half_widths.tsv"
  done
done
rm -f "$out/user_s"

gnuplot <<G
set terminal svg size 900,400 font "sans-serif,12" background "white"
set output "$out/half_widths.svg"
set multiplot layout 1,2
set logscale xy; set grid; set tics nomirror; set datafile missing "-"
set xlabel "core-seconds"; set ylabel "half-width of the 95 % interval, m"
do for [i=0:1] {
  set title i == 0 ? "P50 of the retrogression" : "P90 of the retrogression"
  plot for [m in "sobol latin random"] "< grep ^".m." $out/half_widths.tsv" \
    using 3:(column(4 + i)) with linespoints lw 1.6 pt 7 ps 0.6 title m
}
G
