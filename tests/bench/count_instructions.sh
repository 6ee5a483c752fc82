#!/usr/bin/env bash
# Instructions of the kernels for each point and call, counted by callgrind on kernel_run.
#   count_instructions.sh PROGRAM                print the table
#   count_instructions.sh PROGRAM --write TABLE  and keep it
#   count_instructions.sh PROGRAM --check TABLE  fail where a kernel takes over 10 % more than there
# callgrind knows no AVX-512, so what is counted are the AVX2 kernels. Ends with 77 (skipped), and
# says why, where nothing can be counted.
set -euo pipefail

usage() { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[[ $# == 1 || $# == 3 ]] || usage
program=$1 what=${2:-} table=${3:-}
[[ -z $what || $what == --write || $what == --check ]] || usage

skip() { echo "skipped: $1"; exit 77; }
command -v valgrind >/dev/null || skip "valgrind is not installed (apt-get install valgrind)"
grep -qw avx2 /proc/cpuinfo || skip "this processor has no AVX2"

# name in the table, function as callgrind writes it, what kernel_run calls its calls
kernels=(
  "gather_block N_AVX2::gather_block( packed_steps"
  "update_block N_AVX2::update_block( packed_steps"
  "spread_block N_AVX2::spread_block( packed_steps"
  "UpdateColumns N_AVX2::UpdateColumns( packed_steps"
  "rehome_strays solver::rehome_strays( rehomings"
  "reference_particles_to_grid N_AVX2::ParticlesToGrid( reference_steps"
  "reference_update_velocity solver::update_velocity(leda::solver::Grid& reference_steps"
  "reference_grid_to_particles N_AVX2::GridToParticles( reference_steps"
)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
valgrind --tool=callgrind --callgrind-out-file="$scratch/out" "$program" \
  >"$scratch/calls" 2>"$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
callgrind_annotate --inclusive=yes --threshold=100 "$scratch/out" >"$scratch/functions"

count_of() { sed -n "s/^$1,//p" "$scratch/calls"; }
points=$(count_of points)
{
  echo "kernel,instructions_per_point"
  for kernel in "${kernels[@]}"; do
    read -r name function calls <<<"$kernel"
    # "1,234 (5.6%)  file:function [program]"
    awk -v name="$name" -v function_="$function" -v per="$((points * $(count_of "$calls")))" '
      index($0, function_) { gsub(",", "", $1); printf "%s,%.1f\n", name, $1 / per; found = 1; exit }
      END { if (!found) { print name ": no function " function_ " was called" >"/dev/stderr"; exit 1 } }
    ' "$scratch/functions"
  done
} >"$scratch/table"
cat "$scratch/table"

case $what in
  --write) cp "$scratch/table" "$table" ;;
  --check)
    awk -F, '
      FNR == 1 { next }
      NR == FNR { before[$1] = $2; next }
      !($1 in before) { print $1 " is not in the table"; bad = 1; next }
      { seen[$1] = 1; change = 100 * ($2 / before[$1] - 1) }
      change > 10 { printf "%s: %s a point, %.0f %% more than %s\n", $1, $2, change, before[$1]; bad = 1 }
      change < -10 { printf "%s: %s a point, %.0f %% less than %s: time for --write\n", $1, $2, -change, before[$1] }
      END { for (name in before) if (!(name in seen)) { print name " is in the table only"; bad = 1 }
            if (bad) print "where that is meant: count_instructions.sh PROGRAM --write TABLE"
            exit bad }' "$table" "$scratch/table" ;;
esac
