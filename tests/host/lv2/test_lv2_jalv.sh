#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The plugin in a host that people use, jalv: notes and program changes that come from JACK are heard, commands
# move controls.
#
# It gets $BUNDLE, $JACK_SEND, and $INSPECT for host_checks.sh.
. "$(dirname "$0")/../../support/host_checks.sh"
needs jalv jalv
needs jackd2 jack_rec
needs libjack-jackd2-dev "${JACK_SEND:-jack_send}"
needs lilv-utils lv2info
: "${BUNDLE:?the bundle}"
# shellcheck source=tests/support/jack_server.sh
. "$(dirname "$0")/../../support/jack_server.sh"
export LV2_PATH=/usr/lib/lv2:${BUNDLE%/*}

trap 'end_jack; chmod -R u+w "$private"; rm -rf "$private"' EXIT
start_jack

mkfifo "$private/commands"
# In free air: a room would ring on after either drum.
jalv -n tabor-jalv -t -c quality_level=0 -c room=0 urn:tabor:drum <"$private/commands" >"$private/said" 2>"$private/log" &
host=$!
exec 7>"$private/commands"
# say COMMAND: fails, rather than ending this script, if jalv is gone.
trap '' PIPE
say() { echo "$1" >&7; }
has_port() { jack_lsp 2>/dev/null | grep -qx "$1"; }
check "it opens" wait_for has_port tabor-jalv:out_left

# shown SYMBOL: the newest value that jalv knows.
shown() { grep "$1 = " "$private/said" | tail -n 1 | sed 's/.* = //'; }
# shows SYMBOL VALUE: jalv does, within 20 s.
shows() {
  local i
  for ((i = 0; i < 100; i++)); do
    say controls
    sleep 0.2
    awk "BEGIN { d = $(shown "$1") - $2; exit !(d < 1e-4 && d > -1e-4) }" && return
  done
  return 1
}

# hear FILE: a stroke, recorded; the first ones may come before the drum is there.
hear() {
  jack_rec -f "$1" -d 2 -b 24 tabor-jalv:out_left >"$private/rec.log" 2>&1 &
  local recorder=$!
  "$JACK_SEND" tabor-jalv:events 0.5:992664 >/dev/null
  wait "$recorder"
}
peak() { "$INSPECT" peak "$1"; }
heard() {
  hear heard.wav
  awk "BEGIN { exit !($(peak heard.wav) > 0.01) }"
}
check "a note is heard" wait_for heard
one_stroke() {
  hear heard.wav
  mapfile -t onsets < <("$INSPECT" onsets heard.wav)
  echo "onsets: ${onsets[*]}"
  [ "${#onsets[@]}" = 1 ]
}
in_time $CALM "a note is one stroke" one_stroke

loud=$(peak heard.wav)
say "gain = -20"
check "a command moves a control" shows gain -20
heard_softer() {
  hear soft.wav
  awk "BEGIN { exit !($(peak soft.wav) > 0.05 * $loud) }"
}
check "a softer note is heard" wait_for heard_softer
holds "and it is softer: $loud, then $(peak soft.wav)" "$(peak soft.wav) < 0.2 * $loud"
index=$(lv2info urn:tabor:drum 2>"$private/info.log" | awk '/^\tPort [0-9]+:/ { port = $2 + 0 } /Symbol: +gain$/ { print port }')
say "set $index 0"
check "a command with the port's index" shows gain 0

# A program change; presets are counted from 0.
run presets --json
tom=0
until [ "$(json presets.$tom.name)" = tom-12 ]; do tom=$((tom + 1)); done
"$JACK_SEND" tabor-jalv:events "0.2:c9$(printf %02x "$tom")" >/dev/null
# A tom rings where a snare drum has died away.
rings() {
  hear tom.wav
  awk "BEGIN { exit !($("$INSPECT" rms tom.wav 1.2 1.8) > 3 * $("$INSPECT" rms heard.wav 1.2 1.8)) }"
}
check "another drum is heard" wait_for rings

same "the plugin has no complaints" "" "$(grep -i 'tabor:' "$private/log")"
exec 7>&-
wait "$host"
same "jalv ends well" 0 $?
finish
