#!/usr/bin/env bash
# clang-tidy over the sources, with the checks of .clang-tidy and tests/.clang-tidy.
#   deploy/tidy.sh                 everything: an hour and a half of one processor
#   deploy/tidy.sh server/db       only files with this (a regular expression) in their path
# JOBS=1 keeps it to one processor. Ends non-zero when there is a finding.
set -euo pipefail
cd "$(dirname "$0")/.."

deploy/install.sh --develop
cmake --preset release >/dev/null
run-clang-tidy -quiet -p build/release -j "${JOBS:-$(nproc)}" \
  -extra-arg=-Wno-unknown-warning-option \
  "^$PWD/(?!build/).*${1:-}"
