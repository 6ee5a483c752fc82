#!/usr/bin/env bash
# A program that needs root says that it was skipped, and why, where it has not got its rights:
# told_skip_test.sh REASON PROGRAM [OPTION...]
set -uo pipefail
reason=$1
shift
unshare --user true 2>/dev/null || { echo "skipped: no user namespaces here"; exit 77; }
said=$(unshare --user "$@" 2>&1)
code=$?
[[ $code == 77 && $said == *"$reason"* ]] && exit 0
echo "exit code $code, in place of 77: $said" >&2
exit 1
