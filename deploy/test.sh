#!/usr/bin/env bash
# From a bare Debian 12 to the closing summary of the tests.
#   deploy/test.sh             release build, all tests
#   deploy/test.sh --sanitize  the same tests, built with address and undefined-behaviour sanitizers
#   deploy/test.sh --thread    the tests of the store, the server and the service, built with the
#                              thread sanitizer
# The verification that takes minutes is deploy/validate.sh's.
# Ends non-zero when anything fails. A second run builds only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=release
targets=()
which_tests=()
case "${1:-}" in
  "") ;;
  --sanitize) preset=sanitize ;;
  --thread)
    preset=thread
    targets=(--target leda db_test server_test service_test nothing_lost)
    which_tests=(-L '^threads$')
    ;;
  *) echo "usage: deploy/test.sh [--sanitize | --thread]" >&2; exit 2 ;;
esac

# CI also tests what needs a cluster; elsewhere that is skipped where Slurm is not installed.
deploy/install.sh ${CI:+--cluster}
cmake --preset "$preset"
cmake --build --preset "$preset" "${targets[@]}"
rm -f build/thread/race.*
ctest --preset "$preset" --parallel "$(nproc)" "${which_tests[@]}"
# A server that a test kills can't fail the test by its exit code: what it reported stands in a file.
if compgen -G 'build/thread/race.*' >/dev/null; then
  cat build/thread/race.* >&2
  exit 1
fi
