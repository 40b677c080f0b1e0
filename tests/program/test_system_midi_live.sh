#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Live MIDI from a JACK client, end to end: notes are strokes at their times in the recording of play.

. "$(dirname "$0")/../support/host_checks.sh"
needs jackd2 jackd jack_wait
needs libjack-jackd2-dev "${JACK_SEND:-jack_send}"

export JACK_DEFAULT_SERVER=tabor-midi-test-$$ JACK_NO_START_SERVER=1 JACK_NO_AUDIO_RESERVATION=1
period=1024
jackd --no-realtime -n "$JACK_DEFAULT_SERVER" -d dummy -r 48000 -p "$period" >>"$private/jackd.log" 2>&1 &
server=$!
# A server that is killed keeps one of JACK's eight places; one that ends by itself gives it back.
trap 'kill "$server"; wait "$server" 2>/dev/null; chmod -R u+w "$private"; rm -rf "$private"' EXIT
check "the server starts" jack_wait -s "$JACK_DEFAULT_SERVER" -w -t 10 >/dev/null

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

# JACK's clock stands still for blocks that a busy machine has missed.
missed_blocks() { [ "$(json xruns)" != 0 ] || grep -qi xrun "$private/jackd.log"; }

# check_onsets FILE SECONDS...: strokes so long after the first, give or take the block to which
# RtMidi cuts the times of JACK's messages.
check_onsets() {
  local sound=$1 first onset
  shift
  if missed_blocks; then
    skip_part "the times of strokes in $sound: the machine missed blocks"
    return
  fi
  mapfile -t onsets < <("$INSPECT" onsets "$sound")
  same "strokes in $sound" $(($# + 1)) "${#onsets[@]}"
  first=${onsets[0]:-0}
  for onset in "${onsets[@]:1}"; do
    holds "a stroke at $1 s" "($onset - $first - 48000 * $1) ^ 2 <= ($period + 48) ^ 2"
    shift
  done
}

# ---- our own input ----

for ((try = 0; try < 3; try++)); do
  : >"$private/jackd.log"
  start_play --record own.wav
  check "notes are sent" "$JACK_SEND" tabor-midi:in 0.1:992620 0.3:997f7f 0.5:992650 0.9:99267f 1.0:992600
  sleep 0.3
  end_play
  missed_blocks || break
done
same "strokes" 3 "$(json strokes)"
same "nothing is dropped" 0 "$(json dropped)"
check_onsets own.wav 0.4 0.8
check "velocity 127 is 10 m/s" grep -q "10.00 m/s" "$err"

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
sleep 0.2
end_play
same "its stroke" 1 "$(json strokes)"

# ---- an input that comes later, by its name ----

start_play --midi-in jack_s --midi-channel 2 --record named.wav
check "it is said that there is none" grep -q "^tabor: warning: --midi-in 'jack_s': no MIDI input" "$err"
check "notes are sent" "$JACK_SEND" - 0.1:912630 0.3:922630 0.5:91267f 0.6:913c7f 0.7:91017f 0.7:910100
sleep 0.2
check "its coming is said" grep -q "^MIDI from Jack: jack_send:out" "$err"
check "its going is said" wait_for grep -q "^MIDI: 'jack_send:out' is gone" "$err"
end_play
same "strokes on channel 2" 2 "$(json strokes)"
same "notes that are not in the map" 2 "$(json ignored_notes)"
check_onsets named.wav 0.4

# ---- presets, maps, silence ----

run presets --json
for ((i = 0; i < $(json presets.size); i++)); do
  [ "$(json presets.$i.name)" = tom-12 ] && tom=$(printf '%02x' "$i")
done
printf '[note.60]\n\n[controller.30]\nmoves = silence\n' >map.ini
start_play --midi-map map.ini --record other.wav
check "notes are sent" "$JACK_SEND" tabor-midi:in 0:993c7f 0.2:b01e00 "0.4:c9$tom" 1.0:b00740 1.0:993c7f
sleep 0.3
end_play
same "the preset" tom-12 "$(json preset)"
same "strokes" 2 "$(json strokes)"
mapfile -t onsets < <("$INSPECT" onsets other.wav)
holds "silence" "$("$INSPECT" rms other.wav "$(awk "BEGIN { print ${onsets[0]} / 48000 + 0.25 }")" \
  "$(awk "BEGIN { print ${onsets[0]} / 48000 + 0.35 }")") == 0"

# ---- far too much ----

start_play --record flood.wav
check "100,000 notes a second" "$JACK_SEND" tabor-midi:in flood 100000 1 >sent.txt
sleep 0.2
end_play
holds "all of them were sent: $(cat sent.txt)" "$(cat sent.txt) >= 100000"
strokes=$(json strokes) dropped=$(json dropped)
holds "strokes go on, $strokes of them, with as many as a person can play at most" \
  "$strokes >= 200 && $strokes <= 1600"
holds "the others are dropped and counted: $dropped" "$dropped > 50000"
check "the recording is whole" "$INSPECT" peak flood.wav >peak.txt
holds "and is no silence" "$(cat peak.txt) > 0.01"

finish
