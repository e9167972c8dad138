#!/usr/bin/env bash
# vanished_interface_test.sh lan|wan BIN OUT: a server and an observer in two network namespaces lose the interface between
# them; told to end (SIGTERM) after that, both must do so within 5 s. Exits 77 (skipped) where namespaces can't be made.
set -u
here=$(cd "$(dirname "$0")" && pwd)
profile=$1 bin=$2 out=$3/$1
limit_s=5
server_side=pvs$$ observer_side=pvo$$
pids=()
mkdir -p "$out"
rm -f "$out"/*.log

clean_up() {
  for pid in "${pids[@]}"; do kill -KILL "$pid" 2>/dev/null; done
  wait
  ip netns del $server_side 2>/dev/null
  ip netns del $observer_side 2>/dev/null
}
trap clean_up EXIT
trap 'exit 130' INT TERM

skip() { echo "skipped: $1"; exit 77; }
fail() { echo "FAILED: $1"; cat "$out"/*.log; exit 1; }
[ "$(id -u)" = 0 ] || skip "needs root"
command -v ip >/dev/null || skip "needs the ip command (package iproute2)"
ip netns add $server_side 2>/dev/null && ip netns add $observer_side 2>/dev/null || skip "network namespaces can't be made here"
ip link add lan0 netns $server_side type veth peer name lan0 netns $observer_side 2>/dev/null || skip "veth can't be made here"
ip -n $server_side addr add 10.78.0.1/24 dev lan0 && ip -n $server_side link set lan0 up || fail "no address"
ip -n $observer_side addr add 10.78.0.2/24 dev lan0 && ip -n $observer_side link set lan0 up || fail "no address"
ip -n $server_side link set lo up
ip -n $observer_side link set lo up

wait_for() {  # LOG PATTERN
  for _ in $(seq 600); do
    grep -q -- "$2" "$out/$1.log" 2>/dev/null && return
    sleep 0.1
  done
  fail "the $1 did not say \"$2\""
}
ends() {  # WHO PID: told to end, does within the limit, with exit status 0
  kill -TERM "$2"
  for _ in $(seq $((limit_s * 20))); do
    if ! kill -0 "$2" 2>/dev/null; then
      wait "$2" || fail "the $1 ended with status $?"
      echo "the $1 ended"
      return
    fi
    sleep 0.05
  done
  fail "the $1 still runs $limit_s s after SIGTERM"
}

ip netns exec $server_side "$bin/prosector-server" "$here/../../deploy/scenes/minimal.toml" --session vanish \
  --profile "$profile" --lan=10.78.0.1 > "$out/server.log" 2>&1 &
server=$!
pids+=($server)
wait_for server "is open on the network"
ip netns exec $observer_side "$bin/prosector-client" observe --session vanish --name watcher --profile "$profile" \
  --lan=10.78.0.2 --peer 10.78.0.1 --timeout 30 --display none > "$out/observer.log" 2>&1 &
observer=$!
pids+=($observer)
wait_for observer "everything is here"
ip -n $server_side link del lan0
sleep 0.3
ends observer $observer
ends server $server
