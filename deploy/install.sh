#!/usr/bin/env bash
# Installs what deploy/packages.txt names and this Debian 12 does not have yet.
#   deploy/install.sh            to build, test and run
#   deploy/install.sh --cluster  also Slurm, to run sections on a cluster and to test that
#   deploy/install.sh --clients  also the programs of users and operators that tests try
#   deploy/install.sh --develop  also what work on the code needs
# Needs root or sudo only when something is missing; quick and silent otherwise.
set -euo pipefail
cd "$(dirname "$0")"

sections=" "
for argument; do
  case $argument in
    --cluster | --clients | --develop) sections+="[${argument#--}] " ;;
    *) echo "usage: deploy/install.sh [--cluster] [--clients] [--develop]" >&2; exit 2 ;;
  esac
done

wanted=$(sed 's/#.*//' packages.txt | awk -v sections="$sections" '
  /^\[/ { other = index(sections, " " $1 " ") == 0; next }
  !other { print }')
missing=()
for package in $wanted; do
  # npm is often there without Debian's package of it, which could not be installed beside that.
  [[ $package == npm ]] && command -v npm >/dev/null && continue
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $state == installed ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "missing packages; as root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
