#!/usr/bin/env bash
# build_example.sh PREFIX BUILD: builds the example below PREFIX with the Prosector there.
set -euo pipefail
cmake -S "$1/share/doc/libprosector-dev/example" -B "$2" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$1"
grep -q "^Prosector_DIR:PATH=$1/" "$2/CMakeCache.txt" || { echo "another Prosector was found"; exit 1; }
cmake --build "$2"
