#!/usr/bin/env bash
# Takes real anatomy out of Debian's own packages into Prosector's data folder:
#   libcgal-demo: liver.inr.gz (labelled abdominal CT), femur.off, bones.off (foot)
#   invesalius-examples: head.nii (CT of a head)
#   mricron-data: brain.nii.gz (MRI of a brain), aal.nii.gz (its regions: the AAL atlas)
# Nothing is installed. When something fails it says so in one line and succeeds: scenes then fall back to
# implicit shapes.
set -uo pipefail
deploy=$(cd "$(dirname "$0")" && pwd)

data=${PROSECTOR_DATA:-${XDG_DATA_HOME:-$HOME/.local/share}/prosector}
files=(  # package, sha256, file
  "libcgal-demo 8d585a21aaaa34ab62219fa3606541b73de22e25211f78180c625df341cc1991 liver.inr.gz"
  "libcgal-demo 75d208fabf7a7b134cfcf2171bad68c331e3bff55309ffe38a01a7b31352fbc6 femur.off"
  "libcgal-demo 004bd26f0029910eb2e2fd38b7ca11ea05dd4182e247c0fb778533b860dd7ab2 bones.off"
  "invesalius-examples 74ae85e6206a02d281ac6124e4ad01ca239dd41b661d4c0224655dc1f9a3bf34 head.nii"
  "mricron-data 592a2d20abdf36eefcb540ca8958428040edffc1bc1a18ba1dcfbabac77c5dd1 brain.nii.gz"
  "mricron-data b512dcd3f36b77f56be7a9a038134096e66314b7e8c31d25875b96bcf6991454 aal.nii.gz"
)
packages=(  # package, megabytes
  "libcgal-demo 24"
  "invesalius-examples 19"
  "mricron-data 16"
)

# take PACKAGE TREE OUT: our files of an unpacked package.
take() {
  case $1 in
    libcgal-demo)
      tar -xzf "$2/usr/share/doc/libcgal-dev/data.tar.gz" -C "$3" --strip-components=2 \
        data/images/liver.inr.gz data/meshes/femur.off data/meshes/bones.off
      ;;
    invesalius-examples)
      python3 "$deploy/inv3_to_nifti.py" "$2/usr/share/doc/invesalius-examples/examples/Cranium.inv3" "$3/head.nii"
      ;;
    mricron-data)
      cp "$2/usr/share/mricron/templates/ch2bet.nii.gz" "$3/brain.nii.gz" && cp "$2/usr/share/mricron/templates/aal.nii.gz" "$3/"
      ;;
  esac
}

lack() { echo "anatomy: $1; scenes use implicit shapes instead (run deploy/fetch_anatomy.sh again to retry)"; }
give_up() {
  lack "$1"
  exit 0
}

is_good() { [ -f "$2" ] && echo "$1  $2" | sha256sum --check --status 2>/dev/null; }

# download PACKAGE: its .deb into $work.
download() {
  cd "$work" || return
  apt-get download -q "$1" && return
  # No package lists, or old ones: lists of our own need no rights.
  local own=(-q -o "Dir::State=$work/apt" -o "Dir::Cache=$work/apt")
  mkdir -p "$work/apt/lists/partial" "$work/apt/archives/partial"
  apt-get "${own[@]}" update && apt-get "${own[@]}" download "$1"
}

# missing_of PACKAGE: its files that the data folder lacks.
missing_of() {
  local entry package hash file
  for entry in "${files[@]}"; do
    read -r package hash file <<<"$entry"
    [ "$package" = "$1" ] && ! is_good "$hash" "$data/$file" && echo "$hash $file"
  done
}

# fetch PACKAGE MEGABYTES: without the package we give up, without some of its files only those are lacking.
fetch() {
  local hash file tree=$work/tree-$1 out=$work/out-$1 missing
  missing=$(missing_of "$1")
  [ -n "$missing" ] || return 0
  echo "anatomy: fetching $1 ($2 MB)"
  (download "$1") >"$work/log" 2>&1 || give_up "apt-get can't download $1 ($(tail -n 1 "$work/log"))"
  mkdir -p "$tree" "$out"
  if ! { dpkg -x "$work/$1"_*.deb "$tree" && take "$1" "$tree" "$out"; } 2>"$work/log"; then
    lack "can't unpack $1 ($(tail -n 1 "$work/log"))"
    return
  fi
  while read -r hash file; do
    if ! is_good "$hash" "$out/$file"; then
      lack "$file of $1 is not the one expected"
      continue
    fi
    cp "$out/$file" "$data/.$file.part" && mv "$data/.$file.part" "$data/$file" || give_up "can't write $data/$file"
    echo "anatomy: $data/$file"
  done <<<"$missing"
}

mkdir -p "$data" 2>/dev/null && [ -w "$data" ] || give_up "can't write $data"
work=$(mktemp -d) || give_up "no temporary folder"
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"  # apt-get drops its rights to download
for entry in "${packages[@]}"; do
  read -r package megabytes <<<"$entry"
  fetch "$package" "$megabytes"
done
for entry in "${packages[@]}"; do
  [ -z "$(missing_of "${entry% *}")" ] || exit 0
done
echo "anatomy: all ${#files[@]} files are in $data"
