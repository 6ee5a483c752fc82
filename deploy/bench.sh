#!/usr/bin/env bash
# The benchmarks, with the release build: one table of times (of the processor, the best of several
# repetitions), how many times a step in single precision is faster than the same in double,
# and instructions of the kernels by callgrind (AVX2).
#   deploy/bench.sh          a few minutes; results also in build/bench/
#   deploy/bench.sh --write  also keeps the instructions in tests/bench/instructions.csv
# Times only mean something on a machine that has nothing else to do: the load is printed with them.
set -euo pipefail
cd "$(dirname "$0")/.."

write=
case "${1:-}" in
  "") ;;
  --write) write=1 ;;
  *) sed -n '2,9s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

deploy/install.sh
programs=(machine_bench solver_bench map_bench run_bench screening_bench)
cmake --preset release
cmake --build --preset release --target leda kernel_run "${programs[@]}"
out=build/bench
mkdir -p "$out"
program_of() { find build/release -type f -executable -name "$1"; }

for program in "${programs[@]}"; do
  echo "== $program, load $(cut -d' ' -f1 /proc/loadavg)" >&2
  "$(program_of "$program")" --benchmark_repetitions=3 --benchmark_min_time=0.2 \
    --benchmark_enable_random_interleaving=true --benchmark_out="$out/$program.json" \
    --benchmark_out_format=json >"$out/$program.txt"
done

echo "== instructions" >&2
table=tests/bench/instructions.csv ended=0
tests/bench/count_instructions.sh "$(program_of kernel_run)" ${write:+--write "$table"} \
  >"$out/instructions.csv" || ended=$?
((ended == 0 || ended == 77)) || exit "$ended"

# name, time, unit, ratio; what has no sensible time of its own has its rate instead
jq -rs '
  [.[].benchmarks[] | select(.run_type == "iteration")
   | .waits = (.name | contains("/real_time"))  # for a child or the disk
   | .name |= gsub("/(manual_time|real_time|iterations:[0-9]+|repeats:[0-9]+)"; "")]
  | group_by(.name)
  | map((.[0].name) as $name
    | if .[0].error_occurred then {name: $name, value: "failed", unit: .[0].error_message}
      elif .[0].bytes_per_second then
        {name: $name, value: (map(.bytes_per_second) | max / 1e9), unit: "GB/s"}
      elif .[0].flops then {name: $name, value: (map(.flops) | max / 1e9), unit: "Gflop/s"}
      elif .[0].ns_per_particle then
        {name: $name, value: (map(.ns_per_particle) | min), unit: "ns/particle"}
      else {name: $name, unit: .[0].time_unit,
            value: (map(if .waits then .real_time else .cpu_time end) | min)} end)
  | (map({(.name): .value}) | add) as $best
  | def digits: if type == "number" then (. * 100 | round / 100 | tostring) else . end;
  .[] | [.name, (.value | digits), .unit,
         (if .name | test("^step/[^/]+/single/") then
            ($best[.name | sub("/single/"; "/double/")] / .value | digits) else "" end)]
  | @tsv' $(printf "$out/%s.json " "${programs[@]}") >"$out/times.tsv"

echo
echo "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1), load $(cut -d' ' -f1-3 /proc/loadavg)"
{
  printf 'name\ttime\tunit\tdouble/single\n'
  cat "$out/times.tsv"
  awk -F, -v OFS='\t' 'FNR > 1 && NF == 2 { print $1, $2, "instructions/point", "" }' \
    "$out/instructions.csv"
} | awk -F'\t' '
  { for (i = 1; i <= NF; i++) { cell[NR, i] = $i; if (length($i) > width[i]) width[i] = length($i) } }
  END { for (r = 1; r <= NR; r++) { line = ""
          for (i = 1; i <= 4; i++) line = line sprintf("%-" width[i] "s  ", cell[r, i])
          sub(/ +$/, "", line); print line } }' | tee "$out/table.txt"

# Start, documents, files and store of one section.
awk -F'\t' '
  { time[$1] = $2 * ($3 == "us" ? 1e-3 : $3 == "ns" ? 1e-6 : 1) }
  END { beside = time["program_start"] + time["documents_of_a_run"] + time["fields_file"] \
               + time["read_a_run"] + time["store_a_result/1000"]
        printf "\nbeside the simulation of a 1 m section: %.1f ms of %.0f ms, %.1f %%\n", beside,
          beside + time["section_of_1_m"], 100 * beside / (beside + time["section_of_1_m"]) }' \
  "$out/times.tsv" | tee -a "$out/table.txt"
