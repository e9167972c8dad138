#!/usr/bin/env bash
# service_test.sh PACKAGES WORK: boots a Debian root that has systemd and the server: the service is off at first; enabled, it
# hosts a session and journals it, under all that its unit forbids; removed, it leaves the journal.
set -euo pipefail
. "$(dirname "$0")/root.sh"
need systemd-nspawn
enter "$@"

add prosector-server systemd systemd-sysv
[ "$(in_root systemctl is-enabled prosector-server 2>&1)" = disabled ] || fail "the service is enabled"
sed -i 's/abdomen/minimal/' "$root/etc/default/prosector-server"
in_root systemctl --quiet enable prosector-server
cat >"$root/etc/systemd/system/look.service" <<'TXT'
[Unit]
After=prosector-server.service
[Service]
Type=oneshot
StandardOutput=append:/look
StandardError=inherit
ExecStart=/bin/sh -c 'for wait in $(seq 200); do journalctl -u prosector-server | grep -q "is open on this machine" && break; sleep 0.2; done; sleep 2; systemctl stop prosector-server; journalctl -o cat -u prosector-server'
ExecStopPost=systemctl poweroff --force --force
[Install]
WantedBy=multi-user.target
TXT
in_root systemctl --quiet enable look
unmount_devices
timeout --kill-after=5 90 systemd-nspawn --quiet --directory "$root" --boot --private-network --register=no --keep-unit \
  --console=pipe </dev/null >"$work/boot.log" 2>&1 || fail "booting: $(tail -n 3 "$work/boot.log")"
mount_devices
cp "$root/look" "$work"
for line in 'is open on this machine' '^ended after [1-9]' 'Deactivated successfully'; do
  grep -q "$line" "$work/look" || fail "no \"$line\" in $work/look"
done
! grep -E 'priorit|denied|not permitted|cannot' "$work/look" || fail "the unit forbids too much"
say "the service hosted a session"

journal=$(ls "$root"/var/lib/private/prosector/*.sqlite)
cp "$journal" "$root/home/person" && chown 1000 "$root/home/person"/*.sqlite
as_person bash -c 'prosector-server --replay ~/*.sqlite' >"$work/replay" 2>&1 || fail "replay: $(tail -n 3 "$work/replay")"
apt purge prosector-server || fail "apt purge: $(tail -n 3 "$work/apt.log")"
[ -f "$journal" ] || fail "purging took the journal"
! find "$root/etc" "$root/usr" "$root/var/cache" -xdev -iname '*prosector*' -not -name '*.deb' | grep . || fail "these were left"
say "purged the server"
