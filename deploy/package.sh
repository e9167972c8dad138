#!/usr/bin/env bash
# package.sh [--out DIR] [--from BUILD]: makes the Debian packages prosector-server, prosector-client, prosector-tools and
# libprosector-dev. Builds the preset `release` first, unless BUILD, a build folder with everything built, is given.
# Default: --out out/packages.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

usage() { sed -n '2,4s/^# //p' "$0"; }
refuse() { echo "package: $1" >&2; usage >&2; exit 2; }

out=$root/out/packages from=
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=${2:?--out needs a folder}; shift ;;
    --from) from=${2:?--from needs a folder}; shift ;;
    -h | --help) usage; exit 0 ;;
    *) refuse "$1 is no option" ;;
  esac
  shift
done
for program in dpkg-shlibdeps file; do
  command -v "$program" >/dev/null || { echo "package: $program is missing; run deploy/setup.sh" >&2; exit 1; }
done
if [ -z "$from" ]; then
  "$root/deploy/build.sh" release
  from=$root/build/release
fi
[ -f "$from/CPackConfig.cmake" ] || refuse "$from is no build folder"

mkdir -p "$out"
out=$(cd "$out" && pwd)
rm -f "$out"/prosector-*.deb "$out"/libprosector-*.deb
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
umask 022
cpack --config "$from/CPackConfig.cmake" -B "$work" >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 1; }
mv "$work"/*.deb "$out"
ls -l "$out"/*.deb | awk '{ printf "package: %s, %.1f MB\n", $NF, $5 / 1e6 }'
