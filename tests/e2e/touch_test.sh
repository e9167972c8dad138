#!/usr/bin/env bash
# touch_test.sh BIN OUT: runs the scripted session of two users without fetched anatomy, and checks what its observer knew.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
PROSECTOR_BIN=$1 "$here/../../deploy/demo_touch.sh" --skip-setup --scene "$here/touch.toml" --size 400x300 --out "$2"
python3 "$here/check_touch.py" "$2"
