#!/usr/bin/env bash
# test_monado.sh BIN [SOURCE]: a session with a headset through a real OpenXR runtime, Monado. It is taken where it is installed, else built
# from the folder SOURCE: in the program's own process, with its null compositor and its simulated headset. Without either: SKIPPED. For
# people, and not run yet; the gate tests with a runtime of our own (tests/e2e/openxr_test.py).
set -euo pipefail
bin=$(realpath "$1")
source=${2:-}
deploy=$(cd "$(dirname "$0")" && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

manifest=${XR_RUNTIME_JSON:-}
for file in /usr/share/openxr/1/openxr_monado.json /usr/local/share/openxr/1/openxr_monado.json; do
  [ -n "$manifest" ] || [ ! -e "$file" ] || manifest=$file
done
if [ -z "$manifest" ] && [ -n "$source" ]; then
  cmake -S "$source" -B "$out/monado" -G Ninja -DCMAKE_BUILD_TYPE=Release -DXRT_FEATURE_SERVICE=OFF \
    -DXRT_BUILD_DRIVER_SIMULATED=ON -DBUILD_TESTING=OFF
  ninja -C "$out/monado"
  manifest=$(find "$out/monado" -name 'openxr_monado*.json' | head -1)
fi
if [ -z "$manifest" ]; then
  echo "SKIPPED: Monado is not installed, and no folder of its source is given"
  exit 77
fi

session=monado$$
"$bin/prosector-server" "$deploy/scenes/minimal.toml" --session "$session" > "$out/server" &
server=$!
trap 'kill $server 2> /dev/null; rm -rf "$out"' EXIT
sleep 3
XR_RUNTIME_JSON=$manifest XRT_COMPOSITOR_NULL=1 SIMULATED_ENABLE=1 "$bin/prosector-client" join --name Wearer --display openxr \
  --session "$session" --seconds 8 --session-log "$out/log" --screenshot "$out/eyes.png" | tee "$out/said"
grep -q '^headset: ' "$out/said"
/usr/bin/python3 - "$out" <<'END'
import json, pathlib, sys
from PIL import Image, ImageChops
out = pathlib.Path(sys.argv[1])
both = Image.open(out / "eyes.png").convert("L")
eyes = [both.crop((side * both.width // 2, 0, (side + 1) * both.width // 2, both.height)) for side in (0, 1)]
for name, eye in zip(("left", "right"), eyes):
    mean = sum(eye.getdata()) / (eye.width * eye.height)
    print(f"{name} eye: {eye.width} x {eye.height}, brightness {mean:.1f}")
    assert mean > 10, "black"
assert ImageChops.difference(*eyes).getbbox(), "both eyes see the same"
lines = [json.loads(line) for line in open(out / "log")]
assert any("eyes" in line["people"].get("Wearer", {}) for line in lines), "no head arrived"
END
echo "a session through $manifest went well"
