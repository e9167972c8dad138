#!/usr/bin/env bash
# Sessions with a headset through a real OpenXR runtime, Monado: tests/e2e/monado_test.py says what happens in them. Test only.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() {
  cat <<TXT
deploy/test_monado.sh BIN [--source FOLDER | --clone] [--out FOLDER]
  BIN              the folder with prosector-client and prosector-server
  --source FOLDER  builds Monado from this source (default: the environment's PROSECTOR_MONADO)
  --clone          fetches that source from $url
  --out FOLDER     what is fetched, built and seen (default out/monado)
Without source: Monado as it is installed. SKIPPED (77) where there is none.
TXT
}
url=https://gitlab.freedesktop.org/monado/monado.git
refuse() { echo "test_monado: $1" >&2; usage >&2; exit 2; }
skip() { echo "SKIPPED: $1"; exit 77; }

bin='' source=${PROSECTOR_MONADO:-} clone=no out=out/monado
while [ $# -gt 0 ]; do
  case "$1" in
    --source) source=${2:?--source needs a folder}; shift ;;
    --out) out=${2:?--out needs a folder}; shift ;;
    --clone) clone=yes ;;
    -h | --help) usage; exit 0 ;;
    -*) refuse "$1 is no option" ;;
    *) [ -z "$bin" ] || refuse "$1: BIN is $bin already"; bin=$1 ;;
  esac
  shift
done
[ -x "$bin/prosector-client" ] || refuse "${bin:-BIN}: there is no prosector-client"
mkdir -p "$out"
out=$(realpath "$out")

if [ $clone = yes ]; then
  source=$out/source
  [ -e "$source" ] || git clone --depth 1 "$url" "$source"
fi

# Builds the runtime and its service: no devices but the simulated ones.
build() {
  local missing=() package drivers
  for package in glslang-tools libeigen3-dev libegl-dev libgl-dev libudev-dev libusb-1.0-0-dev libvulkan-dev libx11-xcb-dev libxcb-randr0-dev \
    libxrandr-dev mesa-vulkan-drivers; do
    dpkg -s "$package" > /dev/null 2>&1 || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] || skip "Monado's build needs packages: apt-get install ${missing[*]}"
  mapfile -t drivers < <(grep -oE 'XRT_BUILD_DRIVER_[A-Z0-9_]+' "$source/CMakeLists.txt" | sort -u | grep -vE '_(SIMULATED|REMOTE)$' |
    sed 's/.*/-D&=OFF/')
  cmake -S "$source" -B "$out/build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${drivers[@]}" -DXRT_BUILD_DRIVER_SIMULATED=ON \
    -DXRT_BUILD_DRIVER_REMOTE=ON -DXRT_FEATURE_STEAMVR_PLUGIN=OFF -DXRT_FEATURE_SLAM=OFF -DBUILD_TESTING=OFF > "$out/build.log"
  nice -n 5 ninja -C "$out/build" -j2 >> "$out/build.log" || { tail -20 "$out/build.log"; exit 1; }
  manifest=$out/build/openxr_monado-dev.json
  service=$out/build/src/xrt/targets/service/monado-service
}

manifest=${XR_RUNTIME_JSON:-} service=''
if [ -n "$source" ]; then
  [ -e "$source/CMakeLists.txt" ] || refuse "$source: this is no source of Monado"
  build
else
  for file in /usr/share/openxr/1/openxr_monado.json /usr/local/share/openxr/1/openxr_monado.json; do
    [ -n "$manifest" ] || [ ! -e "$file" ] || manifest=$file
  done
  service=$(command -v monado-service || true)
fi
[ -n "$manifest" ] || skip "Monado is not installed, and no source of it is given (--source, --clone)"
tests/e2e/monado_test.py "$bin" "$out/seen" "$manifest" ${service:+"$service"}
