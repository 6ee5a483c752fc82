# A server over a bank of 12 m, for the scripts that load it. Sourced, with `leda` set; ends in a
# folder of its own, which goes when the script ends.
folder=$(mktemp -d)
server=0
trap '[[ $server == 0 ]] || kill -9 $server 2>/dev/null; rm -rf "$folder"' EXIT
cd "$folder"

# A bank of 12 m along the middle of 1 km x 0.6 km.
awk 'BEGIN {
  print "ncols 300\nnrows 500\nxllcorner 380000\nyllcorner 5113000\ncellsize 2\nNODATA_value -9999"
  for (r = 0; r < 500; r++) {
    for (c = 0; c < 300; c++) {
      s = (2 * c + 1 - 300) / 20; s = s < 0 ? 0 : s > 1 ? 1 : s
      printf "%.3f ", 20 - (11 + 2 * sin(r / 9)) * s
    }
    print ""
  }
}' >bank.asc

# region NAME SECTIONS STRENGTH_KPA CELL_M: laid along as many lines as it takes, a metre apart
region() {
  jq -n --arg name "$1" --argjson sections "$2" --argjson strength "$3" --argjson cell "$4" '{inputs: {
    name: $name, dem: "bank",
    sections: (($sections / 800 | ceil) as $lines | ($sections / $lines) as $each |
      [range($lines) | {along: [[380300 - ., 5113020], [380300 - ., 5113980]],
                        spacing_m: (960 / ($each - 0.5)), upslope_m: 100, downslope_m: 80}]),
    soil: {base_m: 0, layers: [{material: "clay"}], materials: {clay: {
      unit_weight_kN_m3: 17, shear_modulus_kPa: 3000, poisson_ratio: 0.45,
      peak_strength_kPa: $strength, k0: 0.5,
      softening: {law: "urmi", alpha: 0.95, beta: 2.8, residual_strain: 1.8,
                  remolded_strength_kPa: 1, reference_size_m: 0.014}}}},
    resolution: {cell_m: $cell, particles_per_cell: 4},
    screening: {skip_stable: true}}}'
}

timed() { # NAME COMMAND...: a row with the seconds it took
  local name=$1 begin end
  shift
  begin=$(date +%s.%N)
  "$@"
  end=$(date +%s.%N)
  awk -v name="$name" -v begin="$begin" -v end="$end" \
    'BEGIN {printf "| %s | %.2f s |\n", name, end - begin}'
}
memory_mb() { awk '/VmRSS/ {printf "%.1f", $2 / 1024}' "/proc/$server/status"; }
get() { curl -sSf -o /dev/null "$@"; }
submit() { curl -sSf -H 'Content-Type: application/json' -d @"$1" "$url/processes/map-region/execution" -o "$2"; }
finished() { until [[ $(curl -s "$url/jobs/$1" | jq -r .status) == successful ]]; do sleep 0.2; done; }

start_server() {
  "$leda" serve --data data --listen 127.0.0.1:0 --workers 2 2>>server.log >server.out &
  server=$!
  until [[ -s data/server.json ]]; do sleep 0.1; done
  url=$(jq -r .url data/server.json)
  until get "$url/healthz"; do sleep 0.1; done
}

start_server
get --data-binary @bank.asc "$url/rasters?name=bank&epsg=2950&vertical_unit=m"
machine="$(date -u +%F), $(grep -m1 'model name' /proc/cpuinfo | cut -d: -f2 | xargs), $(nproc) cores, $("$leda" --version)"
