#!/usr/bin/env bash
# Builds the fuzzers with clang and runs each for some seconds.
#   tests/fuzz/run.sh SECONDS [FUZZER...]      FUZZER: case_file, requests, raster
# What breaks one is kept under build/fuzz/found/. Ends with 77 where clang or its libFuzzer is
# missing (package clang), 1 where something was found.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:?how many seconds for each}
shift
fuzzers=("${@:-case_file requests raster}")
read -ra fuzzers <<<"${fuzzers[*]}"

if ! command -v clang++ >/dev/null ||
  ! echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -x c++ -fsanitize=fuzzer - -o /dev/null 2>/dev/null; then
  echo "skipped: no clang++ with libFuzzer (apt-get install clang)"
  exit 77
fi

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${fuzzers[@]/#/fuzz_}"
found=0
for fuzzer in "${fuzzers[@]}"; do
  grown=build/fuzz/corpus/$fuzzer
  kept=build/fuzz/found/$fuzzer
  mkdir -p "$grown" "$kept"
  dictionary=()
  [[ $fuzzer == raster ]] || dictionary=(-dict=tests/fuzz/documents.dict)
  echo "== $fuzzer, $seconds s"
  UBSAN_OPTIONS=print_stacktrace=1 build/fuzz/tests/fuzz/fuzz_"$fuzzer" \
    -max_total_time="$seconds" -max_len=65536 -timeout=20 -rss_limit_mb=2048 \
    -print_final_stats=1 -verbosity=0 -artifact_prefix="$kept/" "${dictionary[@]}" \
    "$grown" tests/fuzz/corpus/"$fuzzer" || found=1
done
exit $found
