#!/usr/bin/env bash
# Every source is as clang-format 14 writes it, with the style of .clang-format.
set -euo pipefail
cd "$(dirname "$0")/../.."

command -v clang-format >/dev/null || { echo "skipped: clang-format is not installed"; exit 77; }
clang-format --version | grep -q 'version 14\.' || { echo "skipped: $(clang-format --version)"; exit 77; }
find solver profiles db server tests deploy -name '*.[ch]pp' -print0 |
  xargs -0 clang-format --dry-run -Werror
