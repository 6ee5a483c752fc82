#!/usr/bin/env bash
# Fails where a test was skipped that may not be: no_skips.sh REPORT, which ctest --output-junit wrote.
set -euo pipefail

# What may be skipped: a pattern of the test's name, and the reason.
may_skip() {
  case $1 in
    Local/ExecutorSuite.*) echo "runs on this machine end with their server; Slurm's do not" ;;
    InstructionCounts) echo "valgrind counts AVX2, which not every processor has" ;;
    *) return 1 ;;
  esac
}

bad=0
while read -r name; do
  if reason=$(may_skip "$name"); then
    echo "skipped: $name ($reason)"
  else
    echo "skipped, and may not be: $name" >&2
    bad=1
  fi
done < <(sed -n 's/.*<testcase name="\([^"]*\)".*status="\(notrun\|disabled\)".*/\1/p' "$1")
exit $bad
