#!/usr/bin/env bash
# Unfinished jobs, as many as a server takes: what they cost it, and whether others wait.
#   tests/bench/many_jobs.sh [BUILD] [JOBS] [SECTIONS]   default build/release, 200 jobs of 20 000 sections
# Prints a table; needs curl and jq. Everything stays on the loopback interface.
set -euo pipefail
cd "$(dirname "$0")/../.."
leda=$(realpath "${1:-build/release}")/leda
jobs=${2:-200}
sections=${3:-20000}
source tests/bench/bank_server.sh

dismissed() { curl -sSf -X DELETE "$url/jobs/$1" -o /dev/null; }
row() { echo "| $1 | $(memory_mb) | $(awk '/VmHWM/ {printf "%.1f", $2 / 1024}' "/proc/$server/status") |"; }

echo "$machine"
echo
echo "Unfinished jobs of $sections sections each:"
echo
echo '| jobs | resident, MB | at most, MB |'
echo '|---|---|---|'
row 0
region many "$sections" 200 2 >many.json
for job in $(seq "$jobs"); do
  submit many.json "$job.out"
  ((job % 25 != 0 && job != jobs)) || row "$job"
done
echo
echo 'While they are being screened:'
echo
echo '| what | time |'
echo '|---|---|'
timed 'list of jobs, 1000 a page' get "$url/jobs?limit=1000"
timed 'status of a job' get "$url/jobs/$(jq -r .jobID 1.out)"
timed 'dismiss a job' dismissed "$(jq -r .jobID "$jobs.out")"
kill -9 "$server"
wait "$server" 2>/dev/null || true
rm data/server.json
timed 'a server killed starts again and answers' start_server
sleep "${LEDA_PAUSE_S:-60}"
echo "| resident a minute later | $(memory_mb) MB |"
timed 'dismiss another' dismissed "$(jq -r .jobID "$((jobs - 1)).out")"
