#!/usr/bin/env bash
# Touch, shown: two headset users, through simulated trackers and gloves, grasp the liver together; one of them takes the
# kidney out by a button of its panel and makes it stiffer by the slider. An observer and an onlooker, who sees through
# the first user's eyes, take a picture of each moment. Leaves pictures, log.jsonl (what the observer knew) and figures.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

usage() {
  cat <<TXT
deploy/demo_touch.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where pictures and figures go (default out/demo_touch)
  --scene FILE   scene to host (default deploy/scenes/touch.toml); liver and kidney where that one has them
  --size WxH     of the pictures (default 800x600)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN says where the programs are, if not in build/release/bin)
It takes half a minute.
TXT
}

out=$root/out/demo_touch scene=$root/deploy/scenes/touch.toml size=800x600 setup=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=${2:?--out needs a folder}; shift ;;
    --scene) scene=${2:?--scene needs a file}; shift ;;
    --size) size=${2:?--size needs WIDTHxHEIGHT}; shift ;;
    --skip-setup) setup=no ;;
    -h | --help) usage; exit 0 ;;
    *) echo "demo: unknown option $1" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

if [ $setup = yes ]; then
  "$root/deploy/setup.sh"
  "$root/deploy/fetch_anatomy.sh"
  "$root/deploy/build.sh" release prosector-server prosector-client prosector-fastrak-twin prosector-5dt-twin
fi
bin=${PROSECTOR_BIN:-$root/build/release/bin}
mkdir -p "$out"
out=$(cd "$out" && pwd)
rm -f "$out"/*.png "$out"/*.csv "$out"/*.json "$out"/*.jsonl "$out"/*.log "$out"/*.terminal "$out"/journal.sqlite*
session=touch-$$
. "$root/deploy/demo_lib.sh"

# watch NAME FD OPTIONS: somebody who watches, and whose terminal we type at through descriptor FD.
watch() {
  local name=$1 fd=$2
  shift 2
  mkfifo "$out/$name.terminal"
  LP_NUM_THREADS=1 "$bin/prosector-client" observe --session "$session" --name "$name" --display offscreen --size "$size" \
    "$@" < "$out/$name.terminal" > "$out/$name.log" 2>&1 &
  pids+=("$!")
  eval "exec $fd> \"\$out/\$name.terminal\""
  wait_for "$out/$name.log" "everything is here" 60 "the $name"
}

# moment SECONDS NAME WHAT: waits until the hands' script is there, and has both take a picture.
moment() {
  sleep "$(awk -v due="$1" -v begun="$begun" -v now="$(date +%s.%N)" \
    'BEGIN { left = due - (now - begun); print (left > 0 ? left : 0) }')"
  say "$3"
  echo "picture $out/$2.png" >&7
  echo "picture $out/eyes-$2.png" >&8
}

host "$scene" "$session"
say "An observer watches, and an onlooker through the first user's eyes"
watch observer 7 --fps 10 --session-log "$out/log.jsonl"
observer=${pids[-1]}
watch onlooker 8 --fps 5 --follow "first user"
onlooker=${pids[-1]}

say "Two headset users join through simulated trackers and gloves"
for user in first second; do
  twins "$user." "$root/deploy/demo/touch_$user.csv" "$root/deploy/demo/touch_$user.csv"
done
users=()
for user in first second; do
  "$bin/prosector-client" join --session "$session" --name "$user user" --config "$root/deploy/demo/headset.toml" \
    --tracker "fastrak:$out/$user.tracker" --glove "5dt:$out/$user.glove" --display none --summary "$out/$user.json" \
    < /dev/null > "$out/$user.log" 2>&1 &
  users+=("$!")
  pids+=("$!")
done
for user in first second; do wait_for "$out/$user.log" "tracker .*streaming" 20 "the $user user's tracker"; done
begun=$(date +%s.%N)

moment 6 alone "The first user lifts the liver"
moment 11.3 together "The second user holds it, too"
moment 13.7 handed-over "The first user let go"
moment 15.9 touch "The first user touches the kidney: its panel comes up"
moment 18.6 button "A finger presses the button: the kidney is detached"
moment 21.9 slider "The finger pushes the slider"
moment 25.5 end "That's all"
sleep 1

for pid in "$observer" "$onlooker" "${users[@]}"; do
  kill -TERM "$pid" && wait "$pid" || fail "a client failed" "$out/observer.log"
done
kill -TERM "$server" && wait "$server" || fail "the server failed" "$out/server.log"
stop
rm -f "$out"/*.terminal
echo "Pictures and log: $out"
