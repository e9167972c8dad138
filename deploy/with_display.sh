#!/usr/bin/env bash
# with_display.sh WIDTHxHEIGHT COMMAND...: runs a command with a virtual X server of its own, of that size in pixels.
# Status: the command's; 77 (skipped) without xvfb-run.
# -noreset: by default the X server resets when its last client disconnects, and refuses connections meanwhile.
set -euo pipefail
[ $# -ge 2 ] || { echo "usage: with_display.sh WIDTHxHEIGHT COMMAND..." >&2; exit 2; }
command -v xvfb-run > /dev/null || { echo "SKIPPED: xvfb-run is not installed: deploy/setup.sh"; exit 77; }
size=$1
shift
exec xvfb-run -a -s "-noreset -screen 0 ${size}x24" "$@"
