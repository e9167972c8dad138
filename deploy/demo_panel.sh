#!/usr/bin/env bash
# A panel, shown: a headset user, through a simulated tracker and glove, touches the liver, presses the light shaft's button
# and pushes the slider. An observer, who also sees what bodies collide as, and an onlooker, who sees through the user's
# eyes, take a picture of it. docs/pictures/panel*.png are made of them.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
name=panel

usage() {
  cat <<TXT
deploy/demo_panel.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where pictures and figures go (default out/demo_panel)
  --scene FILE   scene to host (default deploy/scenes/touch.toml); liver and kidney where that one has them
  --size WxH     of the pictures (default 800x600)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN: folder of the programs; default build/release/bin)
It takes half a minute, on a busy machine longer.
TXT
}

. "$root/deploy/demo_session.sh"
begin --scene "$root/deploy/scenes/touch.toml" "$@"
second_view=eyes

panel_is() { until_is 60 "$1" "now['panels']['first user']['part'] == 'liver' and $2"; }

host "$scene" "$session"
watch observer 7 --fps 6 --wireframes --session-log "$out/log.jsonl"
clients=("${pids[-1]}")
watch onlooker 8 --fps 2 --follow "first user"
clients+=("${pids[-1]}")
twins first. "$root/deploy/demo/panel_hand.csv" "$root/deploy/demo/panel_glove.csv" 6.5,10.2,13.7
users first
panel_is "the liver's panel comes up" True
moment touch "The user touches the liver: its panel comes up"
go_on first
panel_is "the light shaft is on" "now['panels']['first user']['controls']['light shaft']['on']"
moment button "A finger presses the light shaft's button"
go_on first
panel_is "the slider is pushed" "now['panels']['first user']['controls']['stiffness']['position'] > 0.6"
moment slider "The finger pushes the slider"
go_on first
end
echo "Pictures and log: $out"
