#!/usr/bin/env bash
# install_test.sh BUILD: installs, takes the installed tree elsewhere and uses it there, away from source and build tree: every
# program starts, shipped scenes are read, a scene is compiled and drawn to the same bytes as in the tree.
set -euo pipefail
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED $1" >&2
  exit 1
}

cmake --install "$build" --prefix "$work/first" >"$work/log" || fail "cmake --install: $(tail -n 3 "$work/log")"
mv "$work/first" "$work/there"
there=$work/there
shared=$there/share/prosector

# away COMMAND...: runs where neither source nor build tree are to be seen, with nothing of the caller's in the environment.
away() {
  (cd "$work" && env -i HOME="$work/home" PATH="$there/bin:/usr/bin:/bin" "${hidden[@]}" "$@")
}
hidden=()
hide=(unshare --map-root-user --mount bash -c 'mount -t tmpfs none "$0" && { [ ! -d "$1" ] || mount -t tmpfs none "$1"; } && shift && exec "$@"'
  "$source" "$build")
if "${hide[@]}" true 2>/dev/null; then
  hidden=("${hide[@]}")
else
  echo "note: no mount namespace here; source and build tree can be seen"
fi

for program in server client scene import bench fastrak-twin 5dt-twin; do
  file=$there/bin/prosector-$program
  [ -x "$file" ] || fail "prosector-$program is not installed"
  away "prosector-$program" --version >"$work/version" || fail "prosector-$program --version"
  ! readelf -d "$file" | grep -E 'R(UN)?PATH' || fail "prosector-$program looks for libraries in a fixed place"
  for tree in "$source" "$build"; do
    ! strings -d "$file" | grep -F "$tree" || fail "prosector-$program names $tree"
  done
done
! grep -rIlF -e "$source" -e "$build" "$there" || fail "these files name the tree that they were made in"

away prosector-scene "$shared"/scenes/*.toml >"$work/scenes" || fail "shipped scenes: $(tail -n 3 "$work/scenes")"
away prosector-server "$shared/scenes/minimal.toml" --check >"$work/check" 2>&1 || fail "compiling: $(tail -n 3 "$work/check")"

options=(--size 96x72 --quality low --view scene)
away prosector-client render "$shared/scenes/minimal.toml" --out "$work/away" "${options[@]}" >"$work/drawn" 2>&1 ||
  fail "drawing away from the tree: $(tail -n 3 "$work/drawn")"
HOME=$work/home "$build/bin/prosector-client" render "$source/deploy/scenes/minimal.toml" --out "$work/in_tree" "${options[@]}" \
  --shaders "$source/shaders" >"$work/drawn" 2>&1 || fail "drawing in the tree: $(tail -n 3 "$work/drawn")"
[ -n "$(ls "$work/away")" ] || fail "no picture was drawn"
diff -r "$work/away" "$work/in_tree" || fail "the pictures differ"
echo "ok: installed, used elsewhere, drawn alike"
