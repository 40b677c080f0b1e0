#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The plugin's window in a host that people use, jalv: a click on the drum is heard.
#
# It gets $BUNDLE, and $INSPECT for host_checks.sh. PICTURES in the environment is a folder for pictures of the window.
. "$(dirname "$0")/../../support/host_checks.sh"
needs jalv jalv.gtk3
needs xvfb Xvfb
needs xdotool xdotool
needs jackd2 jack_rec
: "${BUNDLE:?the bundle}"
[ -e "$BUNDLE/tabor_ui.so" ] || skip "no cairo-xcb, xcb or xkbcommon-x11: needs libcairo2-dev libxcb1-dev libxkbcommon-x11-dev"
# shellcheck source=tests/support/jack_server.sh
. "$(dirname "$0")/../../support/jack_server.sh"
export LV2_PATH=/usr/lib/lv2:${BUNDLE%/*} HOME=$private

screen=
trap 'end_jack; [ -z "$screen" ] || kill "$screen"; chmod -R u+w "$private"; rm -rf "$private"' EXIT
start_jack
Xvfb -displayfd 5 -screen 0 1600x1200x24 -nolisten tcp 5>"$private/display" 2>"$private/Xvfb.log" &
screen=$!
wait_for test -s "$private/display"
DISPLAY=:$(cat "$private/display")
export DISPLAY

has_port() { jack_lsp 2>/dev/null | grep -qx "$1"; }
has_window() { xdotool search --onlyvisible --name '^Tabor' >/dev/null 2>&1; }

# hear X Y FILE: a click there, recorded.
hear() {
  jack_rec -f "$3" -d 2 -b 24 tabor-window:out_left >"$private/rec.log" 2>&1 &
  local recorder=$!
  sleep 0.5
  xdotool mousemove "$1" "$2" click 1
  wait "$recorder"
}
# is_heard: the drum may not be there yet at the first clicks.
is_heard() {
  local try
  for try in 1 2 3 4 5 6 7 8; do
    hear 205 175 "heard$try.wav"
    if awk "BEGIN { exit !($("$INSPECT" peak "heard$try.wav") > 0.01) }"; then return; fi
  done
  return 1
}

jalv.gtk3 -n tabor-window -c quality_level=0 urn:tabor:drum >"$private/said" 2>"$private/log" &
host=$!
check "it opens" wait_for has_port tabor-window:out_left
check "its window is there" wait_for has_window
check "a click on the head is heard" is_heard
if [ -n "${PICTURES-}" ]; then import -window root "$PICTURES/jalv.png"; fi
hear 5 5 beside.wav
holds "one beside it is not: $("$INSPECT" peak beside.wav)" "$("$INSPECT" peak beside.wav) < 0.01"
same "the plugin has no complaints" "" "$(grep 'Tabor: ' "$private/log")"
end_process "$host" >/dev/null 2>&1 || true
finish
