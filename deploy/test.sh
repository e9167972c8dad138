#!/usr/bin/env bash
# Installs, builds and runs every test. --quick leaves out the sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

quick=no
for option in "$@"; do
  case $option in
    --quick) quick=yes ;;
    *) echo "usage: deploy/test.sh [--quick]"; exit 2 ;;
  esac
done

step() { printf '\n== %s (%d min %02d s)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)); }
jobs=${PROSECTOR_JOBS:-$(nproc)}
export PROSECTOR_WERROR=ON

step "set-up"
deploy/setup.sh
deploy/fetch_anatomy.sh
step "include rules and layout"
deploy/check_includes.sh
deploy/check_format.sh
step "build: release"
deploy/build.sh release
step "tests: release"
ctest --test-dir build/release --output-on-failure -j2 || {
  echo "test: see above; again: ctest --test-dir build/release --rerun-failed --output-on-failure" >&2
  exit 1
}
if [ "$quick" = no ]; then
  step "build: address and undefined-behaviour sanitizers"
  cmake --preset asan -DPROSECTOR_WERROR=ON >/dev/null
  # Every unit and fuzz test's executable; the end-to-end ones and the benches' program run optimised only.
  mapfile -t targets < <(ninja -C build/asan -t targets all | sed -n 's/^\(test_[a-z0-9_]*\): phony$/\1/p' |
    grep -vx test_bench_json | sort -u)
  deploy/build.sh asan "${targets[@]}"
  step "tests: address and undefined-behaviour sanitizers"
  # Not the tests that time real terminals and processes (sanitizers slow those down), nor the network's budget, which takes minutes then.
  ctest --test-dir build/asan --output-on-failure -j2 -L '^(unit|fuzz)$' -E '^(drivers|server_process|soft_budget)\.' || {
    echo "test: see above; again: ctest --test-dir build/asan --rerun-failed --output-on-failure" >&2
    exit 1
  }
fi
step "all tests passed"
