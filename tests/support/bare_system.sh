# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced, after embed_checks.sh, by tests that need a system with only Debian's base: installs one in $root.
# Needs root, a network and a minute; skips the test if the system cannot be installed.

needs debootstrap debootstrap
needs coreutils chroot
[ "$(id -u)" = 0 ] || skip "a clean system takes root"
# shellcheck source=/dev/null
. /etc/os-release
[ -e "/usr/share/debootstrap/scripts/${VERSION_CODENAME:-none}" ] || skip "debootstrap does not know this system"

root=$scratch/root
mirror=$(apt-cache policy base-files | awk '$2 ~ /^http/ { print $2; exit }')
timeout 900 debootstrap --variant=minbase "$VERSION_CODENAME" "$root" "$mirror" >"$scratch/log" 2>&1 || {
  tail -n 20 "$scratch/log" >&2
  skip "a clean system could not be made from $mirror"
}
cp /etc/resolv.conf "$root/etc/resolv.conf"

# within COMMAND...: runs it in that system.
within() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C DEBIAN_FRONTEND=noninteractive "$@"
}
