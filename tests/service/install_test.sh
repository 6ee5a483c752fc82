#!/usr/bin/env bash
# `cmake --install` leaves programs that work by themselves: install_test.sh CMAKE BUILD_FOLDER
set -euo pipefail
cmake=$1 build=$2
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

"$cmake" --install "$build" --prefix "$prefix" >/dev/null
[[ -s $prefix/share/doc/leda/operate.md ]] || { echo "operate.md is not installed" >&2; exit 1; }
# leda hands this to leda-commands, which it looks for beside itself.
[[ $("$prefix/bin/leda" --version) == "$("$build/leda" --version)" ]]
"$prefix/bin/leda" simulate --help >/dev/null
