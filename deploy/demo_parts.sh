#!/usr/bin/env bash
# Parts, shown: the brain's 116 regions in a window; somebody searches the list, isolates what was found, and has names
# stand beside the regions. Mouse and keys are acted. Leaves pictures; docs/pictures/parts-*.png are made of them.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
name=parts

usage() {
  cat <<TXT
deploy/demo_parts.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where pictures go (default out/demo_parts)
  --scene FILE   scene to host (default deploy/scenes/brain.toml)
  --size WxH     of the pictures (default 800x600)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN: folder of the programs; default build/release/bin)
It needs xvfb and xdotool.
TXT
}

command -v xdotool >/dev/null && command -v xvfb-run >/dev/null || { echo "demo: install xvfb and xdotool" >&2; exit 2; }
# A display of its own: nobody else moves its mouse.
[ "${DEMO_PARTS_DISPLAY:-}" = own ] ||
  DEMO_PARTS_DISPLAY=own exec "$root/deploy/with_display.sh" 1280x1024 "$0" "$@"
[[ " $* " == *" --scene "* ]] || set -- --scene "$root/deploy/scenes/brain.toml" "$@"

. "$root/deploy/demo_session.sh"
begin "$@"

# picture NAME WHAT: what the window shows.
picture() {
  say "$2"
  sleep 2  # the view comes to rest
  echo "picture $out/$1.png" >&7
  local waited=0
  until [ -s "$out/$1.png" ]; do
    [ "$waited" -lt 300 ] || fail "no screenshot of \"$2\" within 30 s" "$out/watcher.log"
    sleep 0.1
    waited=$((waited + 1))
  done
}
press() { xdotool key "$@"; sleep 0.5; }
tell() { echo "$1" >&7; sleep 0.5; }

host "$scene" "$session"
say "A user observes in a window"
display=window
watch watcher 7 --no-overlay
clients=("${pids[-1]}")
window=$(xdotool search --sync --onlyvisible --name "Prosector: $session" | head -n 1)
eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(X|Y)=')"
# point X Y: moves the pointer to a pixel of the window.
point() { xdotool mousemove $((X + $1)) $((Y + $2)); sleep 0.5; }
point $((${size%x*} / 3)) $((${size#*x} / 2))

press 1
press n
picture labelled "Names beside the regions"
press n
press l
xdotool type --delay 60 "temporal"
picture searched "The list, searched"
press Escape Escape  # the search, the list
tell "isolate temporal 12 %"
press 2
press n
picture isolated "What was found, the others faint"
tell "isolate temporal"
picture alone "What was found alone"
end
echo "Pictures: $out"
