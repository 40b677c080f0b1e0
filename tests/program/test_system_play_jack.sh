#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# play through PortAudio and JACK: a server of its own, which drives no sound card.

. "$(dirname "$0")/../support/host_checks.sh"
needs jackd2 jack_rec
# shellcheck source=tests/support/jack_server.sh
. "$(dirname "$0")/../support/jack_server.sh"
trap 'status=$?; end_jack; leave $status' EXIT

# start_play ARGUMENT...: in the background, until its drum, or the kit of $instrument, sounds on JACK.
instrument=frame-drum
start_play() {
  : >"$err"
  # shellcheck disable=SC2086
  "$TABOR" play $instrument --quality draft --humanize 0 "$@" </dev/null >"$out" 2>"$err" &
  player=$!
  check "the performance begins" wait_for grep -q "from a stroke to its sound" "$err"
}

printf 'time,velocity,radius\n0.6,3,20%%\n0.85,1,\n1.1,5,60%%\n' >strokes.csv
start_jack

# ---- what there is ----

run devices --json
same "a device" "JACK: system" "$(json devices.0.name)"
same "its channels" 2 "$(json devices.0.channels)"
same "it is the default" true "$(json devices.0.default)"
holds "its rate" "$(json devices.0.rate) == 48000"
run devices
check "devices lists it" grep -q '^JACK: system (default): 2 channels, 48000 Hz' "$out"
failed "--device 'nonsense': no such output; there are .*'JACK: system'" play --device nonsense

# ---- the sound arrives ----

# What was heard is what was played, to the last bit that jack_rec rounds.
samples() {
  tail -c +45 "$1" | od -An -v -tu1 -w3 |
    awk '{ v = $1 + 256 * $2 + 65536 * $3; print v < 8388608 ? v : v - 16777216 }'
}
# heard_frames PLAYED HEARD: prints how many frames agree from the first one that sounds on, in at most 60000.
heard_frames() {
  awk 'NR == FNR { played[NR] = $1; if ($1 != 0 && !first) first = NR; next }
    $1 != 0 && !start { start = FNR }
    start { d = $1 - played[first + FNR - start]; if (d < -1 || d > 1) exit; n++ }
    n == 60000 { exit }
    END { print n + 0 }' "$1" "$2"
}

done_quietly render frame-drum -q -o rendered.wav --events strokes.csv --quality draft --duration 2.5
# jack_rec has to be there before the first stroke, and JACK must miss no block.
hear() {
  local frames
  start_play --events strokes.csv --duration 2.5 --record played.wav --json
  jack_rec -f heard.wav -d 2 -b 24 tabor:out_0 >"$private/rec.log" 2>&1
  same "the client is called tabor, and can be recorded" 0 $?
  wait "$player"
  same "status" 0 $?
  check "JACK's block is said" grep -q "'JACK: system' asks for $jack_period frames at once, not for 128" "$err"
  same "device" "JACK: system" "$(json device.name)"
  same "backend" portaudio "$(json device.backend)"
  same "buffer" $jack_period "$(json device.buffer)"
  same "strokes" 3 "$(json strokes)"
  same "late" 0 "$(json late)"
  same "lost frames" 0 "$(json recording.lost_frames)"
  check "the recording is the rendered sound to the bit" cmp rendered.wav played.wav
  samples played.wav >played.txt
  samples heard.wav >heard.txt
  frames=$(heard_frames played.txt heard.txt)
  echo "JACK heard $frames frames as they were played, of 60000; $(json xruns) gaps"
  [ "$frames" = 60000 ]
}
in_time $CALM "JACK hears what is played" hear
first=$("$INSPECT" first played.wav)
holds "the first stroke sounds at 0.6 s: frame $first" "$first >= 28800 && $first < 28900"

# ---- another rate than the server's ----

start_play --rate 44100 --duration 0.2
wait "$player"
same "status at another rate" 0 $?
check "the fallback is said" grep -q "'JACK: system' runs at 48000 Hz, not at 44100" "$err"

# ---- by name ----

for name in 'JACK: system' system jack; do
  start_play --device "$name" --duration 0.1
  wait "$player"
  same "--device $name" 0 $?
done

# ---- the server dies ----

signals=TERM
if jack_is_alone; then signals="KILL TERM"; else skip_part "a server that is killed: /dev/shm is everybody's"; fi
# A quarter of a second before the first stroke, on a snare drum: 480 ticks a quarter, at 120 quarters a minute.
printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\11\201\160\231\46\144\0\377\57\0' >snare.mid
# dies SIGNAL ARGUMENT...: the server of an instrument that plays ends by SIGNAL.
dies() {
  signal=$1
  shift
  start_play "$@" --record "died-$signal.wav"
  check "a stroke is recorded" wait_for recorded 0.75 3
  watch_machine
  stop_jack $signal
  start=$(date +%s%N)
  wait "$player"
  status=$?
  took=$((($(date +%s%N) - start) / 1000000))
  same "status after the server's SIG$signal" 1 "$status"
  watched
  if [ $took -lt 3000 ] || machine_kept_time 0.1; then
    holds "it ends within 3 s: $took ms" "$took < 3000"
  else
    skip_part "how soon it ends: the machine stood still for $stalled s"
  fi
  same "it is said once" 1 "$(grep -c "^tabor: 'JACK: system' is gone" "$err")"
  check "the recording is whole" "$INSPECT" peak "died-$signal.wav" >"$private/peak"
  holds "something was recorded" "$(cat "$private/peak") > 0.001"
  same "nothing is left beside" "" "$(find . -name '.tabor-*' -o -name '*.part*')"
  start_jack
}
for signal in $signals; do
  dies "$signal" --events strokes.csv
  instrument="--kit standard" dies "$signal" --midi-file snare.mid
done

# ---- the kit ends as it is told to ----

instrument="--kit standard"
for signal in INT TERM; do
  start_play --record "told-$signal.wav"
  kill -s $signal "$player"
  wait "$player"
  status=$?
  same "status of a kit after SIG$signal" $((128 + $(kill -l $signal))) $status
  same "nothing is left beside" "" "$(find . -name '.tabor-*' -o -name '*.part*')"
done
instrument=frame-drum

# ---- the server dies while the program starts ----

for signal in $signals; do
  for delay in 0.1 0.3; do
    "$TABOR" play frame-drum --device JACK --quality draft --record "start-$signal-$delay.wav" --duration 60 \
      </dev/null >"$out" 2>"$err" &
    player=$!
    sleep "$delay"
    stop_jack "$signal"
    wait "$player"
    same "status after SIG$signal at $delay s" 1 "$?"
    same "one line says why" 1 "$(grep "^tabor: " "$err" | grep -cv "^tabor: warning: ")"
    same "libraries say nothing" "" "$(grep -iE 'expression|MidiInJack|assert' "$err")"
    same "nothing is left beside" "" "$(find . -name '.tabor-*' -o -name '*.part*')"
    start_jack
  done
done

finish
