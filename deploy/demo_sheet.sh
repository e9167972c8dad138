#!/usr/bin/env bash
# Sheets that are cut, shown: two headset users, through simulated trackers and gloves, cut a flap out of a skin and a drape's
# hem. An observer joins after the cuts, and shows them; docs/pictures/cut-sheet.png is that picture. In the end all hold one
# topology, by its hash. Leaves pictures, log.jsonl (what the first observer knew), everyone's figures and the journal.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
name=sheet

usage() {
  cat <<TXT
deploy/demo_sheet.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where pictures and figures go (default out/demo_sheet)
  --scene FILE   scene to host (default deploy/scenes/sheet_cut.toml); skin, drape, scalpel and beam where that one has them
  --size WxH     of the pictures (default 800x600)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN: folder of the programs; default build/release/bin)
It takes half a minute, on a busy machine longer.
TXT
}

. "$root/deploy/demo_session.sh"
begin --scene "$root/deploy/scenes/sheet_cut.toml" "$@"
second_view=late

host "$scene" "$session"
say "One observer watches everything"
watch observer 7 --fps 2 --session-log "$out/log.jsonl" --summary "$out/observer.json"
clients=("${pids[-1]}")

say "Two headset users join through simulated trackers and gloves"
twins first. "$root/deploy/demo/sheet_first.csv" "$root/deploy/demo/sheet_first.csv" 2.8,4.2
twins second. "$root/deploy/demo/sheet_second.csv" "$root/deploy/demo/sheet_second.csv" 2.8,4.2
users
for who in "first scalpel" "second beam"; do
  set -- $who
  until_is 60 "the $1 user holds the $2" "'$1 user, right' in now['parts']['$2'].get('holders', [])"
done
go_on first
go_on second
sleep 3
say "One cuts the skin, one the drape"
go_on first
go_on second
until_is 60 "the skin is cut" "now['parts']['skin']['revision'] > 5"
until_is 60 "the drape is cut" "now['parts']['drape']['revision'] > 0"
sleep 12
say "An observer joins"
watch late 8 --fps 2 --summary "$out/late.json"
clients+=("${pids[-1]}")
sleep 3
moment cut "What is cut lies and hangs still"

end
everyone_agrees
echo "Pictures and log: $out"
