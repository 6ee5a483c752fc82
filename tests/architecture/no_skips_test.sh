#!/usr/bin/env bash
# tests/no_skips.sh on what ctest really writes of a test that passes, one that is skipped and one that
# may be, by its exit code and as gtest_discover_tests has it: no_skips_test.sh CMAKE CTEST
set -euo pipefail
cmake=$1 ctest=$2
no_skips=$(cd "$(dirname "$0")/.." && pwd)/no_skips.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

by_exit_code=(77 'SKIP_RETURN_CODE 77')
as_gtest=(0 'SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]"')

# verdict NAME EXIT_CODE PROPERTY: the exit code of no_skips.sh where the test of this name is skipped
verdict() {
  cat >"$folder/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(skips NONE)
enable_testing()
add_test(NAME passes COMMAND \${CMAKE_COMMAND} -E true)
add_test(NAME $1 COMMAND sh -c "echo '[  SKIPPED ] $1 (0 ms)'; exit $2")
set_tests_properties($1 PROPERTIES $3)
END
  "$cmake" -S "$folder" -B "$folder/build" >/dev/null
  (cd "$folder/build" && "$ctest" --output-junit report.xml >/dev/null)
  "$no_skips" "$folder/build/report.xml" >"$folder/said" 2>&1 && echo 0 || echo $?
}

for form in by_exit_code as_gtest; do
  declare -n how=$form
  [[ $(verdict Qgis.Loads "${how[@]}") == 1 ]] || { echo "a skip $form went unnoticed" >&2; exit 1; }
  grep -q 'may not be: Qgis.Loads' "$folder/said"
  [[ $(verdict InstructionCounts "${how[@]}") == 0 ]] ||
    { echo "a skip $form that may be was refused" >&2; exit 1; }
  grep -q 'skipped: InstructionCounts (valgrind' "$folder/said"
done
