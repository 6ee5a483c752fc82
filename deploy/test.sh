#!/usr/bin/env bash
# From a bare Debian 12 to the closing summary of the tests.
#   deploy/test.sh                       release build, all tests
#   deploy/test.sh --clang               builds everything with clang, whose warnings are errors too
#   deploy/test.sh --sanitize [PART/OF]  the tests, built with address and undefined-behaviour sanitizers
#   deploy/test.sh --thread [PART/OF]    the tests of the store, the server and the service, built with
#                                        the thread sanitizer
# PART/OF, as 2/8: every eighth test from the second on, to bring it to its end in parts.
# The verification that takes minutes is deploy/validate.sh's.
# Ends non-zero when anything fails. A second run builds only what changed.
# With CI set, programs of users are installed and tried too, clang builds the programs, and a skip is a
# failure unless tests/no_skips.sh lets it pass (LEDA_NO_SKIP=1 alone asks for that anywhere).
set -euo pipefail
cd "$(dirname "$0")/.."

usage() { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }

preset=release
targets=()
which_tests=()
case "${1:-}" in
  "") ;;
  --clang) preset=clang ;;
  --sanitize) preset=sanitize ;;
  --thread)
    preset=thread
    targets=(--target leda db_test server_test service_test nothing_lost)
    which_tests=(-L '^threads$')
    ;;
  *) usage ;;
esac
if [[ -n ${2:-} ]]; then
  [[ $preset =~ ^(sanitize|thread)$ && $2 =~ ^[1-9][0-9]*/[1-9][0-9]*$ ]] || usage
  which_tests+=(-I "${2%/*},,${2#*/}")
fi

# What needs a cluster or a client is skipped elsewhere, where that is not installed.
deploy/install.sh ${CI:+--cluster --clients}
cmake --preset "$preset"
cmake --build --preset "$preset" "${targets[@]}"
if [[ $preset == thread ]]; then
  # Workers have one thread and would be fifty times slower: the server's are those of the release.
  cmake --preset release
  cmake --build --preset release --target leda
  cp build/release/leda build/thread/leda
fi
[[ $preset != clang ]] || exit 0
rm -f build/thread/race.*
ctest --preset "$preset" --parallel "$(nproc)" --output-junit tests.xml "${which_tests[@]}"
# A server that a test kills can't fail the test by its exit code: what it reported stands in a file.
if compgen -G 'build/thread/race.*' >/dev/null; then
  cat build/thread/race.* >&2
  exit 1
fi
[[ $preset == release ]] || exit 0
[[ ${LEDA_NO_SKIP:-${CI:+1}} != 1 ]] || tests/no_skips.sh build/release/tests.xml
if [[ -n ${CI:-} ]]; then
  cmake --preset clang
  cmake --build --preset clang --target leda
fi
