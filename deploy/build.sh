#!/usr/bin/env bash
# build.sh PRESET [TARGET...]: configures and builds with Ninja. PRESET: release, asan, asan-full, tsan.
# PROSECTOR_WERROR=ON in the environment makes warnings errors, and stays so in this build folder until it is OFF;
# PROSECTOR_JOBS limits the compilers.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${1:?"usage: deploy/build.sh PRESET [TARGET...]"}
shift
jobs=${PROSECTOR_JOBS:-$(nproc)}
cmake --preset "$preset" ${PROSECTOR_WERROR:+-DPROSECTOR_WERROR="$PROSECTOR_WERROR"} >/dev/null || {
  echo "build: configuring failed; run deploy/setup.sh, or remove build/$preset and run this again" >&2
  exit 1
}
steps=$(ninja -C "build/$preset" -n "$@" | tail -n 1 | sed -n 's|^\[[0-9]*/\([0-9]*\)\].*|\1|p')
if [ -n "$steps" ]; then
  # Measured: docs/look-up/gate-costs.md. Most steps compile twelve files; some take a minute.
  echo "build: $preset: $steps steps, $jobs at a time; some $(((steps * 13 / jobs + 59) / 60)) min, less where ccache" \
    "knows them; each compiler takes up to about 2 GB of memory"
fi
NINJA_STATUS="[%f of %t, %p, %e s] " ninja -C "build/$preset" -j "$jobs" "$@" || {
  echo "build: compiling failed; see the first error above (memory short? PROSECTOR_JOBS=1 deploy/build.sh $preset)" >&2
  exit 1
}
