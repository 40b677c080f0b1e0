#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render --midi-file: songs, the map and its options, and files that are none.

. "$(dirname "$0")/../support/host_checks.sh"

short=(tabor -q --quality draft --rate 22050 --format float --duration 0.6)

# bytes HEX...: these bytes; blanks between them do not count.
bytes() {
  local hex
  hex=$(printf '%s' "$@" | tr -d ' \n')
  # shellcheck disable=SC2059
  printf "$(sed 's/../\\x&/g' <<<"$hex")"
}
# number DIGITS VALUE: as so many hexadecimal digits.
number() { printf '%0*x' "$1" "$2"; }
# song NAME FORMAT TRACK...: 96 ticks for a quarter, 120 quarters a minute; tracks as hexadecimal
# digits, without their ends.
song() {
  local name=$1 format=$2 text track
  shift 2
  text="4d546864 00000006 $(number 4 "$format") $(number 4 $#) 0060"
  for track in "$@"; do
    track="$track 00ff2f00"
    text+=" 4d54726b $(number 8 $(($(tr -d ' \n' <<<"$track" | tr -d '\n' | wc -c) / 2))) $track"
  done
  bytes "$text" >"$name"
}
# play NAME ARGUMENT...: renders song.mid without a word.
play() {
  local name=$1
  shift
  done_quietly render "${short[@]}" --midi-file song.mid -o "$name" "$@"
}

# ---- the same as --events ----

cat >strokes.csv <<'END'
time,midi,radius
0.25,100,
0.375,64,0
0.375,1,
0.5,127,
END
done_quietly render "${short[@]}" --events strokes.csv -o events.wav
song song.mid 0 "30 992664  18 2440  00 992601  18 99267f"
play song.wav
same_bytes "format 0" events.wav song.wav
song song.mid 1 "48 903c01" "30 992664  30 99267f" "48 902440  00 2601"
play one.wav --midi-channel 10
other_bytes "one channel" events.wav one.wav
sed -i 's/^0.375.*//' strokes.csv
done_quietly render "${short[@]}" --events strokes.csv -o tenth.wav
same_bytes "the tenth channel" tenth.wav one.wav
run render tabor --quality draft --rate 22050 --format float --duration 0.6 --midi-file song.mid -o song.wav
same_bytes "format 1" events.wav song.wav
same "notes that do nothing are counted" \
  "song.mid: 1 of 5 notes are not in the map and were passed over" "$(head -n 1 "$err")"

song song.mid 0 "00 ff51030f4240 18 992664"
render_strikes strikes.wav time=0.25,midi=100
play song.wav
same_bytes "tempo" strikes.wav song.wav
play trace.wav --trace trace.csv
same_bytes "with a trace" song.wav trace.wav
same "rows of the trace" "$("$INSPECT" sound song.wav | cut -d' ' -f5)" \
  "$(($(wc -l <trace.csv) - 1))"
done_quietly render "${short[@]}" --midi-file - -o input.wav <song.mid
same_bytes "standard input" song.wav input.wav
done_quietly render "${short[@]}" --midi-file <(cat song.mid) -o pipe.wav
same_bytes "a pipe" song.wav pipe.wav

render_strikes strikes.wav time=0,velocity=3 time=0.25,midi=100
play song.wav --strike time=0,velocity=3
same_bytes "with --strike" strikes.wav song.wav
printf 'time,velocity\n0,3\n' >strokes.csv
play song.wav --events strokes.csv
same_bytes "with --events" strikes.wav song.wav
play scattered.wav --strike time=0,velocity=3 --humanize 1 --seed 3
other_bytes "scattered" song.wav scattered.wav
refused "allowed: one of them" render --events - --midi-file -
refused "several sounds cannot share" render tabor tom-12 --midi-file - -o out/

# ---- velocities, places ----

song song.mid 0 "00 b95840 00 992640"
render_strikes strikes.wav time=0,midi=64
play song.wav
other_bytes "low bits of a velocity" strikes.wav song.wav
song song.mid 0 "00 992640"
play song.wav --velocity-curve linear
same_bytes "a linear curve" strikes.wav song.wav
play soft.wav --velocity-curve soft
play hard.wav --velocity-curve hard
holds "soft is loud, hard is quiet" "$("$INSPECT" peak soft.wav) > $("$INSPECT" peak song.wav) && \
  $("$INSPECT" peak song.wav) > $("$INSPECT" peak hard.wav)"
song song.mid 0 "00 99267f"
for row in normal:10 full:12; do
  render_strikes strikes.wav "time=0,velocity=${row#*:}"
  play song.wav --velocity-range "${row%:*}"
  same_bytes "velocity 127 in the range ${row%:*}" strikes.wav song.wav
done
# A controller counts for the notes of its own time, whatever its track is.
song song.mid 1 "00 992640" "00 b01000 00 b01120"
render_strikes strikes.wav time=0,midi=64,radius=0,angle=90
play song.wav
same_bytes "radius and angle" strikes.wav song.wav

# ---- what acts beside strokes ----

song song.mid 0 "00 992640"
play song.wav
song song.mid 0 "00 b0077f 00 992640 05 b00b00"
play faded.wav
holds "CC11 fades" "$("$INSPECT" rms faded.wav 0 0.02) > 0 && \
  $("$INSPECT" rms faded.wav 0.1 0.6) == 0"
song song.mid 0 "00 b00740 00 992640"
play quiet.wav --gain 0
holds "a gain of (64/127)^2 after 5 ms" "$("$INSPECT" peak quiet.wav) < $("$INSPECT" peak song.wav)"

song song.mid 0 "00 992640 18 b07b00"
play silenced.wav
holds "CC123 ends the sound" "$("$INSPECT" rms silenced.wav 0.2 0.6) == 0"
song song.mid 0 "00 992640 18 b07b00 00 992640"
play again.wav
holds "a stroke at the same time is heard" "$("$INSPECT" rms again.wav 0.2 0.6) > 0"

# Panics come on all channels: that is one silence, and none where nothing sounds.
panic=
for ((i = 0; i < 16; i++)); do panic+=" 00 b$(number 1 $i)7800 00 b$(number 1 $i)7b00"; done
song song.mid 0 "00 992640 18 b07b00 01 992640"
play one.wav
song song.mid 0 "00 992640 18 b07b00$panic 01 992640"
play all.wav
same_bytes "silences at one time are one" one.wav all.wav
song song.mid 0 "00 992640"
play plain.wav
song song.mid 0 "00 b07b00 00 992640"
play first.wav
same_bytes "a drum at rest is silent" plain.wav first.wav

song song.mid 0 "00 992664 10 d97f"
play choked.wav
song song.mid 0 "00 992664 10 d900"
play open.wav
holds "pressure damps" \
  "3 * $("$INSPECT" rms choked.wav 0.15 0.5) < $("$INSPECT" rms open.wav 0.15 0.5)"
song song.mid 0 "00 b01400 00 992664"
play off.wav
other_bytes "the strainer" open.wav off.wav

# Program changes, counted from 0: at the very beginning they are the preset itself; later its sound
# alone is left once the other one has faded.
tom=
run presets --json
for ((i = 0; i < $(json presets.size); i++)); do
  [ "$(json presets.$i.name)" = tom-12 ] && tom=$(number 2 $i)
done
song song.mid 0 "00 992664 00 c9$tom"
play changed.wav
done_quietly render tom-12 "${short[@]:1}" --strike midi=100 -o tom.wav
same_bytes "a program change" tom.wav changed.wav
song song.mid 0 "00 b0107f 00 992664 20 992664 20 992664"
done_quietly render tom-12 "${short[@]:1}" --midi-file song.mid --humanize 0.5 -o tom-song.wav
song song.mid 0 "00 c9$tom 00 b0107f 00 992664 20 992664 20 992664"
play changed.wav --humanize 0.5
same_bytes "strokes are scattered by the size of the drum that they fall on" tom-song.wav changed.wav
song song.mid 0 "00 992664 60 c9$tom 00 992664"
play changed.wav
same "the new drum alone" "$("$INSPECT" rms tom.wav 0.05 0.1)" \
  "$("$INSPECT" rms changed.wav 0.55 0.6)"
play traced.wav --trace changed.csv
same_bytes "with a trace" changed.wav traced.wav
song song.mid 0 "00 992664 18 c900 18 c900"
play same.wav
same_bytes "the same preset over and over" open.wav same.wav
song song.mid 0 "00 992664 00 c97f"
play same.wav
same_bytes "a program that is no preset" open.wav same.wav

# ---- play does what render does ----

printf 'RIFFxxxxRMIDdata' >bad.mid
export JACK_NO_START_SERVER=1 JACK_DEFAULT_SERVER=tabor-test-none-$$
# same_played WHAT ARGUMENT...: song.mid sounds alike in both, to the bit.
same_played() {
  local what=$1 buffer
  shift
  play rendered.wav "$@"
  for buffer in 16 100 4096; do
    done_quietly play "${short[@]}" --midi-file song.mid --backend file --record played.wav \
      --humanize 0 --buffer "$buffer" "$@"
    check "$what, with --buffer $buffer" cmp rendered.wav played.wav
  done
}
song song.mid 0 "00 992664 08 b00740 08 992664 02 99267f 08 b07b00 00 992664 10 b00b60 00 d940"
same_played "notes, gain, silence, pressure" --gain -3.3
song song.mid 0 "00 992601 18 992640 18 99267f"
same_played "the full range of velocities" --velocity-range full --velocity-curve soft
song song.mid 0 "00 992664 18 c9$tom 00 992664 08 992640 18 c900 01 992650"
same_played "presets"
run play "${short[@]}" --midi-file song.mid --backend null --humanize 0 --record played.wav --json
same "status against a clock" 0 "$status"
same "the preset" tabor "$(json preset)"
same "strokes" 4 "$(json strokes)"
cp song.mid take.wav
refused "would overwrite the MIDI file 'take.wav'" play --midi-file take.wav --record take.wav
refused "nothing is heard live" play --backend file --record played.wav --midi-in x
refused "--midi-in needs" play --midi-in ''
refused "bad.mid: byte 0: not a Standard MIDI File" play --midi-file bad.mid
failed "missing.mid': No such file" play --midi-file missing.mid

# ---- maps ----

# map LINE...
map() { printf '%s\n' "$@" >map.ini; }
song song.mid 0 "00 b04a7f 00 993c40"
map "[note.60]" "radius = 25" "angle = 45 ; degrees" "speed = 0.5" "striker = stick"
play song.wav --midi-map map.ini
speed=$(awk 'BEGIN { printf "%.17g", 0.5 * 10 ^ (44 / 107) }')
render_strikes strikes.wav "time=0,velocity=$speed,radius=25%,angle=45"
holds "a note of one's own" "$("$INSPECT" distance song.wav strikes.wav) < 1e-6"
map "[map]" "velocity = hard" "channel = 10" "" "[note.60]" "[controller.74]" "moves = radius"
play song.wav --midi-map map.ini
song song.mid 0 "00 992640"
play hard.wav --velocity-curve hard
same_bytes "a curve in the map" hard.wav song.wav
map "[map]" "velocity_range = full"
play song.wav --midi-map map.ini
play full.wav --velocity-range full
same_bytes "a range in the map" full.wav song.wav
play song.wav --midi-map map.ini --velocity-range normal
other_bytes "the option counts for more" full.wav song.wav
song song.mid 0 "00 b04a7f 00 993c40"
map "[map]" "velocity = hard" "" "[note.60]"
play both.wav --midi-map map.ini --velocity-curve linear
play linear.wav --midi-map map.ini
other_bytes "the option counts for more than the map" both.wav linear.wav
map "[note.60]" "[controller.74]" "moves = wires.damping_0" "from = 2" "to = 500"
play damped.wav --midi-map map.ini
other_bytes "a live parameter" both.wav damped.wav
map "[map]" "defaults = no" "" "[note.61]"
refused "song.mid: no note in it is a stroke: 1 are not in the map" \
  render --midi-file song.mid --midi-map map.ini
refused "song.mid: no note on channel 5 is a stroke: 0 are not in the map" \
  render --midi-file song.mid --midi-channel 5

map "[note.60]" "stroke = buzz"
song song.mid 0 "00 993c60 30 893c00"
printf 'time,event,midi,technique,pressure\n0,strike,96,buzz,0.5\n0.25,release,,,\n' >strokes.csv
play song.wav --midi-map map.ini
done_quietly render "${short[@]}" --events strokes.csv -o events.wav
same_bytes "a note that buzzes until it ends" events.wav song.wav
song song.mid 0 "00 b04a7f 00 993c40"

# bad PATTERN LINE...: a map of these lines is refused.
bad() {
  local pattern=$1
  shift
  map "$@"
  refused "$pattern" render --midi-file song.mid --midi-map map.ini
}
bad "map.ini:1: \[notes\]: unknown section; allowed: \[map\]" "[notes]" "x = 1"
bad "map.ini:1: \[note.128\] '128': out of range; allowed: 0 to 127" "[note.128]"
bad "map.ini:1: \[note.x\] 'x': not a number" "[note.x]"
bad "map.ini:1: \[controller.-1\] '-1'" "[controller.-1]"
bad "map.ini:2: \[map\]: has to stand first" "[note.1]" "[map]"
bad "map.ini:2: chanel: unknown key; did you mean 'channel'" "[map]" "chanel = 1"
bad "map.ini:2: channel '17': out of range; allowed: 1 to 16" "[map]" "channel = 17"
bad "map.ini:2: velocity 'sft': unknown; did you mean 'soft'" "[map]" "velocity = sft"
bad "map.ini:2: velocity_range 'ful': unknown; did you mean 'full'" "[map]" "velocity_range = ful"
bad "map.ini:2: programs 'maybe': unknown; there are: no, yes" "[map]" "programs = maybe"
bad "map.ini:2: stroke 'rimsot': unknown; did you mean 'rimshot'" "[note.60]" "stroke = rimsot"
bad "map.ini:2: radius '101': out of range; allowed: 0 to 100" "[note.60]" "radius = 101"
bad "map.ini:2: angle 'nan': not a number" "[note.60]" "angle = nan"
bad "map.ini:2: speed '0': out of range; allowed: 0.01 to 10" "[note.60]" "speed = 0"
bad "map.ini: \[note.60\] striker 'stik': the drum has no such striker; did you mean 'stick'" \
  "[note.60]" "striker = stik"
bad "map.ini:2: moves 'wires.tensio': unknown" "[controller.1]" "moves = wires.tensio"
bad "map.ini:2: moves 'shell.radius': this key cannot move" "[controller.1]" "moves = shell.radius"
bad "map.ini:2: from: goes behind 'moves = KEY'" "[controller.1]" "from = 1"
bad "map.ini:3: to '-1': out of range; allowed: 0 to 1" "[controller.1]" "moves = wires.strainer" \
  "to = -1"
bad "map.ini:3: section \[note.1\] occurs twice" "[note.1]" "speed = 1" "[note.1]"
bad "map.ini:1: 'x' stands before the first section" "x = 1"
failed "missing.ini: No such file" render --midi-file song.mid --midi-map missing.ini
refused "needs the name of a file" render --midi-file song.mid --midi-map ''
refused "velocity-curve 'x': unknown; there are: soft, linear, hard" render --velocity-curve x
refused "velocity-range 'x': unknown; there are: normal, full" render --velocity-range x
refused "midi-channel '0': out of range; allowed: 1 to 16" render --midi-channel 0
done_quietly render "${short[@]}" --midi-channel omni --duration 0.1 -o omni.wav

# ---- controller 121, and a mask time ----

# Half a second after it, nothing is left of a hand and of expression.
song reset.mid 0 "00 d97f 00 b90b00 10 b97900 8350 992664"
song plain.mid 0 "8360 992664"
done_quietly render tom-12 -q --quality draft --format float --midi-file reset.mid -o reset.wav
done_quietly render tom-12 -q --quality draft --format float --midi-file plain.mid -o plain-again.wav
same_bytes "controller 121 undoes a hand and expression" reset.wav plain-again.wav
song twice.mid 0 "00 992664 01 99261e 8360 992664" # a tick: 5.2 ms
song once.mid 0 "00 992664 8361 992664"
done_quietly render -q --quality draft --format float --midi-file twice.mid -o twice.wav
done_quietly render -q --quality draft --format float --midi-file once.mid -o once.wav
other_bytes "a double trigger sounds" twice.wav once.wav
for mask in 6 400; do
  done_quietly render -q --quality draft --format float --midi-file twice.mid --mask-time $mask -o masked.wav
  same_bytes "a double trigger within $mask ms does not" masked.wav once.wav
done
done_quietly render -q --kit standard --quality draft --format float --midi-file twice.mid --mask-time 6 -o kit-masked.wav
done_quietly render -q --kit standard --quality draft --format float --midi-file once.mid -o kit-once.wav
same_bytes "nor on a kit" kit-masked.wav kit-once.wav
refused "--mask-time '2000'.*0 to 1000" render --midi-file twice.mid --mask-time 2000

# ---- files that are none ----

refused "midi-file needs" render --midi-file ''
failed "missing.mid': No such file" render --midi-file missing.mid
failed "it is a folder" render --midi-file .
refused "larger than 16777216 bytes" render --midi-file /dev/zero
refused "standard input: byte 0: not a Standard MIDI File" render --midi-file - </dev/null
refused "bad.mid: byte 0: not a Standard MIDI File" render --midi-file bad.mid
song bad.mid 2 "00 992664"
refused "bad.mid: byte 8: format 2; allowed: 0 and 1" render --midi-file bad.mid
song song.mid 1 "00 992664" "00 992664"
head -c 40 song.mid >bad.mid
refused "bad.mid: byte 30: the file ends 6 bytes before its chunk of 8 does" render --midi-file bad.mid
head -c 30 song.mid >bad.mid
warned() { # warned WORDS ARGUMENT...: succeeds with one warning, which --strict refuses
  local words=$1
  shift
  run "$@"
  same "status of: $*" 0 "$status"
  check "warning of: $* ($(cat "$err"))" grep -q "warning: $words" "$err"
  refused "$words.*--strict" "$@" --strict
}
warned "bad.mid: byte 10: 2 tracks are announced, 1 are there" render -q --quality draft --midi-file bad.mid -o warned.wav
warned "bad.mid: byte 10: 2 tracks are announced" render -q --kit standard --quality draft --midi-file bad.mid -o warned.wav
warned "bad.mid: byte 10: 2 tracks are announced" play -q --no-ui --quality draft --backend file --midi-file bad.mid --record warned.wav
song bad.mid 0 "00 2664"
refused "bad.mid: byte 23, track 1: data without a status byte" render --midi-file bad.mid
song bad.mid 0 ""
refused "bad.mid: no note in it is a stroke" render --midi-file bad.mid
song bad.mid 0 "00 ff5103ffffff ffffff7f 992664"
refused "bad.mid: its last event comes at .* allowed: up to 3600" render --midi-file bad.mid
song song.mid 0 "00 992664 60 992664"
# The beginning of a song, to the bit.
run render tabor --quality draft --rate 22050 --format float --midi-file song.mid --duration 0.4 -o begun.wav
check "a song goes on after --duration" grep -qx 'what is played goes on until 0.5 s; the sound stops at 0.4 s' "$err"
run play tabor --no-ui --quality draft --rate 22050 --backend file --record beginning.wav --midi-file song.mid --duration 0.4
same "the beginning of a song is played" 0 $status
check "a song goes on after its --duration is played" grep -qx 'what is played goes on until 0.5 s; the sound stops at 0.4 s' "$err"
play whole.wav
same "the beginning" "$(tail -c 35280 begun.wav | md5sum)" "$(tail -c 52920 whole.wav | head -c 35280 | md5sum)"
cp song.mid take.wav
refused "would overwrite the MIDI file 'take.wav'" render --midi-file take.wav -o take.wav
map "[note.60]"
refused "would overwrite the MIDI map" render --midi-file song.mid --midi-map ./map.ini --trace map.ini

finish
