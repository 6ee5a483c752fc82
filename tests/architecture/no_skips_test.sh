#!/usr/bin/env bash
# tests/no_skips.sh on what ctest really writes of a test that passes, one that is skipped and one that
# may be: no_skips_test.sh CMAKE CTEST
set -euo pipefail
cmake=$1 ctest=$2
no_skips=$(cd "$(dirname "$0")/.." && pwd)/no_skips.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# verdict NAME: the exit code of no_skips.sh where the test of this name is skipped
verdict() {
  cat >"$folder/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(skips NONE)
enable_testing()
add_test(NAME passes COMMAND \${CMAKE_COMMAND} -E true)
add_test(NAME $1 COMMAND sh -c "exit 77")
set_tests_properties($1 PROPERTIES SKIP_RETURN_CODE 77)
END
  "$cmake" -S "$folder" -B "$folder/build" >/dev/null
  (cd "$folder/build" && "$ctest" --output-junit report.xml >/dev/null)
  "$no_skips" "$folder/build/report.xml" >"$folder/said" 2>&1 && echo 0 || echo $?
}

[[ $(verdict Qgis.Loads) == 1 ]] || { echo "a skip went unnoticed" >&2; exit 1; }
grep -q 'may not be: Qgis.Loads' "$folder/said"
[[ $(verdict InstructionCounts) == 0 ]] || { echo "a skip that may be was refused" >&2; exit 1; }
grep -q 'skipped: InstructionCounts (valgrind' "$folder/said"
