# What tests share that install packages in a Debian root with nothing else. Sourced; then `enter "$@"`, where the test's
# arguments are PACKAGES WORK, returns inside: $packages, $work and $root are set, and apt works in the root. The bare root and
# what apt fetches are kept in WORK. Exits 77 (skipped) where that can't be done.
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 77; }
fail() { echo "FAILED $1" >&2; exit 1; }
say() { echo "== $1 ($SECONDS s)"; }
need() { local program; for program in "$@"; do command -v "$program" >/dev/null || skip "$program is not installed"; done; }

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

enter() {
  if [ "${3:-}" = inside ]; then
    packages=$1 work=$2 root=$4
    prepare
    return
  fi
  mkdir -p "$2"
  work=$(cd "$2" && pwd) packages=$(cd "$1" && pwd)
  [ "$(id -u)" -eq 0 ] || skip "needs root"
  need mmdebstrap unshare ip
  unshare --mount --pid --net --fork true 2>/dev/null || skip "namespaces can't be made here"
  bare_root
  root=$(mktemp -d)
  trap 'rm -rf --one-file-system "$root"' EXIT
  tar --extract --file "$tarball" --directory "$root" --numeric-owner
  say "unpacked the root"
  # All that runs and is mounted inside ends with it.
  unshare --mount-proc --pid --fork --kill-child -- "$0" "$packages" "$work" inside "$root"
  exit
}

mount_devices() { mount -t proc proc "$root/proc" && mount --rbind /dev "$root/dev"; }
unmount_devices() { umount --recursive "$root/dev" "$root/proc"; }

prepare() {
  mount_devices
  mkdir -p "$work/archives/partial" "$root/packages"
  mount --bind "$work/archives" "$root/var/cache/apt/archives"
  cp "$packages"/*.deb "$root/packages"
  cp --dereference /etc/resolv.conf "$root/etc/resolv.conf"
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe"
  in_root useradd --uid 1000 --create-home person
  apt update || skip "no mirror can be reached: $(tail -n 1 "$work/apt.log")"
}

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
# add PACKAGE...: ours, or Debian's.
add() {
  local package files=()
  for package in "$@"; do
    case $package in *prosector*) package=/packages/$(basename "$packages/$package"_*.deb) ;; esac
    files+=("$package")
  done
  apt install "${files[@]}" || fail "apt install $*: $(tail -n 3 "$work/apt.log")"
  say "installed $*: $(in_root dpkg-query -W | wc -l) packages"
}
