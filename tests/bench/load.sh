#!/usr/bin/env bash
# The load on a server: 10 000 sections in one job, and many requests while its workers are busy.
#   tests/bench/load.sh [BUILD]      BUILD: folder of the leda executable, default build/release
# Prints a table; needs curl, jq and wrk. Everything stays on the loopback interface.
set -euo pipefail
cd "$(dirname "$0")/../.."
leda=$PWD/${1:-build/release}/leda
sections=${LEDA_LOAD_SECTIONS:-10000}
seconds=${LEDA_LOAD_SECONDS:-15}       # of each kind of request
rounds=${LEDA_LOAD_ROUNDS:-8}          # of the last part, to see memory grow
source tests/bench/bank_server.sh

all_pages() {
  local next="$url/collections/sections/items?job=$1&limit=1000"
  while [[ -n $next ]]; do next=$(curl -sSf "$next" | jq -r '.links[] | select(.rel == "next").href'); done
}
wrk_row() { # NAME CONNECTIONS PATH
  wrk -t2 -c"$2" -d"${seconds}s" --timeout 10s --latency "$url$3" >wrk.txt
  if grep -q 'Non-2xx\|Socket errors' wrk.txt; then cat wrk.txt >&2; exit 1; fi
  printf '| %s | %s | %s | %s | %s |\n' "$1" "$2" "$(awk '/Requests\/sec/ {print $2}' wrk.txt)" \
    "$(awk '$1 == "50%" {print $2}' wrk.txt)" "$(awk '$1 == "99%" {print $2}' wrk.txt)"
}

echo "$machine"
echo
echo "One job of $sections sections, all of them stable by screening:"
echo
echo '| what | time |'
echo '|---|---|'
region many "$sections" 200 2 >many.json
timed 'submit (laid out, checked, stored)' submit many.json many.out
many=$(jq -r .jobID many.out)
timed 'until the job is done (screened, zones)' finished "$many"
timed 'list of sections, one page of 10 000' get "$url/jobs/$many/sections"
timed 'all features in pages of 1000' all_pages "$many"
timed 'results as JSON' get "$url/jobs/$many/results"
for format in gpkg geojson fgb shp; do
  timed "export as $format" get "$url/jobs/$many/export?f=$format"
done

region busy 200 40 1 >busy.json
submit busy.json busy.out
busy=$(jq -r .jobID busy.out)
until [[ $(curl -s "$url/jobs/$busy" | jq -r .status) == running ]]; do sleep 0.2; done
echo
echo "Requests while both workers compute:"
echo
echo '| request | connections | requests/s | p50 | p99 |'
echo '|---|---|---|---|---|'
for connections in 4 32; do
  wrk_row 'job status' $connections "/jobs/$busy"
  wrk_row 'items, 10' $connections "/collections/sections/items?job=$many&limit=10"
  wrk_row 'items, 100' $connections "/collections/sections/items?job=$many&limit=100"
  wrk_row 'items, 1000' $connections "/collections/sections/items?job=$many&limit=1000"
done

# The longest time the status of a job takes while pages of 10 000 are read one after the other.
(while :; do get "$url/jobs/$many/sections" || true; done) &
pages=$!
longest=0
for _ in $(seq 100); do
  took=$(curl -s -o /dev/null -w '%{time_total}' "$url/jobs/$busy")
  longest=$(printf '%s\n' "$took" "$longest" | sort -g | tail -1)
done
kill $pages
echo
echo "Slowest of 100 job states while a page of 10 000 sections is always being read: $longest s."

echo
echo "Memory of the server while requests go on (status and items in turn):"
echo
echo '| requests | resident, MB |'
echo '|---|---|'
total=0
for _ in $(seq "$rounds"); do
  for path in "/jobs/$busy" "/collections/sections/items?job=$many&limit=100"; do
    wrk -t2 -c16 -d"${seconds}s" "$url$path" >wrk.txt
    total=$((total + $(awk '/requests in/ {print $1}' wrk.txt)))
  done
  echo "| $total | $(memory_mb) |"
done
[[ $(curl -s "$url/jobs/$busy" | jq -r .status) == running ]] || echo "the workers were idle at the end: take more sections" >&2
