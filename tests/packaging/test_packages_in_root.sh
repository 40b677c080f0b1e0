#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Debian packages install into a system that has nothing but Debian's base, with what they depend on;
# the program renders there, a program is built against the library there, and removing them leaves
# nothing. Takes root, a network and some minutes.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
needs dpkg dpkg-deb
needs dpkg-dev dpkg-shlibdeps
# shellcheck source=tests/support/bare_system.sh
. "$(dirname "$0")/../support/bare_system.sh"

quietly "$(dirname "$CMAKE")/cpack" --config "$SHARED_BUILD/CPackConfig.cmake" -G DEB -B "$scratch/packages"
everything() { (cd "$root" && find etc opt srv usr var/lib ! -name '*.cache*' | sort); }
quietly within apt-get -q -y --no-install-recommends install gcc libc6-dev pkg-config
everything >before

mkdir "$root/packages"
cp packages/*.deb "$root/packages"
within dpkg-query -W -f '${Package}\n' | sort >packages_before
quietly within bash -c 'apt-get -q -y --no-install-recommends install /packages/*.deb'

# The same strike here and there: the same presets, the same computation, another system's libraries.
within tabor render tabor --quality live --duration 0.5 --format float -q -o /strike.wav
"$TABOR" render tabor --quality live --duration 0.5 --format float -q -o strike.wav
"$INSPECT" equal "$root/strike.wav" strike.wav || complain "the installed program renders something else"
cp "$SOURCE/examples/sequencer.c" "$SOURCE/examples/wav.h" "$root/"
quietly within bash -c 'cc -std=c11 /sequencer.c $(pkg-config --cflags --libs tabor) -o /sequencer && /sequencer /rhythm.wav tabor >/rhythm.csv'
[ -s "$root/rhythm.wav" ] || complain "a program built there renders nothing"

# What came with Tabor goes with it.
within dpkg-query -W -f '${Package}\n' | sort >packages_after
comm -13 packages_before packages_after >came
grep -qx tabor came
read -ra names <<<"$(tr '\n' ' ' <came)"
quietly within apt-get -q -y purge "${names[@]}"
everything >after
diff <(grep -iE 'tabor' before || true) <(grep -iE 'tabor' after || true) || complain "something of tabor is left"
left=$(comm -13 before after | grep -vE '^(var/lib/(apt|dpkg)|etc/ld\.so\.cache)' || true)
if [ -n "$left" ]; then complain "left behind: $left"; fi
