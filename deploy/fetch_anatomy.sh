#!/usr/bin/env bash
# Takes real anatomy out of Debian's own packages into Prosector's data folder:
#   libcgal-demo: liver.inr.gz (labelled abdominal CT), femur.off, bones.off (foot)
# Nothing is installed. When something fails it says so in one line and succeeds: scenes then fall back to
# implicit shapes.
set -uo pipefail

data=${PROSECTOR_DATA:-${XDG_DATA_HOME:-$HOME/.local/share}/prosector}
package=libcgal-demo
archive=usr/share/doc/libcgal-dev/data.tar.gz
files=(  # sha256, path in the archive
  "8d585a21aaaa34ab62219fa3606541b73de22e25211f78180c625df341cc1991 data/images/liver.inr.gz"
  "75d208fabf7a7b134cfcf2171bad68c331e3bff55309ffe38a01a7b31352fbc6 data/meshes/femur.off"
  "004bd26f0029910eb2e2fd38b7ca11ea05dd4182e247c0fb778533b860dd7ab2 data/meshes/bones.off"
)

give_up() {
  echo "anatomy: $1; scenes use implicit shapes for what is missing (run deploy/fetch_anatomy.sh again to retry)"
  exit 0
}

is_good() { [ -f "$2" ] && echo "$1  $2" | sha256sum --check --status 2>/dev/null; }

missing=()
for entry in "${files[@]}"; do
  read -r hash path <<<"$entry"
  is_good "$hash" "$data/$(basename "$path")" || missing+=("$entry")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "anatomy: all ${#files[@]} files are in $data"
  exit 0
fi

mkdir -p "$data" || give_up "can't write $data"
work=$(mktemp -d) || give_up "no temporary folder"
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"  # apt-get drops its rights to download
echo "anatomy: fetching $package (24 MB) for ${#missing[@]} files"
(cd "$work" && apt-get download -q "$package") >"$work/log" 2>&1 || give_up "apt-get can't download $package ($(tail -n 1 "$work/log"))"
dpkg -x "$work"/"$package"_*.deb "$work/tree" || give_up "can't unpack $package"

for entry in "${missing[@]}"; do
  read -r hash path <<<"$entry"
  file=$(basename "$path")
  tar -xzf "$work/tree/$archive" -C "$work" "$path" 2>/dev/null || give_up "$package holds no $path"
  is_good "$hash" "$work/$path" || give_up "$file of $package is not the one expected"
  cp "$work/$path" "$data/.$file.part" && mv "$data/.$file.part" "$data/$file" || give_up "can't write $data/$file"
  echo "anatomy: $data/$file"
done
