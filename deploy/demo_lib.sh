# What the demos share. Sourced by them, after `out`, the folder for what they leave, and `bin` are set.

# Everything that we start ends with us, by its own process id.
pids=()
# Where programs run and how they find each other: a command before theirs, and options of theirs.
place=() network=()
stop() {
  local pid
  for pid in "${pids[@]}"; do kill -TERM "$pid" 2>/dev/null || true; done
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null || true; done
  pids=()
}
trap stop EXIT
trap 'exit 130' INT TERM

say() { printf '\n== %s\n' "$*"; }
fail() {
  echo "demo: $1; see $2:" >&2
  tail -n 5 "$2" >&2
  exit 1
}
wait_for() {  # FILE PATTERN SECONDS WHAT
  local waited=0
  until grep -q -- "$2" "$1" 2>/dev/null; do
    [ "$waited" -lt "$(($3 * 10))" ] || fail "$4 did not start within $3 s" "$1"
    sleep 0.1
    waited=$((waited + 1))
  done
}

# host SCENE SESSION: starts the server and waits for it; sets `server`.
host() {
  say "Hosting $(basename "$1") as session $2"
  "${place[@]}" "$bin/prosector-server" "$1" --session "$2" "${network[@]}" --journal "$out/journal.sqlite" \
    --summary "$out/server.json" \
    > "$out/server.log" 2>&1 &
  server=$!
  pids+=("$server")
  wait_for "$out/server.log" "participate:" 180 "the server"
  grep -E "bodies|session|fem_" "$out/server.log" | head -n 12 || true
}

# twins PREFIX HAND_SCRIPT GLOVE_SCRIPT [HOLDS]: a simulated tracker and glove at $out/PREFIXtracker and $out/PREFIXglove.
# With HOLDS (script times), each waits there for a line through its terminal, $out/PREFIXDEVICE.terminal.
twins() {
  local device hold=(--wait-client)
  [ $# -lt 4 ] || hold+=(--hold "$4")
  for device in tracker glove; do
    rm -f "$out/$1$device.terminal"
    mkfifo "$out/$1$device.terminal"
  done
  "$bin/prosector-fastrak-twin" --script "$2" "${hold[@]}" --link "$out/$1tracker" \
    --room-device 0,1,1,1,0,0,0 --log "$out/$1tracker.csv" --noise-cm 0.02 --seed 1 \
    <> "$out/$1tracker.terminal" > "$out/$1tracker.log" 2>&1 &
  pids+=("$!")
  "$bin/prosector-5dt-twin" --script "$3" "${hold[@]}" --link "$out/$1glove" \
    --log "$out/$1glove.csv" --seed 2 <> "$out/$1glove.terminal" > "$out/$1glove.log" 2>&1 &
  pids+=("$!")
  local link
  for link in "$1tracker" "$1glove"; do
    for _ in $(seq 50); do [ -e "$out/$link" ] && break; sleep 0.1; done
    [ -e "$out/$link" ] || fail "the simulated $link did not start" "$out/$link.log"
  done
}

# everyone_agrees: says what topology each process in $out held in the end; fails where they differ.
everyone_agrees() {
  say "Final topology of all processes"
  python3 - "$out" <<'PY'
import glob, json, os, sys
hashes = {}
for file in sorted(glob.glob(sys.argv[1] + "/*.json")):
    figures = json.load(open(file))
    if "topology_hash" in figures:
        hashes[os.path.basename(file)[:-5]] = figures["topology_hash"]
for name, said in hashes.items():
    print(f"{name:10} {said}")
sys.exit(0 if len(set(hashes.values())) == 1 else "demo: they don't agree")
PY
}
