#!/usr/bin/env bash
# network_test.sh lan|wan BIN OUT: the real server and a late observer in two network namespaces; wan goes through a bridge with
# 20 ms delay, 5 ms jitter, 1 % loss and 50 Mbit/s. The server names no interface: its namespace has one. Exits 77 (skipped) where namespaces can't be made.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
kind=$1 bin=$2 out=$3
mkdir -p "$out"
rm -f "$out/$kind.json"
peer=
[ "$kind" = lan ] || peer="--peer %S"
status=0
"$here/../idl/namespaces" "$kind" "$bin/wan_bridge" \
  "$bin/prosector-server $here/../../deploy/scenes/minimal.toml --session net --profile $kind --lan --seconds 60" \
  "$bin/prosector-client observe --session net --profile $kind --lan=%I $peer --display none --seconds 4 --timeout 40 --summary $out/$kind.json" \
  > "$out/$kind.log" 2>&1 || status=$?
cat "$out/$kind.log"
[ $status = 0 ] || exit $status
python3 - "$out/$kind.json" <<'PY'
import json, sys
figures = json.load(open(sys.argv[1]))
print("late join", figures["late_join_ms"], "ms")
assert figures["late_join_ms"] is not None and figures["invalid_dropped"] == 0 and figures["contradictions"] == 0, figures
PY
