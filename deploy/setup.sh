#!/usr/bin/env bash
# Installs the Debian packages of deploy/packages.txt that are missing. Does nothing when all are there.
set -euo pipefail
cd "$(dirname "$0")"

mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' packages.txt)
missing=()
for package in "${wanted[@]}"; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "setup: all ${#wanted[@]} packages are installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  by_hand="as root, run: apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
  if ! command -v sudo >/dev/null; then
    echo "setup: packages are missing and you are neither root nor have sudo; $by_hand" >&2
    exit 1
  fi
  as_root=(sudo)
  if ! sudo true; then
    echo "setup: packages are missing and you may not use sudo; $by_hand" >&2
    exit 1
  fi
fi

apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o Dpkg::Use-Pty=0 "$@"; }

echo "setup: installing ${#missing[@]} of ${#wanted[@]} packages: ${missing[*]}"
apt update -q || {
  echo "setup: apt-get update failed; check the network and /etc/apt/sources.list (Debian 12), then run this again" >&2
  exit 1
}
apt install -y -q --no-install-recommends "${missing[@]}" || {
  echo "setup: apt-get install failed; fix the error above (often: apt-get -f install), then run this again" >&2
  exit 1
}
echo "setup: done"
