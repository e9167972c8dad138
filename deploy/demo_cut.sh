#!/usr/bin/env bash
# A cut, shown: two headset users, through simulated trackers and gloves, cut a liver. One observer watches all, one from close
# by, one comes while the knife is in the tissue, and one is cut off the network for 3 s while it goes on. In the end all of
# them hold one topology, by its hash. Leaves pictures, log.jsonl (what the observer knew), everyone's figures and the journal.
# docs/pictures/cut-liver.png and cut-first.png are of --size 480x360.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
name=cut

usage() {
  cat <<TXT
deploy/demo_cut.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where pictures and figures go (default out/demo_cut)
  --scene FILE   scene to host (default deploy/scenes/cut.toml); liver, scalpel and knife where that one has them
  --size WxH     of the pictures (default 800x600)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN: folder of the programs; default build/release/bin)
It takes half a minute, on a busy machine longer. Only root can cut somebody off: two network namespaces hold the session and the
one who is; without them all is on this machine's loopback and that one is left out.
TXT
}

. "$root/deploy/demo_session.sh"
begin "$@"
second_view=close

room=pcut$$ ward=pcuw$$
close_network() {
  stop
  ip netns del "$room" 2>/dev/null || true
  ip netns del "$ward" 2>/dev/null || true
}
# open_network: a room and a ward, a wire between them. False where they can't be made.
open_network() {
  [ "$(id -u)" = 0 ] && command -v ip >/dev/null || return 1
  trap close_network EXIT
  { ip netns add "$room" && ip netns add "$ward" &&
    ip link add lan0 netns "$room" type veth peer name lan0 netns "$ward" &&
    ip -n "$room" addr add 10.79.0.1/24 dev lan0 && ip -n "$room" link set lan0 up && ip -n "$room" link set lo up &&
    ip -n "$ward" addr add 10.79.0.2/24 dev lan0 && ip -n "$ward" link set lan0 up && ip -n "$ward" link set lo up; } 2>/dev/null
}
in_room() { place=(ip netns exec "$room") network=(--profile lan --lan=10.79.0.1); }
in_ward() { place=(ip netns exec "$ward") network=(--profile lan --lan=10.79.0.2); }

holds() { until_is 60 "$1 holds the $2" "'$1, right' in now['parts']['$2'].get('holders', [])"; }

cut_off=yes
if open_network; then
  in_room
else
  cut_off=no
  echo "skipped: the observer with a lost connection (needs root, ip and network namespaces)"
fi
host "$scene" "$session"
say "One observer watches everything, one close up"
watch observer 7 --fps 6 --session-log "$out/log.jsonl" --summary "$out/observer.json"
clients=("${pids[-1]}")
watch close 8 --fps 2 --no-overlay --summary "$out/close.json"
clients+=("${pids[-1]}")
echo "look 0.12 1.25 0.36  -0.01 1 0.01" >&8
if [ $cut_off = yes ]; then
  in_ward
  watch unplugged 9 --fps 2 --summary "$out/unplugged.json"
  clients+=("${pids[-1]}")
  in_room
fi

say "Two headset users join through simulated trackers and gloves"
twins first. "$root/deploy/demo/cut_first.csv" "$root/deploy/demo/cut_first.csv" 2.8,4.2
twins second. "$root/deploy/demo/cut_second.csv" "$root/deploy/demo/cut_second.csv" 0.4,2.8,4.2,7.4,10
users

holds "first user" scalpel
go_on first
until_is 60 "the first user lifts the scalpel off the tray" "now['touches'].get('first user, right', {}).get('body') != 'tray'"
sleep 2
go_on second
holds "second user" knife
go_on second
sleep 2.5
moment before "One has taken the scalpel, one the knife"
go_on first
until_is 60 "the liver is cut" "now['parts']['liver']['revision'] > 3"
sleep 4
moment opened "The first user has opened the right lobe"
go_on second
sleep 4
moment during "The second user's knife is in the left lobe"
say "An observer joins"
watch latecomer 6 --fps 2 --summary "$out/latecomer.json"
clients+=("${pids[-1]}")
if [ $cut_off = yes ]; then
  say "One of the observers is disconnected from the network for 3 s while the knife keeps cutting"
  ip -n "$ward" link set lan0 down
fi
go_on second
if [ $cut_off = yes ]; then
  sleep 3
  ip -n "$ward" link set lan0 up
fi
until_is 60 "a piece of each lobe comes free" "{'liver piece 1', 'liver piece 2'} <= now['parts'].keys()"
sleep 3
moment through "The knife is through"
go_on second
sleep 4
moment after "The knife is out; what came free lies on the table"
echo "look 0.25 1.0 0.3  0 0.98 0.02" >&8
moment face "The cut's faces, from close by"
sleep 2

end
everyone_agrees
python3 - "$root/deploy" "$out" <<'PY'
import pathlib, sys
sys.path.insert(0, sys.argv[1])
from picture_files import below, beside, read_png, write_png
out = pathlib.Path(sys.argv[2])
picture = {name: read_png(out / f"{name}.png") for name in
           ("close-before", "close-opened", "close-during", "close-after", "close-face", "after")}
write_png(out / "cut-first.png", beside([picture["close-before"], picture["close-opened"]]))
write_png(out / "cut-liver.png", below([beside([picture["close-during"], picture["close-after"]]),
                                        beside([picture["close-face"], picture["after"]])]))
PY
echo "Pictures and log: $out"
