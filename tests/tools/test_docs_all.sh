#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/docs/all knows every picture, sound and table of figures in docs/, and tells which of them are older than what they show.
#
# test_docs_all.sh SOURCE-FOLDER
tests=$(cd "$(dirname "$0")/.." && pwd)
source=$1
. "$tests/support/host_checks.sh"

# A copy in which the makers make nothing.
mkdir -p tree/tests
cp -r "$source"/{docs,examples,host,kits,presets,tools,web} tree
cp -r "$source"/tests/{host,reference,support} tree/tests
mkdir -p tree/engine/src && cp -r "$source/engine/src/room" tree/engine/src
cd tree || exit 1
for maker in screen-picture kit-rattle; do printf '#!/usr/bin/env python3\n' >tools/docs/$maker; done
stale() { tools/docs/all --stale 2>&1 | grep -c "^older than what it shows: $1 "; }

# What is written: names with '*' are files of today.
# shellcheck disable=SC2046 # names without blanks
printf '%s\n' $(tools/docs/all --list | cut -d ' ' -f 2-) | sort >made
find docs \( -name '*.png' -o -name '*.svg' -o -name '*.flac' -o -name '*.webp' -o -name '*.json' \) | sort >files
same "files that no tool makes anew, or more than one" "" "$({ comm -23 files made; uniq -d made; } | paste -sd ' ')"
same "what is made but is not there" "" "$(xargs ls 2>&1 >/dev/null <made)"
tools/docs/all --stale >names 2>errors
same "what pages are made from is there" "" "$(cat errors)"

check "a page is made" tools/docs/all screen rattle
same "it is as new as what it shows" 0 "$(stale screen)"
echo '; another' >>presets/tabor.ini
same "a preset has changed" 1 "$(stale screen)"
check "what is named is made anew" tools/docs/all screen
same "it is new again" "0 1" "$(stale screen) $(stale rattle)"
echo '# another' >>tools/docs/screen-picture
same "its maker has changed" 1 "$(stale screen)"
check "what is not known is refused" eval "! tools/docs/all screens 2>/dev/null"

finish
