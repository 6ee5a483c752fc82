#!/usr/bin/env bash
# Writes HINDCAST.json from the cases of this folder's parent: make.sh > HINDCAST.json
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cases=$here/../cases
jq -n -L "$here/.." -f "$here/hindcast.jq" \
  --slurpfile monique "$cases/sainte-monique-AA.json" \
  --slurpfile jude "$cases/saint-jude.json" \
  --slurpfile luc "$cases/saint-luc-de-vincennes.json" \
  --slurpfile lemieux "$cases/lemieux.json"
