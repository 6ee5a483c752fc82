#!/usr/bin/env bash
# Every source is as clang-format 14 writes it, with the style of .clang-format: format_test.sh [FOLDER]
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"

command -v clang-format >/dev/null || { echo "skipped: clang-format is not installed"; exit 77; }
clang-format --version | grep -q 'version 14\.' || { echo "skipped: $(clang-format --version)"; exit 77; }
# Whatever room it stands in, also one that is built tomorrow.
find . \( -path ./build -o -name node_modules \) -prune -o -name '*.[ch]pp' -print0 |
  xargs -0 clang-format --dry-run -Werror
