#!/usr/bin/env bash
# The programs of a release can be moved in memory, have tables that nobody writes to after the start,
# and functions that notice an overrun stack or buffer: hardened_test.sh PROGRAM...
set -euo pipefail

for program; do
  said=$(readelf --wide --file-header --program-headers --dynamic --dyn-syms "$program")
  for sign in 'Type: *DYN' 'GNU_RELRO' 'FLAGS_1.* NOW.* PIE' '__stack_chk_fail' '__mem(cpy|move|set)_chk'; do
    grep -Eq "$sign" <<<"$said" || { echo "$program: no $sign" >&2; exit 1; }
  done
done
