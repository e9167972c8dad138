#!/usr/bin/env bash
# observe_scene.sh SCENE PICTURE SECONDS [OPTION...]: hosts a shipped scene on this machine alone, and lets an observer take a
# picture after so many seconds. OPTION: of prosector-client observe. PROSECTOR_BIN: folder of the programs.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
bin=${PROSECTOR_BIN:-$root/build/release/bin}
scene=${1:?"usage: deploy/observe_scene.sh SCENE PICTURE SECONDS [OPTION...]"} picture=${2:?a file for the picture} seconds=${3:?a number of seconds}
shift 3

session=observe-$scene-$$
"$bin/prosector-server" "$root/deploy/scenes/$scene.toml" --session "$session" > "${picture%.*}.log" 2>&1 &
server=$!
trap 'kill -TERM "$server" 2>/dev/null || true; wait "$server" || true' EXIT
LP_NUM_THREADS=1 "$bin/prosector-client" observe --session "$session" --name observer --timeout 300 --display osmesa --quality high --fps 2 \
  --seconds "$((seconds + 1))" --screenshot "$picture@$seconds" "$@"
