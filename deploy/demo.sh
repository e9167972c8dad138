#!/usr/bin/env bash
# The main job, shown: a server hosts a scene, a headset user joins through the simulated tracker and glove and presses the
# liver, a camera user joins with a bare hand in a film, 5 s later an observer joins and records. Leaves pictures, a video and
# summary.json. A film of 20 s follows, by demo_film.sh.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

usage() {
  cat <<TXT
deploy/demo.sh [--headless] [--seconds N] [--out DIR] [--scene FILE] [--no-film] [--skip-setup]
  --headless     no window; without it, and with a display, you join as a desk user
  --seconds N    duration of the session (default 20; with a window: until you close it)
  --out DIR      output folder for screenshots, video and figures (default out/demo)
  --scene FILE   scene to host (default deploy/scenes/abdomen.toml, which the film also shows)
  --no-film      omit the film of 20 s that follows
  --skip-setup   don't install, fetch or build (PROSECTOR_BIN: folder of the programs; default build/release/bin)
TXT
}

headless=no seconds=20 out=$root/out/demo scene=$root/deploy/scenes/abdomen.toml setup=yes film_too=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --headless) headless=yes ;;
    --seconds) seconds=${2:?--seconds needs a number}; shift ;;
    --out) out=${2:?--out needs a folder}; shift ;;
    --scene) scene=${2:?--scene needs a file}; shift ;;
    --no-film) film_too=no ;;
    --skip-setup) setup=no ;;
    -h | --help) usage; exit 0 ;;
    *) echo "demo: unknown option $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done
case "$seconds" in '' | *[!0-9]*) echo "demo: --seconds $seconds: must be a whole number" >&2; exit 2 ;; esac
[ "$seconds" -ge 16 ] || { echo "demo: --seconds $seconds: must be at least 16, which the hand needs to press and release" >&2; exit 2; }

if [ $setup = yes ]; then
  "$root/deploy/setup.sh"
  "$root/deploy/fetch_anatomy.sh"
  "$root/deploy/fetch_models.sh"
  "$root/deploy/build.sh" release prosector-server prosector-client prosector-fastrak-twin prosector-5dt-twin prosector-scene
fi
# After the show: a press, a panel, a second person and a cut, filmed from close by.
film_it() {
  [ $film_too = yes ] && [ "$scene" = "$root/deploy/scenes/abdomen.toml" ] || return 0
  printf '\n== A film of 20 s\n'
  PROSECTOR_BIN=$bin "$root/deploy/demo_film.sh" --skip-setup --out "$out/film"
}
# And then: the other programs that README and lessons name, and all that `cmake --install` needs.
build_the_rest() {
  [ $setup = yes ] || return 0
  printf '\n== Building the other programs that README and lessons name; the demo is over, Ctrl-C stops this\n'
  "$root/deploy/build.sh" release man_pages prosector-omni-twin prosector-inverse3-twin prosector-vrpn-twin
}
bin=${PROSECTOR_BIN:-$root/build/release/bin}
mkdir -p "$out"
out=$(cd "$out" && pwd)
rm -f "$out"/*.png "$out"/*.avi "$out/film.toml" "$out/camera_user.toml" "$out"/*.csv "$out"/*.json "$out"/*.log "$out"/*.jsonl "$out"/*.terminal "$out"/journal.sqlite*
session=demo-$$

. "$root/deploy/demo_session.sh"
. "$root/deploy/demo_lib.sh"

# press: lets the hand go on.
press() {
  echo > "$out/tracker.terminal"
  echo > "$out/glove.terminal"
}

# A camera's film is made while the server compiles its scene; without the networks that find hands there is no camera user.
film=
if [ -r "${PROSECTOR_DATA:-${XDG_DATA_HOME:-$HOME/.local/share}/prosector}/models/palm_full.tflite" ]; then
  "$bin/prosector-client" camera record "synthetic:$root/deploy/demo/camera.toml" --out "$out/film.avi" --seconds 6 \
    > "$out/film.log" 2>&1 &
  film=$!
  pids+=("$film")
else
  echo "no camera user: the hand tracking networks are missing; fetch them with deploy/fetch_models.sh"
fi

host "$scene" "$session"

say "A headset user joins through the simulated tracker and glove"
above=7.5  # s of the scripts: the hand is above the liver, and waits there for somebody to see the press
twins "" "$root/deploy/demo/hand.csv" "$root/deploy/demo/glove.csv" $above
"$bin/prosector-client" join --session "$session" --name "headset user" --config "$root/deploy/demo/headset.toml" \
  --tracker "fastrak:$out/tracker" --glove "5dt:$out/glove" --display offscreen --size 640x480 --fps 5 \
  --screenshot "$out/headset.png@10" --latency-log "$out/headset.csv" --summary "$out/headset.json" \
  > "$out/headset.log" 2>&1 &
headset=$!
pids+=("$headset")
wait_for "$out/headset.log" "everything is here" 20 "the headset user"
joined=$SECONDS

camera=
if [ -n "$film" ]; then
  say "A camera user joins: a recorded bare hand"
  wait "$film" || fail "the film was not created" "$out/film.log"
  cp "$root/deploy/demo/camera_user.toml" "$out"
  "$bin/prosector-client" join --session "$session" --name "camera user" --config "$out/camera_user.toml" \
    --tracker "hands:$out/film.avi" --display none --latency-log "$out/camera.csv" --summary "$out/camera.json" \
    > "$out/camera.log" 2>&1 &
  camera=$!
  pids+=("$camera")
  wait_for "$out/camera.log" "everything is here" 20 "the camera user"
fi

if [ $headless = no ] && [ -n "${DISPLAY:-}" ]; then
  say "You join at the desk: close the window to end"
  press
  "$bin/prosector-client" join --session "$session" --name "${USER:-desk}" || true
  stop
  film_it
  build_the_rest
  exit 0
fi

until [ "$SECONDS" -ge "$((joined + 5))" ]; do sleep 0.1; done
say "5 s later an observer joins and records"
size=800x600
watch observer 7 --fps 8 --record "$out/session.avi" --screenshot "$out/before.png@0.2" --screenshot "$out/after.png" \
  --session-log "$out/log.jsonl" --latency-log "$out/observer.csv" --summary "$out/observer.json" --seconds "$((seconds - 5))"
observer=${pids[-1]}
tail -n 0 -f "$out/server.log" &
pids+=("$!")
press
# The demo's own hand presses the liver; in a scene of yours it may reach nothing.
if [ "$scene" = "$root/deploy/scenes/abdomen.toml" ]; then
  until_is 60 "the headset user presses the liver" "now['touches'].get('headset user, right', {}).get('body') == 'liver'"
  sleep 1
else
  sleep 5
fi
echo "picture $out/press.png" >&7
waited=0
while kill -0 "$observer" 2>/dev/null; do
  kill -0 "$server" 2>/dev/null || fail "the server ended early" "$out/server.log"
  sleep 0.5
  waited=$((waited + 1))
  [ "$waited" -lt "$((2 * seconds + 120))" ] || fail "the observer did not end" "$out/observer.log"
done
wait "$observer" || fail "the observer failed" "$out/observer.log"

kill -TERM "$headset" && wait "$headset" || fail "the headset user failed" "$out/headset.log"
if [ -n "$camera" ]; then
  kill -TERM "$camera" && wait "$camera" || fail "the camera user failed" "$out/camera.log"
fi
kill -TERM "$server" && wait "$server" || fail "the server failed" "$out/server.log"
stop
rm -f "$out"/*.terminal

say "Figures"
python3 "$root/deploy/demo_report.py" "$out"
echo "Screenshots and video: $out"
film_it
build_the_rest
