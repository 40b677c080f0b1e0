#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# examples/jack_drum.c plays under a JACK server of its own without a card: notes that another client
# sends are heard, it says when there is no server or preset, and SIGTERM ends it.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
needs jackd2 jack_rec jack_midiseq jack_connect
needs pkg-config pkg-config
pkg-config --exists jack || skip "needs libjack-jackd2-dev"
# shellcheck source=tests/support/jack_server.sh
. "$(dirname "$0")/../support/jack_server.sh"

install_tree "$STATIC_BUILD" "$scratch/tree"
use_pkg_config "$scratch/tree"
read -ra flags <<<"$(pkg-config --cflags --libs tabor jack)"
quietly "$CC" -std=c11 -D_DEFAULT_SOURCE -Wall -Wextra -Werror "$SOURCE/examples/jack_drum.c" "${flags[@]}" -lm -o jack_drum

started=()
# The clients end before the server: jack_midiseq, whose signal handler closes it, hung in 1 of 40 trials otherwise.
clean_up() {
  local process
  for process in "${started[@]}"; do end_process "$process" || true; done
  end_jack
  wait
  rm -rf "$scratch"
}
trap clean_up EXIT

# in_background COMMAND...: its output goes to a file of its own.
in_background() {
  "$@" >"$scratch/$(basename "$1").txt" 2>&1 &
  started+=($!)
}

# wait_until COMMAND...: for half a minute at most.
wait_until() {
  local i
  for ((i = 0; i < 300; i++)); do
    if "$@" >/dev/null 2>&1; then return; fi
    sleep 0.1
  done
  complain "waited in vain for: $*"
}

if ./jack_drum 2>message; then complain "it runs without a server"; fi
grep -q 'no JACK server' message

start_jack
if ./jack_drum nonesuch 2>message; then complain "it plays a preset that there is not"; fi
grep -q nonesuch message

in_background ./jack_drum tabor
drum=$!
in_background jack_midiseq notes 24000 0 38 12000
port_is_there() { jack_lsp | grep -qx "$1"; }
wait_until port_is_there tabor:out_top
wait_until port_is_there notes:out
wait_until grep -q "playing 'tabor'" jack_drum.txt
jack_connect notes:out tabor:midi_in
quietly jack_rec -f drum.wav -d 2 -b 24 tabor:out_top

read -r _ _ rate channels frames <<<"$("$INSPECT" sound drum.wav)"
[ "$rate $channels" = "48000 1" ] || complain "recorded: $rate Hz, $channels channels"
((frames > 72000)) || complain "only $frames frames were recorded"
peak=$("$INSPECT" peak drum.wav)
awk "BEGIN { exit !($peak > 0.02 && $peak < 1) }" || complain "notes are heard with a peak of $peak"

end_process "$drum" || complain "it ends with status $?"
