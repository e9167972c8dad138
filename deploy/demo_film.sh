#!/usr/bin/env bash
# A film of 20 s of a session: names of the organs, a press and the panel that comes up, a second person, a cut. Two headset
# users, through simulated trackers and gloves, work on the abdomen; an observer who stands close by records.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
name=film

usage() {
  cat <<TXT
deploy/demo_film.sh [--out DIR] [--scene FILE] [--size WxH] [--skip-setup]
  --out DIR      where the film, pictures and figures go (default out/demo_film)
  --scene FILE   scene to host (default deploy/scenes/abdomen.toml); a liver and a scalpel where that one has them
  --size WxH     of the film (default 960x540)
  --skip-setup   don't install, fetch and build first (PROSECTOR_BIN: folder of the programs; default build/release/bin)
It takes half a minute, on a busy machine longer. docs/pictures/film.png is the picture cut.png that it leaves, and film.webp is made of
its film by deploy/animated_picture.py OUT/film.avi docs/pictures/film.webp 640 360 6.
TXT
}

. "$root/deploy/demo_session.sh"
case " $* " in *" --scene "*) ;; *) set -- --scene "$root/deploy/scenes/abdomen.toml" "$@" ;; esac
begin --size 960x540 "$@"
rm -f "$out/film.avi"

# where_from EYE TARGET: the observer steps there.
where_from() { echo "look $1  $2" >&7; }

# Watched from close by, from the side where nobody's arm is before the organs.
sed -e 's/^eye = .*/eye = [-0.33, 1.23, 0.35]/' -e 's/^target = .*/target = [0.01, 1.03, 0.02]/' "$scene" > "$out/scene.toml"
cp "$(dirname "$scene")/labels.csv" "$out/labels.csv"
host "$out/scene.toml" "$session"
say "Two headset users join through simulated trackers and gloves"
clients=()
twins first. "$root/deploy/demo/film_first.csv" "$root/deploy/demo/film_first.csv" 0.9,9.2
twins second. "$root/deploy/demo/film_second.csv" "$root/deploy/demo/film_second.csv" 0.5
users

say "An observer moves close and records"
watch observer 7 --fps 12 --record "$out/film.avi" --session-log "$out/log.jsonl" --summary "$out/observer.json"
clients+=("${pids[-1]}")
echo "labels" >&7
sleep 2.5
echo "labels" >&7
go_on first
go_on second
until_is 60 "the first user touches the liver" "now['touches'].get('first user, right', {}).get('body') == 'liver'"
sleep 1
echo "picture $out/press.png" >&7
sleep 1.5
until_is 60 "the first user holds the scalpel" "'first user, right' in now['parts']['scalpel'].get('holders', [])"
where_from "-0.24 1.24 0.30" "-0.02 1.04 0.01"
go_on first
until_is 60 "the liver is cut" "now['parts']['liver']['revision'] > 3"
sleep 2
echo "picture $out/cut.png" >&7
sleep 5
end
echo "Film, pictures and log: $out"
