#!/usr/bin/env bash
# Touch, shown: two headset users, through simulated trackers and gloves, grasp the liver together; one of them takes the
# kidney out by a button of its panel and makes it stiffer by the slider. An observer and an onlooker, who sees through
# the first user's eyes, take a picture of each moment. Leaves pictures, log.jsonl (what the observer knew) and figures.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
name=touch

usage() {
  cat <<TXT
deploy/demo_touch.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where pictures and figures go (default out/demo_touch)
  --scene FILE   scene to host (default deploy/scenes/touch.toml); liver and kidney where that one has them
  --size WxH     of the pictures (default 800x600)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN: folder of the programs; default build/release/bin)
It takes half a minute, on a busy machine longer.
TXT
}

. "$root/deploy/demo_session.sh"
begin "$@"
second_view=eyes

holders_are() { until_is 60 "who holds the liver: $1" "set(now['parts']['liver'].get('holders', [])) == set([$1])"; }
touches() { until_is 60 "$1 touches the $2" "now['touches']['$1, right']['body'] == '$2'"; }
kidney_panel() { until_is 60 "$1" "now['panels']['first user']['part'] == 'kidney' and $2"; }

host "$scene" "$session"
say "One observer watches, another follows the first user's view"
watch observer 7 --fps 6 --session-log "$out/log.jsonl"
clients=("${pids[-1]}")
watch onlooker 8 --fps 2 --follow "first user"
clients+=("${pids[-1]}")

say "Two headset users join through simulated trackers and gloves"
# Each waits where the other's doing, or the session's answer, has to come first: a busy machine only makes it longer.
twins first. "$root/deploy/demo/touch_first.csv" "$root/deploy/demo/touch_first.csv" 3.1,4,12,16.2,17.7,22.2
twins second. "$root/deploy/demo/touch_second.csv" "$root/deploy/demo/touch_second.csv" 5.4,8.1,9,14.2
users

touches "first user" liver
sleep 0.5  # it sinks in
go_on first
holders_are "'first user, right'"
go_on first
sleep 2
moment alone "The first user lifts the liver"
go_on second
touches "second user" liver
sleep 0.5
go_on second
holders_are "'first user, right', 'second user, right'"
go_on second
sleep 2
moment together "The second user holds it, too"
go_on first
holders_are "'second user, right'"
sleep 1
moment handed-over "The first user let go"
touches "first user" kidney
kidney_panel "the kidney's panel comes up" True
moment touch "The first user touches the kidney: its panel comes up"
go_on first
go_on second
holders_are ""
kidney_panel "the button is pressed home" "not now['parts']['kidney']['attached']"
moment button "A finger presses the button: the kidney is detached"
go_on first
kidney_panel "the slider is pushed" "now['panels']['first user']['controls']['stiffness']['position'] > 0.6"
moment slider "The finger pushes the slider"
go_on first
until_is 60 "the first user leaves the panel" \
  "'first user, right' not in now['touches'] and not now['panels']['first user']['controls']['stiffness']['touched']"
sleep 2
moment end "That's all"

end
echo "Pictures and log: $out"
