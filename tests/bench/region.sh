#!/usr/bin/env bash
# A made-up river bank mapped through the server, from DEM to zones. Prints one line of CSV:
# sections,simulated,cell_m,wall_s,processor_s,server_peak_MiB (processor_s: server and all runs).
#   region.sh LEDA FOLDER SECTIONS CELL_M MAX_TIME_S [all]
# FACTOR, from the environment, is the time_step_factor (0.65).
# Sections are 300 m long and 10 m apart. Those that screening finds stable are skipped, as in the
# product; `all` simulates every one. FOLDER is made and keeps data and logs.
set -euo pipefail
[[ $# == 5 || $# == 6 && $6 == all ]] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
leda=$(realpath "$1") out=$2 sections=$3 cell=$4 max_time=$5
skip_stable=$([[ ${6:-} == all ]] && echo false || echo true)
mkdir -p "$out"

# The bank's height changes between 9 and 19 m along the river, its slope between 20 and 30 degrees.
length=$((sections * 10 + 200))
awk -v columns=$((length / 2)) 'BEGIN {
  printf "ncols %d\nnrows 200\nxllcorner 380000\nyllcorner 5113000\ncellsize 2\n", columns
  print "NODATA_value -9999"
  for (row = 0; row < 200; ++row) {
    y = 400 - 2 * row - 1
    for (column = 0; column < columns; ++column) {
      x = 2 * column + 1
      height = 14 + 5 * sin(x / 173)
      angle = (25 + 5 * sin(x / 61)) * 3.14159265 / 180
      rise = (y - 130) * sin(angle) / cos(angle)
      z = 5 + (rise < 0 ? 0 : rise > height ? height : rise)
      printf column ? " %.2f" : "%.2f", z
    }
    print ""
  }
}' >"$out/river.asc"

jq -n --argjson cell "$cell" --argjson max_time "$max_time" --argjson skip "$skip_stable" \
  --argjson factor "${FACTOR:-0.65}" \
  --argjson east $((380000 + length - 100)) --slurpfile soil "$(dirname "$0")/../../deploy/demo/region.json" '
  {inputs: {name: "river", dem: "river",
    sections: [{along: [[380100, 5113130], [$east, 5113130]], spacing_m: 10,
                upslope_m: 210, downslope_m: 90}],
    soil: $soil[0].inputs.soil, trigger: $soil[0].inputs.trigger,
    resolution: {cell_m: $cell, particles_per_cell: 4},
    screening: {skip_stable: $skip}, time_step_factor: $factor,
    stop: {max_time_s: $max_time}}}' >"$out/region.json"

"$leda" serve --data "$out/data" --listen 127.0.0.1:0 2>"$out/server.log" >"$out/server.txt" &
server=$!
trap 'kill "$server" 2>/dev/null || true; wait "$server" 2>/dev/null || true' EXIT
for _ in {1..300}; do
  [[ -s $out/server.txt ]] && break
  kill -0 "$server" 2>/dev/null || { cat "$out/server.log" >&2; exit 1; }
  sleep 0.1
done
url=$(sed -n 's/^leda serves //p' "$out/server.txt")
ask() { curl -sS --fail-with-body "$@" || { echo "asking $* failed" >&2; return 1; }; }

began=$(date +%s.%N)
ask --data-binary "@$out/river.asc" "$url/rasters?name=river&epsg=2950&vertical_unit=m" \
  >"$out/raster.json"
job=$(ask -H 'Content-Type: application/json' --data-binary "@$out/region.json" \
  "$url/processes/map-region/execution" | jq -r .jobID)
state=accepted
while [[ $state == accepted || $state == running ]]; do
  sleep 0.5
  state=$(ask "$url/jobs/$job" | jq -r .status)
done
ended=$(date +%s.%N)
[[ $state == successful ]] || { echo "the job is $state" >&2; exit 1; }
ask "$url/jobs/$job/sections" >"$out/sections.json"
ask "$url/collections/release_zones/items?job=$job&limit=1" >"$out/zones.json"

peak=$(awk '/VmHWM/ { printf "%.0f", $2 / 1024 }' "/proc/$server/status")
# User and system time of the server and of the runs it has waited for (proc(5), stat).
processor=$(awk -v hz="$(getconf CLK_TCK)" '{ sub(/.*\) /, ""); print ($12 + $13 + $14 + $15) / hz }' \
  "/proc/$server/stat")
wall=$(awk -v a="$began" -v b="$ended" 'BEGIN { printf "%.1f", b - a }')
simulated=$(jq '[.sections[] | select(.run_time_s != null)] | length' "$out/sections.json")
echo "$(jq '.sections | length' "$out/sections.json"),$simulated,$cell,$wall,$processor,$peak"
