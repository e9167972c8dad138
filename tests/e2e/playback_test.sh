#!/usr/bin/env bash
# playback_test.sh BIN OUT: a headset user, through simulated devices, cuts a block, while the host's terminal stops time before the
# cut and after it. The recording is watched: at those ticks its pictures are those of the session, forwards, back and forwards
# again; every state hash is compared on the way. It runs at twice its pace, and the journal is not touched.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
bin=$1 out=$2
mkdir -p "$out"
out=$(cd "$out" && pwd)
rm -f "$out"/*
session=playback-$$
. "$here/../../deploy/demo_lib.sh"

watch() {  # NAME SESSION
  mkfifo "$out/$1.terminal"
  LP_NUM_THREADS=1 "$bin/prosector-client" observe --session "$2" --name "$1" --display offscreen --size 400x300 --no-overlay \
    --fps 8 --summary "$out/$1.json" <> "$out/$1.terminal" > "$out/$1.log" 2>&1 &
  pids+=("$!")
  watcher=$!
  wait_for "$out/$1.log" "everything is here" 60 "$1"
}
wait_picture() {  # FILE
  for _ in $(seq 100); do [ -s "$1" ] && sleep 0.3 && return; sleep 0.1; done
  fail "no picture $1" "$out/server.log"
}
moment() {  # NAME: stops time, and takes a picture
  echo stop > "$out/first.terminal"
  sleep 2
  echo "picture $out/$1.png" > "$out/observer.terminal"
  wait_picture "$out/$1.png"
  echo go > "$out/first.terminal"
}
go_to() {  # SECONDS PICTURE
  echo "seek $1" > "$out/viewer.terminal"
  sleep 4
  echo "picture $out/$2.png" > "$out/viewer.terminal"
  wait_picture "$out/$2.png"
}

host "$here/cut.toml" "$session"
watch observer "$session"
twins first. "$here/cut_first.csv" "$here/cut_first.csv"
mkfifo "$out/first.terminal"
"$bin/prosector-client" join --session "$session" --name first --host --config "$here/../../deploy/demo/headset.toml" \
  --tracker "fastrak:$out/first.tracker" --glove "5dt:$out/first.glove" --display none <> "$out/first.terminal" > "$out/first.log" 2>&1 &
pids+=("$!")
wait_for "$out/first.log" "tracker .*streaming" 20 "the tracker"
sleep 2
moment before
wait_for "$out/observer.log" "cut the block" 30 "the cut"
sleep 2
moment after
sleep 1
kill -TERM "$watcher" && wait "$watcher" || fail "the observer failed" "$out/observer.log"
kill -TERM "$server" && wait "$server" || fail "the server failed" "$out/server.log"
stop

cksum < "$out/journal.sqlite" > "$out/journal.was"
"$bin/prosector-server" --play "$out/journal.sqlite" --session "$session" > "$out/play.log" 2>&1 &
server=$!
pids+=("$server")
wait_for "$out/play.log" "observe:" 60 "the recording"
watch viewer "$session"
echo stop > "$out/viewer.terminal"
read -r before after < <(python3 "$here/check_playback.py" "$out" --stops)
go_to "$after" after_played
go_to "$before" before_played
go_to "$after" after_again
echo "seek 0" > "$out/viewer.terminal"
echo "fast 2" > "$out/viewer.terminal"
sleep 4
echo "undo" > "$out/viewer.terminal"
sleep 1
kill -TERM "$watcher" && wait "$watcher" || fail "the viewer failed" "$out/viewer.log"
kill -TERM "$server" && wait "$server" || fail "the player failed" "$out/play.log"
cksum < "$out/journal.sqlite" > "$out/journal.is"
python3 "$here/check_playback.py" "$out"
