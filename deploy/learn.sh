#!/usr/bin/env bash
# Goes through the lessons of docs/learn by their own words, in real windows on a screen of its own, and makes their pictures.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

usage() {
  cat <<TXT
deploy/learn.sh [--out DIR] [--renew] [LESSON]...
  LESSON       desk, headset, host, observer, programmer, researcher, webcam (default: all, in 10 minutes at most)
  --out DIR    logs, and screenshots in its subfolder pictures (default out/learn)
  --renew      copies the screenshots to docs/pictures
Uses the programs in build/release/bin, or in PROSECTOR_BIN.
TXT
}

out=$root/out/learn renew=no lessons=()
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=${2:?--out needs a folder}; shift ;;
    --renew) renew=yes ;;
    -h | --help) usage; exit 0 ;;
    desk | headset | host | observer | programmer | researcher | webcam) lessons+=("$1") ;;
    *) echo "learn: unknown option or lesson $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done
for tool in xvfb-run xdotool unshare ip; do
  command -v $tool > /dev/null || { echo "learn: $tool is not installed: deploy/setup.sh" >&2; exit 77; }
done

# A network of its own: the lessons' sessions have plain names, which somebody else's may have, too.
status=0
unshare --map-root-user --net bash -c 'ip link set lo up multicast on && exec "$@"' - \
  "$root/deploy/with_display.sh" 1640x1260 "$root/tests/e2e/learn.py" "${PROSECTOR_BIN:-$root/build/release/bin}" "$out" "${lessons[@]}" || status=$?
if [ $renew = yes ]; then
  cp "$out"/pictures/*.png "$root/docs/pictures/"
fi
exit $status
