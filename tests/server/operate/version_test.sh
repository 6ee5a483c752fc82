#!/usr/bin/env bash
# The version that write_version.cmake writes: version_test.sh CMAKE
set -euo pipefail
cmake=$1
script=$(cd "$(dirname "$0")/../../.." && pwd)/server/operate/write_version.cmake
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null GIT_CEILING_DIRECTORIES=$folder
unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

# written SOURCE: the version that stands in the file afterwards
written() {
  "$cmake" -D SOURCE="$1" -D VERSION=1.2.3 -D OUT="$folder/version.cpp" -P "$script"
  sed -n 's/.*return "\(.*\)".*/\1/p' "$folder/version.cpp"
}
expect() {
  [[ $2 == "$1" ]] || { echo "$3: \"$2\" and not \"$1\"" >&2; exit 1; }
}

mkdir "$folder/tarball" "$folder/checkout"
expect 1.2.3 "$(written "$folder/tarball")" "a tarball"

cd "$folder/checkout"
git init -q
echo one >file
git add file
git -c user.name=n -c user.email=e commit -qm one
git tag v9.9.9
commit=$(git rev-parse --short=8 HEAD)
expect "1.2.3+g$commit" "$(written "$PWD")" "a checkout"
before=$(stat -c %y "$folder/version.cpp")
expect "1.2.3+g$commit" "$(written "$PWD")" "a second build"
expect "$before" "$(stat -c %y "$folder/version.cpp")" "a file that need not be written"
echo untracked >other
expect "1.2.3+g$commit" "$(written "$PWD")" "a file that is not tracked"
echo two >file
expect "1.2.3+g$commit-dirty" "$(written "$PWD")" "a change"
mkdir inside
expect 1.2.3 "$(written "$PWD/inside")" "a tarball in another project's checkout"
