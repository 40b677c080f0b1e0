#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/setup waits while another program holds the lock of apt's lists. Installs nothing: apt-get is the system's
# only for `update`, and that has lists, a lock and sources (none) of its own.
#
# test_setup.sh SOURCE-FOLDER
set -euo pipefail
source=$1
# shellcheck source=tests/support/skips.sh
. "$source/tests/support/skips.sh"
needs apt apt-get
needs python3 python3
[ "$(id -u)" = 0 ] || skip "only root has apt's locks"

work=$(mktemp -d)
holder=
trap '[ -z "$holder" ] || kill "$holder" 2>/dev/null || true; rm -rf "$work"' EXIT
complain() {
  sed 's/^/| /' "$work/said"
  echo "FAILED: $1"
  exit 1
}

mkdir -p "$work/bin" "$work/lists/partial" "$work/cache/archives/partial"
cat >"$work/apt.conf" <<CONF
Dir::State::lists "$work/lists/";
Dir::Cache "$work/cache/";
Dir::Etc::sourcelist "/dev/null";
Dir::Etc::sourceparts "/dev/null";
#clear APT::Update::Pre-Invoke;
#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
CONF
apt_get=$(command -v apt-get)
cat >"$work/bin/apt-get" <<STUB
#!/bin/sh
case "\$*" in
  *install*) echo "\$*" >"$work/installed" ;;
  *) APT_CONFIG="$work/apt.conf" exec "$apt_get" "\$@" ;;
esac
STUB
# Nothing is installed, as far as this test goes.
printf '#!/bin/sh\nexit 1\n' >"$work/bin/dpkg-query"
chmod +x "$work/bin/"*

# hold SECONDS: as apt does, by fcntl().
hold() {
  rm -f "$work/held"
  python3 -c '
import fcntl, os, sys, time
lock = open(sys.argv[1], "w")
fcntl.lockf(lock, fcntl.LOCK_EX)
open(sys.argv[2], "w").close()
time.sleep(float(sys.argv[3]))
os.remove(sys.argv[2])' "$work/lists/lock" "$work/held" "$1" &
  holder=$!
  until [ -e "$work/held" ]; do sleep 0.05; done
}

hold 3
if APT_CONFIG="$work/apt.conf" "$apt_get" -q update >"$work/said" 2>&1; then complain "the lock does not hold"; fi
PATH="$work/bin:$PATH" "$source/tools/setup" >"$work/said" 2>&1 || complain "tools/setup did not wait for the lock"
if [ -e "$work/held" ]; then complain "it went on while the lock was held"; fi
[ "$(grep -c '^Waiting up to 120 s' "$work/said")" = 1 ] || complain "it did not say once that it waits"
grep -q 'install .*gcc' "$work/installed" || complain "it went no further"

: >"$work/said"
PATH="$work/bin:$PATH" "$source/tools/setup" >"$work/said" 2>&1 || complain "without a lock it fails"
if grep -q Waiting "$work/said"; then complain "it waited for nothing"; fi

# Another failure is not waited for: the lists' folder cannot be used.
rm -rf "$work/lists" && : >"$work/lists"
if PATH="$work/bin:$PATH" "$source/tools/setup" >"$work/said" 2>&1; then complain "a failure was not noticed"; fi
if grep -q Waiting "$work/said"; then complain "it waited where waiting does not help"; fi
grep -q '^tools/setup: this failed: ' "$work/said" || complain "the failure was not said"
