#!/usr/bin/env bash
# cut_liver_test.sh BIN OUT: runs the scripted session in which two users cut the CT liver, one observer comes in the middle of a
# cut and one is cut off the network for 3 s; then checks what each of them knew.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
PROSECTOR_BIN=$1 "$here/../../deploy/demo_cut.sh" --skip-setup --size 400x300 --out "$2"
python3 "$here/check_cut_liver.py" "$2"
