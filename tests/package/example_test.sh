#!/usr/bin/env bash
# example_test.sh PACKAGES WORK: builds the example that libprosector-dev carries against what it carries, unpacked, away from
# our sources, and looks at the figures that it prints.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packages=$(cd "$1" && pwd) work=$2
rm -rf "$work"
mkdir -p "$work"
dpkg-deb --extract "$packages"/libprosector-dev_*.deb "$work/root"
"$here/build_example.sh" "$work/root/usr" "$work/build" >"$work/log" 2>&1 || { tail -n 30 "$work/log"; exit 1; }
"$work/build/bend_and_press" | tee "$work/figures"
"$here/check_figures.py" "$work/figures"
