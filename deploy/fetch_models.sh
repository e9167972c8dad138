#!/usr/bin/env bash
# Takes networks that find hands and faces in pictures out of packages of the npm registry that npm is configured
# with, into Prosector's data folder, below models/:
#   @mediapipe/hands: palm_full.tflite, palm_lite.tflite, hand_landmark_full.tflite, hand_landmark_lite.tflite
#   @mediapipe/face_detection: face_short_range.tflite
# Nothing is installed and no script of a package is run. When something fails it says so in one line and
# succeeds: cameras then give no hands and no faces.
set -uo pipefail

data=${PROSECTOR_DATA:-${XDG_DATA_HOME:-$HOME/.local/share}/prosector}/models
files=(  # package, sha256, file
  "hands 2f25e740121983f68ffc05f99991d524dc0ea812134f6316a26125816941ee85 palm_full.tflite"
  "hands e9a4aaddf90dda56a87235303cf00e4c2d3fb28725f68fd88772997dac905c18 palm_lite.tflite"
  "hands 8c026882c9ec059ce0f8e75266bee5a9a23c341a40e0000df755374d3d1b9b68 hand_landmark_full.tflite"
  "hands d7fde8ac11f8ce03f8663775bfc323f4fc9f2a38062b4f4efa142874ef5b2a48 hand_landmark_lite.tflite"
  "face_detection 3bc182eb9f33925d9e58b5c8d59308a760f4adea8f282370e428c51212c26633 face_short_range.tflite"
)
packages=(  # package, version, megabytes
  "hands 0.4.1675469240 13"
  "face_detection 0.4.1657300184 5"
)

# cut_bytes FILE FROM TO OUT: the bytes [FROM, TO) of a file.
cut_bytes() { head -c "$3" "$1" | tail -c $(($3 - $2)) >"$4"; }

# take PACKAGE TREE OUT: our files of an unpacked package.
take() {
  local from=$2/package
  case $1 in
    hands)
      cut_bytes "$from/hands_solution_packed_assets.data" 11 2341291 "$3/palm_full.tflite" &&
        cut_bytes "$from/hands_solution_packed_assets.data" 2341291 4326731 "$3/palm_lite.tflite" &&
        cp "$from/hand_landmark_full.tflite" "$from/hand_landmark_lite.tflite" "$3/"
      ;;
    face_detection) cp "$from/face_detection_short_range.tflite" "$3/face_short_range.tflite" ;;
  esac
}

lack() { echo "models: $1; they are needed to track bare hands and faces with cameras (run deploy/fetch_models.sh again to retry)"; }
give_up() {
  lack "$1"
  exit 0
}

is_good() { [ -f "$2" ] && echo "$1  $2" | sha256sum --check --status 2>/dev/null; }

# missing_of PACKAGE: its files that the data folder lacks.
missing_of() {
  local entry package hash file
  for entry in "${files[@]}"; do
    read -r package hash file <<<"$entry"
    [ "$package" = "$1" ] && ! is_good "$hash" "$data/$file" && echo "$hash $file"
  done
}

# fetch PACKAGE VERSION MEGABYTES: without the package we give up, without some of its files only those are lacking.
fetch() {
  local hash file tree=$work/tree-$1 out=$work/out-$1 missing
  missing=$(missing_of "$1")
  [ -n "$missing" ] || return 0
  echo "models: fetching @mediapipe/$1 $2 ($3 MB)"
  mkdir -p "$tree" "$out"
  (cd "$tree" && npm pack --ignore-scripts --silent "@mediapipe/$1@$2") >"$work/log" 2>&1 ||
    give_up "npm can't fetch @mediapipe/$1 ($(tail -n 1 "$work/log"))"
  if ! { tar -xzf "$tree"/*.tgz -C "$tree" && take "$1" "$tree" "$out"; } 2>"$work/log"; then
    lack "can't unpack @mediapipe/$1 ($(tail -n 1 "$work/log"))"
    return
  fi
  while read -r hash file; do
    if ! is_good "$hash" "$out/$file"; then
      lack "$file of @mediapipe/$1 is not the one expected"
      continue
    fi
    cp "$out/$file" "$data/.$file.part" && mv "$data/.$file.part" "$data/$file" || give_up "can't write $data/$file"
    echo "models: $data/$file"
  done <<<"$missing"
}

mkdir -p "$data" 2>/dev/null && [ -w "$data" ] || give_up "can't write $data"
work=$(mktemp -d) || give_up "no temporary folder"
trap 'rm -rf "$work"' EXIT
for entry in "${packages[@]}"; do
  read -r package version megabytes <<<"$entry"
  [ -z "$(missing_of "$package")" ] || command -v npm >/dev/null || give_up "there is no npm to fetch them with"
  fetch "$package" "$version" "$megabytes"
done
for entry in "${packages[@]}"; do
  [ -z "$(missing_of "${entry%% *}")" ] || exit 0
done
echo "models: all ${#files[@]} files are in $data"
