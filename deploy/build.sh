#!/usr/bin/env bash
# build.sh PRESET [TARGET...]: configures and builds with Ninja. PRESET: release, asan, asan-full, tsan.
# PROSECTOR_WERROR=ON in the environment makes warnings errors, and stays so in this build folder until it is OFF;
# PROSECTOR_JOBS limits the compilers.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:?"usage: deploy/build.sh PRESET [TARGET...]"}
shift
jobs=${PROSECTOR_JOBS:-$(nproc)}
echo "build: $preset, $jobs at a time"
cmake --preset "$preset" ${PROSECTOR_WERROR:+-DPROSECTOR_WERROR="$PROSECTOR_WERROR"} >/dev/null || {
  echo "build: configuring failed; run deploy/setup.sh, or remove build/$preset and run this again" >&2
  exit 1
}
ninja -C "build/$preset" -j "$jobs" "$@" || {
  echo "build: compiling failed; the first error stands above (memory short? PROSECTOR_JOBS=1 deploy/build.sh $preset)" >&2
  exit 1
}
