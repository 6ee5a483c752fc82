#!/usr/bin/env bash
# The long validation, with the release build: every run of tests/validation/runs.tsv, the problems
# with a known answer (the long ones too) and `leda check`. Rewrites tests/validation/results.csv,
# check.csv and pictures/, tests/verification/measured.csv, and the tables of the READMEs from them.
#   deploy/validate.sh             everything; an hour or more
#   deploy/validate.sh -j 2        two runs at a time: quicker, but run times then tell less
#   deploy/validate.sh -g GROUP    of the runs only this group of runs.tsv, none of the rest
#   deploy/validate.sh -l RUNS.tsv another list of runs; everything goes to build/validation/ alone
# Runs whose row has the same program and case are left out, so it goes on where it was stopped.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() { sed -n '2,9s/^# \{0,1\}//p' deploy/validate.sh >&2; exit 2; }
at_a_time=1 group='' list=''
while getopts 'j:g:l:' option; do
  case $option in
    j) at_a_time=$OPTARG ;;
    g) group=$OPTARG ;;
    l) list=$(realpath "$OPTARG") ;;
    *) usage ;;
  esac
done
[[ $# -lt $OPTIND ]] || usage
declare -A package=([jq]=jq [sqlite3]=sqlite3 [h5dump]=hdf5-tools [gnuplot]=gnuplot-nox)
for tool in "${!package[@]}"; do
  command -v "$tool" >/dev/null || {
    echo "deploy/validate.sh needs $tool: apt-get install ${package[$tool]}" >&2
    exit 2
  }
done

validation=tests/validation
out=build/validation
table=$validation/results.csv
mkdir -p "$out"
if [[ -n $list ]]; then
  [[ -r $list ]] || { echo "$list cannot be read" >&2; exit 2; }
  table=$out/results.csv
fi
deploy/install.sh
cmake --preset release
cmake --build --preset release
# A copy, so that a build in the meantime does not change the program between two runs.
cp -t "$out" build/release/leda build/release/leda-commands

failed=()
step() {  # what, command...: a failure does not keep the rest from being measured
  echo "== $1" >&2
  "${@:2}" || failed+=("$1")
}

step "runs" $validation/run_list.sh -j "$at_a_time" ${group:+-g "$group"} "$out/leda" \
  "${list:-$validation/runs.tsv}" $validation/cases "$out" "$table"

draw() {
  local folder picture from to ended=0
  while IFS=$'\t' read -r folder picture from to; do
    [[ -z $folder || $folder == \#* || ! -e $out/$folder/result.json ]] && continue
    $validation/draw_strain.sh "$out/$folder" "$out/$folder/case.json" "$1/$picture.png" \
      ${from:+"$from" "$to"} || ended=1
  done <$validation/pictures.tsv
  return $ended
}

if [[ -n $list ]]; then
  mkdir -p "$out/pictures"
  step "pictures" draw "$out/pictures"
  step "leda check" "$out/leda" check --csv "$out/check.csv"
  step "verification" tests/verification/measure.sh build/release "$out/measured.csv"
elif [[ -z $group ]]; then
  step "pictures" draw $validation/pictures
  step "leda check" "$out/leda" check --csv $validation/check.csv
  step "verification" tests/verification/measure.sh build/release tests/verification/measured.csv
fi
[[ -n $list ]] || step "tables" $validation/write_tables.sh

if ((${#failed[@]})); then
  printf -v text '%s, ' "${failed[@]}"
  echo "failed: ${text%, }" >&2
  exit 1
fi
