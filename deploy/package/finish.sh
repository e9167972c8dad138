#!/usr/bin/env bash
# finish.sh SOURCE PACKAGE ROOT: completes the tree ROOT of a package; finish.cmake says when.
set -euo pipefail
source=$1 package=$2 root=$3
docs=$root/usr/share/doc/$package
mkdir -p "$docs"

# Libraries of which only headers are used get into the programs: their notices go with them, from this machine's packages.
{
  cat "$source/deploy/package/copyright"
  for used in libeigen3-dev libtomlplusplus-dev libcli11-dev nlohmann-json3-dev; do
    printf '\n%s\n\nThe copyright file of %s, of which the programs contain parts:\n\n' "$(printf '%78s' | tr ' ' -)" "$used"
    cat "/usr/share/doc/$used/copyright"
  done
} >"$docs/copyright"
gzip -9nc "$source/CHANGELOG.md" >"$docs/changelog.gz"
[ ! -d "$root/usr/share/man" ] || find "$root/usr/share/man" -name '*.1' -exec gzip -9n {} +
[ ! -d "$root/usr/lib" ] || find "$root/usr/lib" -name '*.a' -exec strip --strip-debug {} +

if [ "$package" = prosector-server ]; then
  install -D -m 644 "$source/deploy/package/prosector-server.default" "$root/etc/default/prosector-server"
fi
chmod -R u=rwX,go=rX "$root"
