#!/usr/bin/env bash
# clean_root_test.sh PACKAGES WORK: installs the packages in a Debian root that has nothing else, as a new user would: the client
# alone, then the server; watches a session of the one with the other in a network that is loopback only; builds the example;
# purges all. The bare root and what apt fetches are kept in WORK. Exits 77 (skipped) where that can't be done.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 77; }
fail() { echo "FAILED $1" >&2; exit 1; }
began=$SECONDS
say() { echo "== $1 ($((SECONDS - began)) s)"; }

# The bare root: of this machine's own sources, made anew each week.
bare_root() {
  local codename sources
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  sources=$(apt-get indextargets --no-release-info --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    awk -v code="$codename" '$3 ~ "^" code "(-|$)"' | sort -u)
  [ -n "$sources" ] || skip "apt names no sources for $codename"
  tarball=$work/bare-$(sha256sum <<<"$sources" | cut -c 1-16).tar
  find "$work" -maxdepth 1 -name 'bare-*.tar' -mtime +7 -delete
  [ ! -f "$tarball" ] || return 0
  say "making a bare root"
  mmdebstrap --quiet --format=tar --variant=apt "$codename" "$tarball.part" - <<<"$sources" 2>"$work/bare.log" ||
    skip "mmdebstrap made no root: $(tail -n 1 "$work/bare.log")"
  mv "$tarball.part" "$tarball"
}

if [ "${3:-}" != inside ]; then
  mkdir -p "$2"
  work=$(cd "$2" && pwd) packages=$(cd "$1" && pwd)
  [ "$(id -u)" -eq 0 ] || skip "needs root"
  for program in mmdebstrap unshare ip; do command -v "$program" >/dev/null || skip "$program is not installed"; done
  unshare --mount --pid --net --fork true 2>/dev/null || skip "namespaces can't be made here"
  bare_root
  root=$(mktemp -d)
  trap 'rm -rf --one-file-system "$root"' EXIT
  tar --extract --file "$tarball" --directory "$root" --numeric-owner
  # All that runs and is mounted inside ends with it.
  unshare --mount --pid --fork --kill-child -- "$0" "$packages" "$work" inside "$root"
  exit
fi
packages=$1 work=$2 root=$4

in_root() {
  chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive ${http_proxy:+http_proxy="$http_proxy"} "$@"
}
# as_person COMMAND...: in a network that is loopback only.
as_person() {
  unshare --net bash -c 'ip link set lo up && exec "$@"' - chroot --userspec=1000:1000 "$root" \
    env -i PATH=/usr/bin:/bin HOME=/home/person LC_ALL=C.UTF-8 "$@"
}
apt() { in_root apt-get -q -y -o Dpkg::Use-Pty=0 -o APT::Install-Recommends=false "$@" >"$work/apt.log" 2>&1; }
add() {
  local package files=()
  for package in "$@"; do
    case $package in *prosector*) package=/packages/$(basename "$packages/$package"_*.deb) ;; esac
    files+=("$package")
  done
  apt install "${files[@]}" || fail "apt install $*: $(tail -n 3 "$work/apt.log")"
  say "installed $*: $(in_root dpkg-query -W | wc -l) packages"
}

mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mkdir -p "$work/archives/partial" "$root/packages"
mount --bind "$work/archives" "$root/var/cache/apt/archives"
cp "$packages"/*.deb "$root/packages"
cp --dereference /etc/resolv.conf "$root/etc/resolv.conf"
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe"
rm -f "$root/etc/apt/apt.conf.d/docker-clean"
in_root useradd --uid 1000 --create-home person
apt update || skip "no mirror can be reached: $(tail -n 1 "$work/apt.log")"
in_root dpkg-query -W -f '${Package}\n' | sort >"$work/before"

add prosector-client
in_root dpkg-query -W -f '${Package}\n' | grep -E -- '-dev$|^(gcc|g\+\+|cpp|clang)(-[0-9.]+)?$|^(make|cmake|binutils)$' &&
  fail "the client brought these along"
as_person prosector-client observe --display none --patience 1 --seconds 1 >"$work/alone" 2>&1 && fail "a session without a server"
grep -q 'prosector-client: ' "$work/alone" || fail "the client alone: $(tail -n 3 "$work/alone")"
as_person prosector-fastrak-twin --version >/dev/null

add prosector-server
! find "$root/etc/systemd" -name 'prosector*' | grep . || fail "the service is enabled"
cat >"$root/home/person/session.sh" <<'TXT'
set -eu
cd
prosector-server /usr/share/prosector/scenes/minimal.toml --session bare --seconds 120 --journal journal.sqlite >server 2>&1 &
for wait in $(seq 300); do ! grep -q 'take part' server || break; sleep 0.2; done
prosector-client observe --session bare --name visitor --display offscreen --size 320x240 --seconds 3 --patience 30 \
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

mkdir -p "$root/var/cache/prosector" && touch "$root/var/cache/prosector/mesh"
apt purge prosector-client prosector-server prosector-tools libprosector-dev || fail "apt purge: $(tail -n 3 "$work/apt.log")"
! in_root dpkg-query -W -f '${Package} ${Status}\n' | grep prosector || fail "dpkg still knows these"
! find "$root" -xdev -path "$root/packages" -prune -o -path "$root/home" -prune -o -iname '*prosector*' -print | grep . ||
  fail "these were left"
say "purged all"
