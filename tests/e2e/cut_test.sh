#!/usr/bin/env bash
# cut_test.sh BIN OUT: two users, through simulated trackers and gloves, cut a block; one of them takes a cut back, the
# other, who hosts, rewinds. An observer who watched all, one who comes between the cuts and both users end with the same hash of
# the topology, and the journal replays.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
bin=$1 out=$2
mkdir -p "$out"
out=$(cd "$out" && pwd)
rm -f "$out"/*
session=cut-$$
. "$here/../../deploy/demo_lib.sh"

watch() {  # NAME
  mkfifo "$out/$1.terminal"
  LP_NUM_THREADS=1 "$bin/prosector-client" observe --session "$session" --name "$1" --display offscreen --size 400x300 \
    --fps 4 --summary "$out/$1.json" <> "$out/$1.terminal" > "$out/$1.log" 2>&1 &
  pids+=("$!")
  clients+=("$!")
  wait_for "$out/$1.log" "everything is here" 60 "$1"
}

host "$here/cut.toml" "$session"
clients=()
watch observer
for user in first second; do
  role=()
  [ "$user" = second ] || role=(--host)
  twins "$user." "$here/cut_$user.csv" "$here/cut_$user.csv"
  mkfifo "$out/$user.terminal"
  "$bin/prosector-client" join --session "$session" --name "$user" "${role[@]}" --config "$here/../../deploy/demo/headset.toml" \
    --tracker "fastrak:$out/$user.tracker" --glove "5dt:$out/$user.glove" --display none --summary "$out/$user.json" \
    <> "$out/$user.terminal" > "$out/$user.log" 2>&1 &
  pids+=("$!")
  clients+=("$!")
done
for user in first second; do wait_for "$out/$user.log" "tracker .*streaming" 20 "the $user user's tracker"; done
sleep 7
watch latecomer
sleep 7
echo "picture $out/cut.png" > "$out/latecomer.terminal"
echo undo > "$out/second.terminal"
sleep 2
echo "rewind block 4" > "$out/second.terminal"
sleep 1
echo "rewind block 4" > "$out/first.terminal"
sleep 2
echo cuts > "$out/first.terminal"
sleep 1
for pid in "${clients[@]}"; do kill -TERM "$pid"; done
for pid in "${clients[@]}"; do wait "$pid" || fail "a client failed" "$out/observer.log"; done
kill -TERM "$server" && wait "$server" || fail "the server failed" "$out/server.log"
stop
"$bin/prosector-server" --replay "$out/journal.sqlite" > "$out/replay.log" 2>&1 || fail "the journal does not replay" "$out/replay.log"
python3 "$here/check_cut.py" "$out"
