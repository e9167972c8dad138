#!/usr/bin/env bash
# setup_test.sh OUT: what the set-up scripts say and do where a machine lacks rights, packages or a network. Commands that would
# change the machine or leave it are replaced by ones of our own.
set -euo pipefail
deploy=$(cd "$(dirname "$0")/../../deploy" && pwd)
out=$1
rm -rf "$out"
mkdir -p "$out/bin" "$out/home"

fake() {  # NAME SCRIPT
  printf '#!/bin/sh\n%s\n' "$2" >"$out/bin/$1"
  chmod +x "$out/bin/$1"
}
failed=0
# expect WHAT STATUS PATTERN LINES COMMAND...: exit status, a line that matches, and at most so many lines in all.
expect() {
  local what=$1 status=$2 pattern=$3 lines=$4 got=0 text
  shift 4
  text=$(env HOME="$out/home" PATH="$out/bin:$PATH" "$@" 2>&1) || got=$?
  if [ "$got" -eq "$status" ] && grep -qE -- "$pattern" <<<"$text" && [ "$(wc -l <<<"$text")" -le "$lines" ]; then
    echo "ok     $what: $(head -c 200 <<<"$text" | tr '\n' ' ')"
  else
    printf 'FAILED %s: exit %s (expected %s, /%s/, at most %s lines):\n%s\n' "$what" "$got" "$status" "$pattern" "$lines" "$text"
    failed=1
  fi
}

# Set-up: everything there; nothing there and no rights.
fake dpkg-query 'printf installed'
expect "nothing to install" 0 'all [0-9]+ packages are installed' 1 "$deploy/setup.sh"
fake dpkg-query 'exit 1'
fake id 'echo 1000'
fake sudo 'exit 1'
expect "sudo refuses" 1 'you may not use sudo; as root, run: apt-get update && apt-get install .* cmake ' 1 "$deploy/setup.sh"
fake sudo 'exec "$@"'
fake apt-get 'echo "E: no network" >&2; exit 100'
expect "no network at set-up" 1 'apt-get update failed; check the network' 3 "$deploy/setup.sh"
rm "$out/bin/sudo"
mkdir "$out/no-sudo"
for command in bash sed dpkg-query id dirname env; do
  [ -e "$out/bin/$command" ] && cp "$out/bin/$command" "$out/no-sudo/" || ln -s "$(command -v "$command")" "$out/no-sudo/"
done
expect "no root, no sudo" 1 'neither root nor have sudo; as root, run: apt-get update && apt-get install' 1 \
  env PATH="$out/no-sudo" "$deploy/setup.sh"
rm "$out/bin/id" "$out/bin/dpkg-query"

# Anatomy: no network, a package with other content, a folder that can't be written, all there.
expect "no network for anatomy" 0 "can't download libcgal-demo \(E: no network\); scenes use implicit shapes" 2 \
  "$deploy/fetch_anatomy.sh"
fake apt-get 'for last; do :; done; echo nonsense > "${last}_1_all.deb"'
expect "damaged packages" 0 "can't unpack mricron-data .*; scenes use implicit shapes" 6 "$deploy/fetch_anatomy.sh"
fake dpkg 'mkdir -p "$3/usr/share/mricron/templates"; for file in ch2bet aal; do echo other > "$3/usr/share/mricron/templates/$file.nii.gz"; done'
expect "other files than expected" 0 'brain.nii.gz of mricron-data is not the one expected; scenes use implicit shapes' 7 \
  "$deploy/fetch_anatomy.sh"
expect "a data folder that is none" 0 "can't write /proc/nowhere; scenes use implicit shapes" 1 \
  env PROSECTOR_DATA=/proc/nowhere "$deploy/fetch_anatomy.sh"

# Networks: no network, a package with other content, a folder that can't be written, no npm.
fake npm 'echo "npm error: no network" >&2; exit 1'
expect "no network for models" 0 "npm can't fetch @mediapipe/hands \(npm error: no network\); they are needed to track bare hands" 2 \
  "$deploy/fetch_models.sh"
fake npm 'echo nonsense > package.tgz'
expect "damaged packages of models" 0 "can't unpack @mediapipe/face_detection .*; they are needed to track bare hands" 4 "$deploy/fetch_models.sh"
fake npm 'mkdir package; echo other > package/face_detection_short_range.tflite; for file in full lite; do echo other > package/hand_landmark_$file.tflite; done
echo other > package/hands_solution_packed_assets.data; tar -czf package.tgz package'
expect "other models than expected" 0 'palm_full.tflite of @mediapipe/hands is not the one expected' 7 "$deploy/fetch_models.sh"
expect "no folder for models" 0 "can't write /proc/nowhere/models; they are needed to track bare hands" 1 \
  env PROSECTOR_DATA=/proc/nowhere "$deploy/fetch_models.sh"
rmdir "$out/home/.local/share/prosector/models"
[ -z "$(ls "$out/home/.local/share/prosector")" ] || { echo "FAILED bad files were kept"; failed=1; }
exit $failed
