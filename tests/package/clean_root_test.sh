#!/usr/bin/env bash
# clean_root_test.sh PACKAGES WORK: installs the packages in a Debian root that has nothing else, as a new user would: the client
# alone, then the server; watches a session of the one with the other in a network that is loopback only; builds the example;
# purges all.
set -euo pipefail
. "$(dirname "$0")/root.sh"
enter "$@"

add prosector-client
in_root dpkg-query -W -f '${Package}\n' | grep -E -- '-dev$|^(gcc|g\+\+|cpp|clang)(-[0-9.]+)?$|^(make|cmake|binutils)$' &&
  fail "the client brought these along"
as_person prosector-client observe --display none --timeout 1 --seconds 1 >"$work/alone" 2>&1 && fail "a session without a server"
grep -q 'prosector-client: ' "$work/alone" || fail "the client alone: $(tail -n 3 "$work/alone")"
as_person prosector-fastrak-twin --version >/dev/null

add prosector-server
! find "$root/etc/systemd" -name 'prosector*' | grep . || fail "the service is enabled"
cat >"$root/home/person/session.sh" <<'TXT'
set -eu
cd
prosector-server /usr/share/prosector/scenes/minimal.toml --session bare --seconds 120 --journal journal.sqlite >server 2>&1 &
for wait in $(seq 300); do ! grep -q 'participate:' server || break; sleep 0.2; done
prosector-client observe --session bare --name visitor --display offscreen --size 320x240 --seconds 3 --timeout 30 \
  --screenshot picture.png --summary figures.json >client 2>&1 || { cat server client; exit 1; }
kill -TERM $!
wait $!
TXT
as_person bash /home/person/session.sh || fail "the session"
grep -q '^ended after' "$root/home/person/server" || fail "the server's end: $(tail -n 3 "$root/home/person/server")"
cp "$root"/home/person/{picture.png,figures.json,server,client} "$work"
"$here/check_picture.py" "$work/picture.png" "$work/figures.json"
as_person prosector-server --replay /home/person/journal.sqlite >"$work/replay" 2>&1 || fail "replay: $(tail -n 3 "$work/replay")"
say "watched a session"

add prosector-tools
as_person bash -c 'prosector-scene /usr/share/prosector/scenes/*.toml' >"$work/scenes" || fail "shipped scenes"
as_person prosector-play --help >/dev/null
as_person prosector-bench --help >/dev/null

add libprosector-dev cmake g++ make
cp "$here/build_example.sh" "$root/home/person"
as_person bash /home/person/build_example.sh /usr /home/person/build >"$work/build.log" 2>&1 ||
  fail "the example: $(tail -n 5 "$work/build.log")"
as_person /home/person/build/bend_and_press >"$work/figures"
"$here/check_figures.py" "$work/figures"
say "built the example"
as_person bash -c 'cd /usr/include/prosector && find . -name "*.h" | while read -r header; do
  g++ -std=c++20 -fsyntax-only -Wall -Wextra -I . -isystem /usr/include/eigen3 -x c++ - <<<"#include \"$header\"" || exit 1; done' \
  >"$work/headers" 2>&1 || fail "a header by itself: $(head -n 3 "$work/headers")"
say "compiled each header by itself"

mkdir -p "$root/var/cache/prosector" && touch "$root/var/cache/prosector/mesh"
apt purge prosector-client prosector-server prosector-tools libprosector-dev || fail "apt purge: $(tail -n 3 "$work/apt.log")"
! in_root dpkg-query -W -f '${Package} ${Status}\n' | grep prosector || fail "dpkg still knows these"
! find "$root" -xdev -path "$root/packages" -prune -o -path "$root/home" -prune -o -iname '*prosector*' -print | grep . ||
  fail "these were left"
say "purged all"
