#!/usr/bin/env bash
# From a bare Debian 12 to the closing summary of the tests.
#   deploy/test.sh             release build, all tests
#   deploy/test.sh --sanitize  built with address and undefined-behaviour sanitizers; the tests
#                              labelled "long" are left out
# Ends non-zero when anything fails. A second run builds only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=release
which_tests=()
case "${1:-}" in
  "") ;;
  --sanitize) preset=sanitize; which_tests=(-LE '^long$') ;;
  *) echo "usage: deploy/test.sh [--sanitize]" >&2; exit 2 ;;
esac

# CI also tests what needs a cluster; elsewhere that is skipped where Slurm is not installed.
deploy/install.sh ${CI:+--cluster}
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)" "${which_tests[@]}"
