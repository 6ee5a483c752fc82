#!/usr/bin/env bash
# Runs a list of cases with `leda simulate`, one after the other, and writes one row a run.
#   run_list.sh LEDA RUNS.tsv CASES OUT RESULTS.csv [GROUP]
# A row is written as soon as its run ends, in the order of the list. A run that fails has its
# status in the row and does not end the list.
set -euo pipefail

[[ $# -ge 5 && $# -le 6 ]] || { sed -n '2,5s/^# //p' "$0" >&2; exit 2; }
leda=$1 list=$2 cases=$3 out=$4 table=$5 only=${6:-}
date=$(date -u +%Y-%m-%d)
machine="$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $(nproc) cores"
version=$("$leda" --version)
mkdir -p "$out"

echo 'date,machine,version,group,name,cell_m,particles_per_cell,status,trigger,retrogression_m,runout_m,runout_from_crest_m,slides,simulated_s,run_time_s,particles,steps,ns_per_particle_step,energy_error,numerical_dissipation,note' >"$table"
while IFS=$'\t' read -r group name case change; do
  [[ -z $group || $group == \#* ]] && continue
  [[ -n $only && $group != "$only" ]] && continue
  folder="$out/$(tr -cs 'A-Za-z0-9.\n' '-' <<<"$group-$name")"
  mkdir -p "$folder"
  jq "$change" "$cases/$case.json" >"$folder/case.json"
  echo "$group: $name" >&2
  code=0
  "$leda" simulate "$folder/case.json" --out "$folder" >"$folder/log.txt" 2>&1 || code=$?
  if [[ ! -s $folder/result.json || $code -eq 2 ]]; then
    echo "$name: leda simulate ended with $code" >&2
    cat "$folder/log.txt" >&2
    exit 1
  fi
  jq -r --slurpfile case "$folder/case.json" --arg date "$date" --arg machine "$machine" \
    --arg version "$version" --arg group "$group" --arg name "$name" '
    [$date, $machine, $version, $group, $name, $case[0].resolution.cell_m,
     $case[0].resolution.particles_per_cell, .status, .trigger_used,
     (.crest_to_crest_retrogression_m, .runout_m, .runout_from_crest_m | . * 10 | round / 10),
     .slides, (.simulated_s, .run_time_s | . * 10 | round / 10), .particles, .steps,
     (.ns_per_particle_step | . * 10 | round / 10), (.balances.energy | . * 1e4 | round / 1e4),
     (.numerical_dissipation | . * 1e4 | round / 1e4), ([.reason] + .warnings | map(select(. != "")) | join("; "))]
    | @csv' "$folder/result.json" >>"$table"
done <"$list"
