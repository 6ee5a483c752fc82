#!/usr/bin/env bash
# format_test.sh finds what is badly written in each room of this house, and in a new one.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here/../../.clang-format" "$folder"

for room in "$here"/../../*/ new; do
  room=$folder/$(basename "$room")
  [[ $room != */build ]] || continue
  mkdir "$room"
  echo 'int  crest ;' >"$room/bad.cpp"
  code=0
  "$here/format_test.sh" "$folder" >/dev/null 2>&1 || code=$?
  [[ $code != 77 ]] || exit 77
  [[ $code != 0 ]] || { echo "no look was taken at $room" >&2; exit 1; }
  rm -r "$room"
done
mkdir "$folder/good"
echo 'int crest;' >"$folder/good/good.cpp"
"$here/format_test.sh" "$folder"
