#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# However tabor play ends, the terminal is as it was before, and the recording is whole.

. "$(dirname "$0")/../support/host_checks.sh"
: "${TYPIST:?host_typist}"
export TERM=xterm

play=("$TABOR" play frame-drum --backend null --record take.wav)

# ends STATUS SCRIPT-LINE...: plays, types, and ends so.
ends() {
  local expected=$1
  shift
  rm -f take.wav
  printf 'wait ? help\nraw\n' >script
  printf '%s\n' "$@" >>script
  timeout 300 "$TYPIST" script "${command[@]}" >typed
  same "after: $*" "status $expected settings same screen main" \
    "$(grep -E '^(status|settings|screen)' typed | xargs)"
}
recorded() { check "the recording: $1" "$INSPECT" sound take.wav >sound; }

command=("${play[@]}")
escape_twice() {
  ends 0 escape
  ! grep "Escape once more" typed
}
in_time 0.5 "Escape twice quits" escape_twice
recorded "Escape twice"
ends 0 'type :quit\r'
recorded ":quit"
ends 130 'type \x03'
recorded "Ctrl-C"
ends 131 'type \x1c'
recorded "Ctrl-\\"
ends 143 'signal 15'
recorded "SIGTERM"
ends 129 'signal 1'
recorded "SIGHUP"
ends 134 'signal 6' # SIGABRT, as a failed assertion
ends 132 'signal 4' # SIGILL; sanitizers have the others of this kind for themselves
command=("${play[@]}" --duration 0.7)
ends 0
recorded "--duration"

# Escape once, or twice with something in between, or late, does not quit. That it takes the help away shows that
# the program has seen it.
command=("${play[@]}")
ends 0 'type \e' 'wait Escape again quits' 'type ?' 'wait ghost notes' 'type \e' 'gone ghost notes' 'sleep 1.6' \
  'type \e' 'sleep 0.2' 'type \e[A' 'type ?' 'wait ghost notes' 'type :q\r'

# Suspended and resumed, twice, by a shell; the drum plays on.
cat >job.sh <<'END'
set -m
"$@"
echo "suspended with $?"
read -r
fg >/dev/null
echo "suspended with $?"
read -r
fg >/dev/null
END
command=(bash job.sh "${play[@]}" --no-overwrite)
ends 0 'type \x1a' 'wait suspended with 148' 'cooked' 'type \r' 'wait ? help' 'raw' 'type a' 'wait strokes 1' \
  'type \x1a' 'wait suspended with 148' 'cooked' 'type \r' 'wait ? help' 'raw' 'type a' 'wait strokes 2' 'type :q\r'
recorded "after a suspension"

# What went wrong while the screen was there is said afterwards.
command=(bash -c 'ulimit -f 64; exec "$@"' - "${play[@]}")
ends 1 'wait playing goes on' 'type a' 'wait strokes 1' 'type :q\r' "wait tabor: cannot write 'take.wav'"
recorded "as far as there was room"

finish
