#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The plugin in Ardour, without a screen: notes are played, recorded and exported; a preset and a turned control
# are heard, and are found when the session is opened again.
#
# It gets $BUNDLE, $SOURCE, and $INSPECT for host_checks.sh.
. "$(dirname "$0")/../../support/host_checks.sh"
needs ardour ardour7-lua
: "${BUNDLE:?the bundle}" "${SOURCE:?the source folder}"
export LV2_PATH=/usr/lib/lv2:${BUNDLE%/*} HOME=$private FOLDER=$work

# Ardour 7.3 without a screen crashes in half of its runs, with its own synthesizer too, while it connects ports or
# clears up behind an export: each step has some tries.
# step NAME FOLDER: with what it prints in NAME.txt.
step() {
  local try
  for ((try = 0; try < 8; try++)); do
    rm -rf "$work/session"
    if [ -d "$2" ]; then cp -r "$2" "$work/session"; fi
    STEP=$1 timeout 120 ardour7-lua "$SOURCE/tests/host/lv2/ardour_export.lua" >"$private/$1.txt" 2>"$err" && return
  done 2>/dev/null
  skip "Ardour crashed eight times"
}
step make none
cp -r session made
step reopen made
cat "$private/make.txt" "$private/reopen.txt" >"$out"
# said WHAT: what the script says of it.
said() { grep "^$1" "$out" | tr '\t' ' ' | cut -d ' ' -f 2-; }
same "the plugin" Tabor "$(said plugin)"
same "a preset is loaded" true "$(said preset)"
# Ardour 7 prints what it gets behind the value.
same "what the preset and the control say" "1500.0 2100.0" "$(said turned | grep -oE '[0-9]+\.[0-9]' | head -n 2 | xargs)"
same "reopened" "$(said turned | grep -oE '[0-9]+\.[0-9]' | head -n 2)" \
  "$(said reopened | grep -oE '[0-9]+\.[0-9]' | head -n 2)"

for name in snare tom reopened; do
  mapfile -t onsets < <("$INSPECT" onsets $name.wav)
  same "strokes in $name.wav" 3 "${#onsets[@]}"
done
# Exports are normalised; a tom rings on where a snare drum has died away.
ring() { "$INSPECT" rms "$1" 2.6 2.9; }
holds "another drum is exported: $(ring snare.wav), $(ring tom.wav)" "$(ring tom.wav) > 3 * $(ring snare.wav)"
holds "the same after reopening" "$("$INSPECT" distance tom.wav reopened.wav) < 1e-3"
finish
