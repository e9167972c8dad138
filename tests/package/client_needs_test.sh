#!/usr/bin/env bash
# client_needs_test.sh PACKAGES: all that apt would install beside prosector-client on a machine without any package, recommended
# packages too, has no compiler and no development package. Exits 77 (skipped) where apt has no package lists.
set -euo pipefail
packages=$(cd "$1" && pwd)
status=$(mktemp)
trap 'rm -f "$status"' EXIT
simulate() { apt-get --simulate -o "Dir::State::status=$status" -o APT::Install-Recommends=true install "$@"; }

apt-get indextargets 'Created-By: Packages' | grep -q . || { echo "skipped: apt has no package lists; run apt-get update"; exit 77; }
needed=$(simulate "$packages"/prosector-client_*.deb | sed -n 's/^Inst \([^ ]*\).*/\1/p' | sort -u)
count=$(wc -l <<<"$needed")
grep -qx prosector-client <<<"$needed" && grep -qx libc6 <<<"$needed" || { echo "FAILED apt would not install it"; exit 1; }
compilers='-dev$|^(gcc|g\+\+|cpp|clang|llvm)(-[0-9.]+)?$|^(make|cmake|ninja-build|binutils|build-essential)$'
if grep -E -- "$compilers" <<<"$needed"; then
  echo "FAILED these come along, of $count packages"
  exit 1
fi
# That this would be seen: the development package does need such.
simulate "$packages"/libprosector-dev_*.deb | sed -n 's/^Inst \([^ ]*\).*/\1/p' | grep -qE -- "$compilers"
echo "ok: $count packages, none of them to develop with"
