#!/usr/bin/env bash
# The demo: from a DEM to zones on a map, over HTTP, on a reconstruction of Sainte-Monique.
#   deploy/demo.sh                   results in demo-out/
#   deploy/demo.sh FOLDER            results there
#   deploy/demo.sh --stay [FOLDER]   the same, and serves on until Ctrl-C, with the map page
# Installs what is missing, builds, and ends by itself. FOLDER is made anew each time.
set -euo pipefail
cd "$(dirname "$0")/.."

stay=
if [[ ${1:-} == --stay ]]; then
  stay=1
  shift
fi
out=${1:-demo-out}
deploy/install.sh
cmake --preset release
cmake --build --preset release --target leda write_demo_dem
leda=build/release/leda

if [[ -e $out && ! -e $out/.leda-demo ]]; then
  echo "$out exists and is not of an earlier demo: give another folder" >&2
  exit 2
fi
rm -rf "$out"
mkdir -p "$out"
touch "$out/.leda-demo"

build/release/write_demo_dem "$out/dem.tif"

"$leda" serve --data "$out/data" --listen 127.0.0.1:0 2>"$out/server.log" >"$out/server.txt" &
server=$!
trap 'kill "$server" 2>/dev/null || true; wait "$server" 2>/dev/null || true' EXIT
for _ in {1..100}; do
  [[ -s $out/server.txt ]] && break
  kill -0 "$server" 2>/dev/null || { cat "$out/server.log" >&2; exit 1; }
  sleep 0.1
done
url=$(sed -n 's/^leda serves //p' "$out/server.txt")
echo "the server runs at $url"

# Answers of the service; a problem is shown and ends the demo.
ask() {
  local answer
  if ! answer=$(curl -sS --fail-with-body "$@"); then
    echo "$answer" >&2
    return 1
  fi
  printf '%s\n' "$answer"
}

# Columns parted by tabs, made as wide as they need.
table() {
  awk -F'\t' '
    { for (i = 1; i <= NF; i++) { cell[NR, i] = $i; if (length($i) > width[i]) width[i] = length($i) }
      cells[NR] = NF }
    END { for (r = 1; r <= NR; r++) { line = "  "
            for (i = 1; i <= cells[r]; i++) line = line sprintf("%-" width[i] "s  ", cell[r, i])
            sub(/ +$/, "", line); print line } }'
}

echo "registering the DEM (a reconstruction, no survey)"
ask --data-binary "@$out/dem.tif" -H 'Content-Type: image/tiff' \
  "$url/rasters?name=sainte-monique" | jq -r '"  \(.id)  \(.crs)  \(.size[0]) x \(.size[1]) cells"'

# Submits a request and waits for its end, telling how far it is. Sets job.
run_job() {
  job=$(ask -H 'Content-Type: application/json' --data-binary @"$1" \
    "$url/processes/map-region/execution" | jq -r .jobID)
  echo "  job $job"
  local last='' answer state line
  while :; do
    answer=$(ask "$url/jobs/$job")
    state=$(jq -r .status <<<"$answer")
    line=$(jq -r '"\(.progress) %  \(.message)"' <<<"$answer")
    [[ $line == "$last" ]] || echo "  $line"
    last=$line
    [[ $state == accepted || $state == running ]] || break
    sleep "${2:-1}"
  done
  [[ $state == successful ]] || { echo "the job is $state" >&2; exit 1; }
}

echo "submitting the region"
run_job deploy/demo/region.json

number='def number: if . == null then "-" else (. * 10 | round / 10 | tostring) end;'
echo
echo "Sections"
{
  printf 'section\tretrogression/m\trunout/m\tstatus\trun time/s\n'
  ask "$url/jobs/$job/sections" | jq -r "$number"'.sections[] | [.name,
    (.crest_to_crest_retrogression_m | number), (.runout_m | number), .status,
    (.run_time_s | number)] | @tsv'
} | table

names="AA%27,BB%27"
comparison=$(ask "$url/jobs/$job/compare?sections=$names")
ask "$url/jobs/$job/compare?sections=$names&f=svg" >"$out/AA-BB.svg"
echo
echo "AA' and BB' side by side (drawing: $out/AA-BB.svg)"
{
  jq -r '"\t" + ([.sections[].name] | @tsv) + "\tdifference"' <<<"$comparison"
  jq -r "$number"'. as $c | ["crest_to_crest_retrogression_m", "runout_m", "runout_from_crest_m",
    "slides", "run_time_s"][] as $k
    | [$k, ($c.sections[].result[$k] | number), ($c.differences[0][$k] | number)]
    | @tsv' <<<"$comparison"
} | table

curl -fsS -o "$out/zones.gpkg" "$url/jobs/$job/export?f=gpkg"
curl -fsS -o "$out/zones.geojson" "$url/jobs/$job/export?f=geojson"

echo
echo "How sure: the same soil with uncertain numbers, 16 members of 7 sections, a minute or two"
jq --slurpfile ensemble deploy/demo/ensemble.json '.inputs.name += ", uncertain"
  | .inputs.sections[2].spacing_m = 100 | .inputs.ensemble = $ensemble[0]' \
  deploy/demo/region.json >"$out/uncertain-region.json"
run_job "$out/uncertain-region.json" 5
curl -fsS -o "$out/probability-zones.gpkg" "$url/jobs/$job/export?f=gpkg"
for file in {release,runout}_probability.{tif,qml}; do
  curl -fsS -o "$out/$file" "$url/jobs/$job/rasters/$file"
done
ask "$url/jobs/$job/compare?sections=$names&f=svg&of=curves" >"$out/AA-BB-curves.svg"
echo
echo "Retrogression/m that is exceeded with 95, 80, 50, 20 and 5 %, if a slide starts there"
{
  printf 'section\tslides\t95 %%\t80 %%\t50 %%\t20 %%\t5 %%\n'
  for section in $(ask "$url/jobs/$job/sections" | jq -r '.sections[].name | @uri'); do
    ask "$url/jobs/$job/sections/$section/ensemble" | jq -r '[.section,
      "\(.probability_of_sliding.value * 100 | round) %",
      (.retrogression.quantiles | sort_by(-.exceedance)[] | .text)] | @tsv'
  done
} | table
echo "16 members know a probability to about 0.2: README.md, \"How sure\", has the command for more."

echo
echo "Zones:   $out/zones.gpkg and $out/zones.geojson (open them in QGIS)"
echo "         $out/probability-zones.gpkg, $out/release_probability.tif and runout_probability.tif"
echo "Data:    $out/data, served again by: $leda serve --data $out/data"
if [[ -n $stay ]]; then
  echo "Map:     open $url in a browser; Ctrl-C ends the server"
  wait "$server"
else
  echo "Map:     then open http://127.0.0.1:8080 in a browser; or deploy/demo.sh --stay serves on by itself"
fi
