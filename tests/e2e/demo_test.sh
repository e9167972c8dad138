#!/usr/bin/env bash
# demo_test.sh BIN OUT: runs the demo headless and checks what it promises (not how fast this machine is).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
PROSECTOR_BIN=$1 "$here/../../deploy/demo.sh" --headless --skip-setup --no-film --seconds 20 --out "$2"
python3 "$here/check_demo.py" "$2"
