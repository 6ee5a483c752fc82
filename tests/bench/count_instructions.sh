#!/usr/bin/env bash
# Instructions of a step and its parts for each point and call, counted by callgrind on kernel_run:
# in both precisions, with AVX2 and with SSE4 (callgrind knows no AVX-512).
#   count_instructions.sh PROGRAM                print the table
#   count_instructions.sh PROGRAM --write TABLE  and keep it
#   count_instructions.sh PROGRAM --check TABLE  fail where a kernel takes over 10 % more than there
# Ends with 77 (skipped), and says why, where nothing can be counted. An instruction set that the
# processor does not have is left out, and its rows are not checked.
set -euo pipefail

usage() { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[[ $# == 1 || $# == 3 ]] || usage
program=$1 what=${2:-} table=${3:-}
[[ -z $what || $what == --write || $what == --check ]] || usage

skip() { echo "skipped: $1"; exit 77; }
command -v valgrind >/dev/null || skip "valgrind is not installed (apt-get install valgrind)"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Counts one run of the program: set precision case. False where the processor has no such set.
count() {
  local status=0
  "$program" "$2" "$3" "$1" >"$scratch/calls" 2>"$scratch/log" || status=$?
  ((status != 77)) || return 1
  valgrind --tool=callgrind --callgrind-out-file="$scratch/out" "$program" "$2" "$3" "$1" \
    >"$scratch/calls" 2>"$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
  callgrind_annotate --inclusive=yes --threshold=100 "$scratch/out" >"$scratch/functions"
}

# A row of the table: its name, the function as callgrind writes it, what kernel_run calls its calls.
row() {
  local calls points
  calls=$(sed -n "s/^$3,//p" "$scratch/calls")
  points=$(sed -n 's/^points,//p' "$scratch/calls")
  # "1,234 (5.6%)  file:function [program]"
  awk -v name="$1" -v function_="$2" -v per="$((points * calls))" '
    index($0, function_) { gsub(",", "", $1); printf "%s,%.1f\n", name, $1 / per; found = 1; exit }
    END { if (!found) { print name ": no function " function_ " was called" >"/dev/stderr"; exit 1 } }
  ' "$scratch/functions"
}

missing=()
echo "kernel,instructions_per_point" >"$scratch/table"
for set in avx2 sse4; do
  for precision in single double; do
    for case in plain rate averaged long; do
      count "$set" "$precision" "$case" || { missing+=("$set"); break 2; }
      real=$([[ $precision == single ]] && echo float || echo double)
      name=$set/$precision/$case within=N_${set^^}
      {
        row "$name/step" "leda::solver::step<$real>(" steps
        row "$name/update_block" "$within::update_block<" steps
        [[ $case == plain ]] || continue
        row "$name/gather_block" "$within::gather_block<" steps
        row "$name/spread_block" "$within::spread_block<" steps
        row "$name/balance_nodes" "leda::solver::balance_nodes<$real>(" steps
        row "$name/rehome_strays" "leda::solver::rehome_strays<$real>(" rehomings
      } >>"$scratch/table"
    done
  done
done
((${#missing[@]} < 2)) || skip "this processor has neither AVX2 nor SSE4"
cat "$scratch/table"

case $what in
  --write) cp "$scratch/table" "$table" ;;
  --check)
    awk -F, -v missing="${missing[*]}" '
      FNR == 1 { next }
      missing != "" && index($1, missing "/") == 1 { next }
      NR == FNR { before[$1] = $2; next }
      !($1 in before) { print $1 " is not in the table"; bad = 1; next }
      { seen[$1] = 1; change = 100 * ($2 / before[$1] - 1) }
      change > 10 { printf "%s: %s a point, %.0f %% more than %s\n", $1, $2, change, before[$1]; bad = 1 }
      change < -10 { printf "%s: %s a point, %.0f %% less than %s: time for --write\n", $1, $2, -change, before[$1] }
      END { for (name in before) if (!(name in seen)) { print name " is in the table only"; bad = 1 }
            if (bad) print "where that is meant: count_instructions.sh PROGRAM --write TABLE"
            exit bad }' "$table" "$scratch/table" ;;
esac
