#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Live MIDI from a JACK client, end to end: notes are strokes at their times in the recording of play.

. "$(dirname "$0")/../support/host_checks.sh"
needs libjack-jackd2-dev "${JACK_SEND:-jack_send}"
# shellcheck source=tests/support/jack_server.sh
. "$(dirname "$0")/../support/jack_server.sh"
trap 'status=$?; end_jack; leave $status' EXIT
start_jack

# start_play ARGUMENT...: in the background, until it plays.
start_play() {
  : >"$err"
  "$TABOR" play frame-drum --quality draft --humanize 0 --no-ui --json "$@" </dev/null >"$out" 2>"$err" &
  player=$!
  check "the performance begins" wait_for grep -q "from a stroke to its sound" "$err"
}
# end_play: lets it finish what it does.
end_play() {
  kill -INT "$player"
  wait "$player"
  same "status" 130 $?
}

# told_strokes N: the messages have told of so many.
told_strokes() { awk -v n="$1" '/: stroke at / { sum += / the last of / ? $NF : 1 } END { exit !(sum >= n) }' "$err"; }
# told_notes N: ... of so many notes that are not in the map.
told_notes() {
  sed -nE 's/.*: ([0-9]+) notes?: not in the MIDI map.*/\1/p' "$err" | awk -v n="$1" '{ sum += $1 } END { exit !(sum >= n) }'
}

# onsets_at FILE SECONDS...: strokes so long after the first, give or take the block to which RtMidi cuts the
# times of JACK's messages; and no others. (JACK's clock stands still for blocks that a busy machine has missed.)
onsets_at() {
  local sound=$1 onset seconds
  shift
  mapfile -t onsets < <("$INSPECT" onsets "$sound")
  echo "onsets in $sound: ${onsets[*]}, expected after $* s"
  [ "${#onsets[@]}" = $(($# + 1)) ] || return
  for seconds in "$@"; do
    onset=${onsets[1]}
    awk "BEGIN { exit !(($onset - ${onsets[0]} - 48000 * $seconds) ^ 2 <= ($jack_period + 48) ^ 2) }" || return
    onsets=("${onsets[0]}" "${onsets[@]:2}")
  done
}

# ---- our own input ----

play_own() {
  start_play --record own.wav
  check "notes are sent" "$JACK_SEND" tabor-midi:in 0.1:992620 0.3:997f7f 0.5:992650 0.9:99267f 1.0:992600
  check "strokes are told" wait_for told_strokes 3
  record_more 0.1 3
  end_play
  same "strokes" 3 "$(json strokes)"
  same "nothing is dropped" 0 "$(json dropped)"
  check "velocity 127 is 10 m/s" grep -q "10.00 m/s" "$err"
  onsets_at own.wav 0.4 0.8
}
in_time $CALM "strokes come at the times of their notes" play_own

# ---- an input that is there, and is listed ----

"$JACK_SEND" - 0.1:992640 &
sender=$!
listed() {
  run devices --json
  [ "$(json midi_inputs.0.name)" = "Jack: jack_send:out" ]
}
check "devices lists an input" wait_for listed
same "that is heard if it is asked for" false "$(json midi_inputs.0.default)"
run devices
check "in a line" grep -qx 'Jack: jack_send:out: MIDI input' "$out"
start_play --midi-in jack_s
wait $sender
same "the sender's status" 0 $?
check "its stroke is told" wait_for told_strokes 1
end_play
same "its stroke" 1 "$(json strokes)"

# ---- an input that comes later, by its name ----

play_named() {
  start_play --midi-in jack_s --midi-channel 2 --record named.wav
  check "it is said that there is none" grep -q "^tabor: warning: --midi-in 'jack_s': no MIDI input" "$err"
  check "notes are sent" "$JACK_SEND" - 0.1:912630 0.3:922630 0.5:91267f 0.6:913c7f 0.7:91017f 0.7:910100
  check "its coming is said" wait_for grep -q "^MIDI from Jack: jack_send:out" "$err"
  check "its going is said" wait_for grep -q "^MIDI: 'jack_send:out' is gone" "$err"
  check "strokes are told" wait_for told_strokes 2
  check "notes that are not in the map are told" wait_for told_notes 2
  record_more 0.1 3
  end_play
  same "strokes on channel 2" 2 "$(json strokes)"
  same "notes that are not in the map" 2 "$(json ignored_notes)"
  onsets_at named.wav 0.4
}
in_time $CALM "strokes of a later input come at the times of their notes" play_named

# ---- presets, maps, silence ----

run presets --json
for ((i = 0; i < $(json presets.size); i++)); do
  [ "$(json presets.$i.name)" = tom-12 ] && tom=$(printf '%02x' "$i")
done
printf '[note.60]\n\n[controller.30]\nmoves = silence\n' >map.ini
play_other() {
  local first
  start_play --midi-map map.ini --record other.wav
  check "notes are sent" "$JACK_SEND" tabor-midi:in 0:993c7f 0.2:b01e00 "0.4:c9$tom" 1.0:b00740 1.0:993c7f
  check "the preset is told" wait_for grep -q "preset tom-12" "$err"
  patience=5 wait_for told_strokes 2
  end_play
  same "the preset" tom-12 "$(json preset)"
  # silence takes away a stroke that a late machine puts behind it
  [ "$(json strokes)" = 2 ] || return
  first=$("$INSPECT" onsets other.wav | head -n 1)
  awk "BEGIN { exit !($("$INSPECT" rms other.wav "$(awk "BEGIN { print $first / 48000 + 0.25 }")" \
    "$(awk "BEGIN { print $first / 48000 + 0.35 }")") == 0) }"
}
in_time $CALM "a controller silences the drum at its time" play_other

# ---- a controller is learned ----

# learn MAP-OPTION...: gives up learning; then types the command, and moves controller 74 until the program has heard it.
learn() {
  printf '%s\n' 'size 160 40' 'wait ? help' 'type :learn none\r' 'wait to do nothing' 'type \e' 'wait no controller is learned' \
    'type :save go.ini\r' 'wait saved go.ini' 'type :learn batter.muf\t' 'wait muffle_strength' 'type \r' \
    'wait controller 74 moves' 'show' 'type :save done.ini\r' 'wait saved done.ini' 'type :learn batter.tension\r' 'wait cannot move' 'type :quit\r' >script
  rm -f learned.log go.ini done.ini
  timeout 300 "$TYPIST" script "$TABOR" play tom-12 --quality draft --log learned.log "$@" >typed 2>&1 &
  local typist=$!
  while kill -0 $typist 2>/dev/null; do
    [ ! -e go.ini ] || [ -e done.ini ] || timeout 10 "$JACK_SEND" tabor-midi:in 0:b94a40 >/dev/null 2>&1
    sleep 0.1
  done
  wait $typist
  same "the typist's status" 0 $?
}
export TERM=xterm
: "${TYPIST:?host_typist}"
learn
check "it says what keeps it" grep -q -- '--midi-map FILE would keep it' typed
check "the controller moves it" grep -qE '^\{.*"parameter".*"batter.muffle_strength"' learned.log
printf '; mine\n[note.60]\n' >kept.ini
learn --midi-map kept.ini
same "the map's file" '; mine,[note.60],[controller.74],moves = batter.muffle_strength' "$(paste -sd , kept.ini)"
done_quietly render tom-12 --midi-map kept.ini --duration 0.1 -q -o kept.wav

# ---- far too much ----

# As many as a person can play are played: 1000 a second, and some at once.
play_flood() {
  local begun=$EPOCHREALTIME most strokes dropped
  start_play --record flood.wav
  check "100,000 notes a second" "$JACK_SEND" tabor-midi:in flood 100000 1 >sent.txt
  record_more 0.1 3
  end_play
  most=$(awk "BEGIN { print int(200 + 1000 * ($EPOCHREALTIME - $begun)) }")
  holds "all of them were sent: $(cat sent.txt)" "$(cat sent.txt) >= 100000"
  strokes=$(json strokes) dropped=$(json dropped)
  holds "$strokes strokes are played, $most at most" "$strokes <= $most"
  check "the recording is whole" "$INSPECT" peak flood.wav >peak.txt
  holds "and is no silence" "$(cat peak.txt) > 0.01"
  echo "$strokes strokes, $dropped dropped"
  awk "BEGIN { exit !($strokes >= 200 && $dropped > 50000) }"
}
in_time $CALM "strokes go on, and the others are counted" play_flood

finish
