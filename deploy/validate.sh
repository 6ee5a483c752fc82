#!/usr/bin/env bash
# The long validation: every run of tests/validation/runs.tsv and the long verification tests,
# with the release build. Rewrites tests/validation/results.csv (date and machine in every row) and
# the pictures. Takes an hour or two on two cores; the runs go one after the other, so that their
# run times mean something.
#   deploy/validate.sh               everything
#   deploy/validate.sh GROUP         one group of runs.tsv, into build/validation/GROUP.csv
set -euo pipefail
cd "$(dirname "$0")/.."

group=${1:-}
[[ $# -le 1 && $group != -* ]] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
for tool in h5dump gnuplot; do
  command -v "$tool" >/dev/null || { echo "$tool is missing: apt-get install hdf5-tools gnuplot-nox" >&2; exit 2; }
done

deploy/install.sh
cmake --preset release
cmake --build --preset release --target leda leda_verification_long

validation=tests/validation
out=build/validation
mkdir -p "$out"
# A copy, so that a build in the meantime does not change the program between two runs.
cp build/release/leda "$out/leda"

table="$out/${group:-results}.csv"
if [[ -n $group ]] && ! cut -f1 $validation/runs.tsv | grep -qx -- "$group"; then
  echo "no group $group in $validation/runs.tsv" >&2
  exit 2
fi
$validation/run_list.sh "$out/leda" $validation/runs.tsv $validation/cases "$out" "$table" ${group:+"$group"}
[[ -z $group ]] || { echo "$table"; exit; }

mv "$table" $validation/results.csv
while IFS=$'\t' read -r folder picture from to; do
  [[ -z $folder || $folder == \#* ]] && continue
  $validation/draw_strain.sh "$out/$folder" "$out/$folder/case.json" "$validation/pictures/$picture.png" \
    ${from:+"$from" "$to"}
done <$validation/pictures.tsv

build/release/tests/verification/leda_verification_long --gtest_output="xml:$out/verification_long.xml"
