# What the demos of two scripted users share. begin "$@" first, in a script that has set `root` and `name` and has usage().

# begin OPTIONS...: options, set-up, a clean folder; sets out, scene, size, bin, session.
begin() {
  local setup=yes
  out=$root/out/demo_$name scene=$root/deploy/scenes/$name.toml size=800x600
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
  session=$name-$$
  . "$root/deploy/demo_lib.sh"
}

# watch NAME FD OPTIONS: somebody who watches, offscreen or on `display`, and whose terminal we type at through descriptor FD.
watch() {
  local name=$1 fd=$2
  shift 2
  mkfifo "$out/$name.terminal"
  LP_NUM_THREADS=1 "${place[@]}" "$bin/prosector-client" observe --session "$session" --name "$name" "${network[@]}" \
    --display "${display:-offscreen}" --size "$size" "$@" < "$out/$name.terminal" > "$out/$name.log" 2>&1 &
  pids+=("$!")
  eval "exec $fd> \"\$out/\$name.terminal\""
  wait_for "$out/$name.log" "everything is here" 60 "the $name"
}

# until_is SECONDS WHAT PYTHON: waits until the observer knows what PYTHON says of `now`, the newest line of its log.
until_is() {
  python3 - "$out/log.jsonl" "$1" "$3" <<'PY' || fail "$2: not within $1 s" "$out/log.jsonl"
import json, sys, time
file, seconds, holds = sys.argv[1], float(sys.argv[2]), compile(sys.argv[3], "condition", "eval")
end = time.monotonic() + seconds
while time.monotonic() < end:
    lines = open(file).read().split("\n")[:-1]
    try:
        if lines and eval(holds, {"now": json.loads(lines[-1])}):
            sys.exit(0)
    except KeyError:
        pass
    time.sleep(0.05)
sys.exit(1)
PY
}

# go_on USER: lets the user's script pass its next hold.
go_on() {
  echo > "$out/$1.tracker.terminal"
  echo > "$out/$1.glove.terminal"
}

# moment NAME WHAT: has both who watch, at descriptors 7 and 8, take a picture; the second one's is called after `second_view`.
moment() {
  say "$2"
  echo "picture $out/$1.png" >&7
  echo "picture $out/$second_view-$1.png" >&8
  local waited=0
  until [ -s "$out/$1.png" ] && [ -s "$out/$second_view-$1.png" ]; do
    [ "$waited" -lt 200 ] || fail "no screenshot of \"$2\" within 20 s" "$out/observer.log"
    sleep 0.1
    waited=$((waited + 1))
  done
}

# users [NAME...]: these, or the first and the second, join through their simulated devices; adds them to `clients`.
users() {
  local user names=("$@")
  [ $# -gt 0 ] || names=(first second)
  for user in "${names[@]}"; do
    "${place[@]}" "$bin/prosector-client" join --session "$session" --name "$user user" "${network[@]}" \
      --config "$root/deploy/demo/headset.toml" --tracker "fastrak:$out/$user.tracker" --glove "5dt:$out/$user.glove" \
      --display none --summary "$out/$user.json" < /dev/null > "$out/$user.log" 2>&1 &
    pids+=("$!")
    clients+=("$!")
  done
  for user in "${names[@]}"; do wait_for "$out/$user.log" "tracker .*streaming" 20 "the $user user's tracker"; done
}

# end: everyone leaves, the server last.
end() {
  local pid
  for pid in "${clients[@]}"; do kill -TERM "$pid"; done
  for pid in "${clients[@]}"; do wait "$pid" || fail "a client failed" "$out/observer.log"; done
  kill -TERM "$server" && wait "$server" || fail "the server failed" "$out/server.log"
  stop
  rm -f "$out"/*.terminal
}
