#!/usr/bin/env bash
# Runs a list of cases with `leda simulate` and keeps one row a run.
#   run_list.sh [-j N] [-g GROUP] [-c COMMIT] LEDA RUNS.tsv CASES OUT RESULTS.csv
#   -j N       so many at a time (1); with more than one, run times are those of a shared machine
#   -g GROUP   this group of the list only
#   -c COMMIT  the commit LEDA was built from, where it is not that of the source beside this script
# A run whose row in RESULTS.csv has the same commit and the same case is not run again. Rows are in
# the order of the list and are written as soon as their run ends; one that was not run anew keeps
# its old row, and every row names its commit. A run that gives no result does not end the list: the
# script ends with 1 and names it.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
at_a_time=1 only='' commit=''
while getopts 'j:g:c:' option; do
  case $option in
    j) at_a_time=$OPTARG ;;
    g) only=$OPTARG ;;
    c) commit=$OPTARG ;;
    *) sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[[ $# -eq 5 ]] || { sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[[ $at_a_time =~ ^[1-9][0-9]?$ ]] || { echo "-j $at_a_time: a number from 1 to 99" >&2; exit 2; }
leda=$1 list=$2 cases=$3 out=$4 table=$5
for tool in jq sha256sum; do
  command -v "$tool" >/dev/null || { echo "$tool is missing: apt-get install jq coreutils" >&2; exit 2; }
done
[[ -x $leda ]] || { echo "$leda is no program" >&2; exit 2; }
if [[ -n $only ]] && ! cut -f1 "$list" | grep -qx -- "$only"; then
  echo "no group $only in $list" >&2
  exit 2
fi

# Only what decides a result counts: a page or a test that changed makes no run stale.
program_commit() {
  local source=(solver server/documents server/run server/commands/simulate.cpp ':!*.md') id
  cd "$(dirname "$0")/../.."
  id=$(git log -1 --format=%h --abbrev=8 -- "${source[@]}" 2>/dev/null) && [[ -n $id ]] || return 0
  git diff --quiet HEAD -- "${source[@]}" || id+="-changed"
  echo "$id"
}
commit=${commit:-$(program_commit)}
date=$(date -u +%Y-%m-%d)
machine="$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $(nproc) cores"
version=$("$leda" --version)
columns='group,name,commit,case_file,date,machine,at_a_time,version,cell_m,particles_per_cell,status,trigger,retrogression_m,runout_m,runout_from_crest_m,slides,simulated_s,run_time_s,particles,steps,ns_per_particle_step,energy_error,numerical_dissipation,note'

slug() { tr -cs 'A-Za-z0-9.\n' '-' <<<"$1-$2"; }
listed() { grep -v -e '^#' -e '^$' "$list"; }

# Every row that stands, into a file of its own.
mkdir -p "$out/rows"
rm -f "$out"/rows/*
if [[ -s $table && $(head -1 "$table") == "$columns" ]]; then
  while IFS=$'\t' read -r group name _; do
    grep -F -- "\"$group\",\"$name\"," "$table" | head -1 >"$out/rows/$(slug "$group" "$name")" || true
  done < <(listed)
elif [[ -s $table ]]; then
  echo "$table has other columns: its rows are not kept" >&2
fi

assemble() {
  local group name
  {
    echo "$columns"
    while IFS=$'\t' read -r group name _; do
      cat "$out/rows/$(slug "$group" "$name")" 2>/dev/null || true
    done < <(listed)
  } >"$table.part"
  mv "$table.part" "$table"
}

write_row() {  # group, name, folder, case
  jq -r --slurpfile case "$3/case.json" --arg date "$date" --arg machine "$machine" \
    --arg version "$version" --arg group "$1" --arg name "$2" --arg commit "$commit" \
    --arg case_file "$4" --argjson at_a_time "$at_a_time" '
    [$group, $name, $commit, $case_file, $date, $machine, $at_a_time, $version,
     $case[0].resolution.cell_m, $case[0].resolution.particles_per_cell, .status, .trigger_used,
     (.crest_to_crest_retrogression_m, .runout_m, .runout_from_crest_m | . * 10 | round / 10),
     .slides, (.simulated_s, .run_time_s | . * 10 | round / 10), .particles, .steps,
     (.ns_per_particle_step | . * 10 | round / 10), (.balances.energy | . * 1e4 | round / 1e4),
     (.numerical_dissipation | . * 1e4 | round / 1e4), ([.reason] + .warnings | map(select(. != "")) | join("; "))]
    | @csv' "$3/result.json" >"$3/row.csv"
}

run_one() {  # group, name, folder, case
  local code=0
  "$leda" simulate "$3/case.json" --out "$3" >"$3/log.txt" 2>&1 &
  local run=$!
  trap 'kill "$run" 2>/dev/null; wait "$run"; exit 4' TERM
  wait "$run" || code=$?
  if [[ ! -s $3/result.json || $code -eq 2 || $code -eq 4 ]]; then
    echo "$1: $2: leda simulate ended with $code" | tee "$3/failed" >&2
    cat "$3/log.txt" >&2
    return 1
  fi
  write_row "$1" "$2" "$3" "$4"
  mv "$3/row.csv" "$out/rows/$(slug "$1" "$2")"
}

running=0 failed=0
finish_one() {
  wait -n || failed=$((failed + 1))
  running=$((running - 1))
  assemble
}
trap 'kill $(jobs -p) 2>/dev/null; wait; exit 4' INT TERM

while IFS=$'\t' read -r group name case change; do
  [[ -n $only && $group != "$only" ]] && continue
  folder="$out/$(slug "$group" "$name")"
  text=$(jq -L "$here" "$change" "$cases/$case.json")
  hash=$(sha256sum <<<"$text" | cut -c1-12)
  row="$out/rows/$(slug "$group" "$name")"
  if [[ -n $commit && -s $row ]] && grep -qF -- "\"$group\",\"$name\",\"$commit\",\"$hash\"," "$row"; then
    echo "$group: $name: stands" >&2
    continue
  fi
  # What another program left there, a checkpoint say, is not to be taken up.
  [[ $(cat "$folder/commit" 2>/dev/null || true) == "$commit" && -n $commit ]] || rm -rf "$folder"
  mkdir -p "$folder"
  rm -f "$folder/result.json" "$folder/failed"
  echo "$commit" >"$folder/commit"
  echo "$text" >"$folder/case.json"
  ((running < at_a_time)) || finish_one
  echo "$group: $name" >&2
  run_one "$group" "$name" "$folder" "$hash" &
  running=$((running + 1))
done < <(listed)
while ((running > 0)); do finish_one; done
assemble
((failed == 0)) || { echo "$failed of the runs gave no result" >&2; exit 1; }
