#!/usr/bin/env bash
# Runs every test that cases.tsv names and keeps what it measured.
#   measure.sh BUILD MEASURED.csv [--quick]
# BUILD is a folder of a release build with all tests; --quick leaves out leda_verification_long,
# whose old rows then stay. A test that fails has "failed" in its row, and the script ends with 1.
# A name with "/*" in cases.tsv is that of two tests, one in single and one in double precision.
set -euo pipefail
[[ $# -eq 2 || ($# -eq 3 && $3 == --quick) ]] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
command -v jq >/dev/null || { echo "jq is missing: apt-get install jq" >&2; exit 2; }
build=$1 table=$2 cases="$(dirname "$0")/cases.tsv"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

columns='test,outcome,measured,date'
touch "$scratch/rows"
ended=0
for program in $(grep -v '^#' "$cases" | cut -f5 | sort -u); do
  [[ $program == - ]] && continue
  tests=$(grep -v '^#' "$cases" | awk -F'\t' -v p="$program" '$5 == p { print $6 }' | sort -u)
  if [[ ${3:-} == --quick && $program == *_long ]]; then
    while read -r name; do
      for one in "${name/\/\*//single}" "${name/\/\*//double}"; do
        [[ ! -e $table ]] || grep -F -- "\"$one\"," "$table" >>"$scratch/rows" || true
      done
    done <<<"$tests"
    continue
  fi
  filter=$(paste -sd: <<<"$tests")
  echo "$program" >&2
  "$build/tests/$program" --gtest_brief=1 --gtest_filter="$filter" \
    --gtest_output="json:$scratch/out.json" >"$scratch/log" 2>&1 || { ended=1; cat "$scratch/log" >&2; }
  found=$(jq '[.testsuites[].testsuite[]] | length' "$scratch/out.json")
  wanted=$(($(wc -l <<<"$tests") + $(grep -cF '/*' <<<"$tests" || true)))
  if ((found != wanted)); then
    echo "$program has $found of the $wanted tests of $cases" >&2
    ended=1
  fi
  jq -r --arg date "$(date -u +%Y-%m-%d)" '.testsuites[] | .name as $suite | .testsuite[]
    | [$suite + "." + .name,
       (if .failures then "failed" elif .result == "SKIPPED" then "skipped" else "passed" end),
       (.measured // ""), $date] | @csv' "$scratch/out.json" >>"$scratch/rows"
done
{ echo "$columns"; sort -u "$scratch/rows"; } >"$table"
exit $ended
