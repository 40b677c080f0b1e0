#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# play without a sound card: into a file, against a clock, interrupted, onto a full disk.

. "$(dirname "$0")/../support/host_checks.sh"

# No server of somebody else's: what there is must not matter.
export JACK_NO_START_SERVER=1 JACK_DEFAULT_SERVER=tabor-test-none-$$

strokes='time,velocity,radius
0,2.5,30%
0.02,1,
0.02,2,5%
0.1234,0.5,80%
0.3,6,50%'
printf '%s\n' "$strokes" | tee strokes.csv >strokes.wav

# play_file NAME ARGUMENT...: the frame drum into a file, as fast as can be.
play_file() {
  local name=$1
  shift
  done_quietly play frame-drum -q --backend file --record "$name" --events strokes.csv \
    --quality draft --humanize 0 "$@"
}
render() {
  local name=$1
  shift
  done_quietly render frame-drum -q -o "$name" --events strokes.csv --quality draft "$@"
}

# ---- the same sound as render's ----

render rendered.wav --duration 0.5
for buffer in 16 17 64 128 1000 4096; do
  play_file "buffer-$buffer.wav" --duration 0.5 --buffer "$buffer"
  check "--backend file with --buffer $buffer is render's sound" cmp rendered.wav "buffer-$buffer.wav"
done
render whole.wav
play_file whole-played.wav
check "without --duration both end where the drum has died away" cmp whole.wav whole-played.wav
render stereo.au --mic far --mic top --gain -7.5 --format float --rate 44100
play_file stereo-played.au --mic far --mic top --gain -7.5 --format float --rate 44100
check "microphones, gain, rate, format" cmp stereo.au stereo-played.au
done_quietly render frame-drum -q -o scattered.wav --events strokes.csv --quality draft \
  --humanize 0.5 --seed 5
done_quietly play frame-drum -q --backend file --record scattered-played.wav --events strokes.csv \
  --quality draft --seed 5
check "strokes are scattered as render --humanize 0.5 does" cmp scattered.wav scattered-played.wav
done_quietly render frame-drum -q -o live.wav --quality live
done_quietly play frame-drum -q --backend file --record live-played.wav --humanize 0
check "the default quality is live; without events it is the preset's stroke" cmp live.wav live-played.wav

# a press of nothing is no stroke too many
printf 'time,pressure,id,event\n0,,,\n0.1,0.6,7,press\n' >presses.csv
run play frame-drum -q --backend file --record pressed.wav --events presses.csv --quality draft --duration 0.3
same "a press of no stick" "0 tabor: warning: 1 events were dropped: too many at once, or a press or a move met nothing in play" \
  "$status $(cat "$err")"

# A song with gains, a live parameter, silence and two changes of the preset, which the sound waits for.
track="00992660 20 99267f 08 b91420 10 b90740 18 992450 30 c901 18 992664 20 b97800 02 99287f 30 b9077f"
track+=" 18 c900 04 992670 40 99265a 00 ff2f00"
hex=$(tr -d ' ' <<<"4d546864 00000006 0000 0001 0060 4d54726b $(printf '%08x' $(($(tr -d ' \n' <<<"$track" | wc -c) / 2))) $track")
# shellcheck disable=SC2059
printf "$(sed 's/../\\x&/g' <<<"$hex")" >song.mid
done_quietly render tabor -q -o song.wav --midi-file song.mid --quality draft
for buffer in 16 333 4096; do
  done_quietly play tabor -q --backend file --record song-played.wav --midi-file song.mid --quality draft \
    --humanize 0 --buffer "$buffer"
  check "a song with --buffer $buffer is render's sound" cmp song.wav song-played.wav
done

# ---- against a clock ----

run play frame-drum --backend null --events strokes.csv --quality draft --humanize 0 --duration 0.5 \
  --record clock.wav --json
same "status of a performance" 0 "$status"
check "--backend null records the same sound" cmp rendered.wav clock.wav
same "strokes" 5 "$(json strokes)"
same "frames" 24000 "$(json frames)"
same "dropped" 0 "$(json dropped)"
same "late" 0 "$(json late)"
same "recovered" 0 "$(json recovered)"
same "backend" null "$(json device.backend)"
same "buffer" 128 "$(json device.buffer)"
same "file" clock.wav "$(json recording.file)"
same "lost frames" 0 "$(json recording.lost_frames)"
holds "a latency of one block and one more: $(json device.latency)" \
  "$(json device.latency) > 0.00533 && $(json device.latency) < 0.00534"
check "it says what it plays on" grep -q "frame-drum on 'null': 48000 Hz, 128 frames at once, 5.3 ms" "$err"
run play frame-drum --backend null --quality draft --duration 0.1 -q
same "-q says nothing" "" "$(cat "$err" "$out")"

run play frame-drum --backend file --record clipped.wav --gain 40 --events strokes.csv --quality draft
same "status of a clipped performance" 0 "$status"
check "clipping is said, with the gain that avoids it" grep -qE \
  'warning: [0-9]+ samples were clipped: the peak was \+[0-9.]+ dBFS; --gain [-0-9.]+ avoids it' "$err"
gain=$(sed -nE 's/.*--gain ([-0-9.]+) avoids.*/\1/p' "$err")
run play frame-drum --backend file --record clipped.wav --gain "$gain" --events strokes.csv --quality draft
same "the gain that was named avoids it" "" "$(grep clipped: "$err")"

# ---- signals ----

for signal in INT TERM HUP; do
  : >"$err"
  "$TABOR" play frame-drum --backend null --events strokes.csv --quality draft \
    --record "$signal.wav" </dev/null >"$out" 2>"$err" &
  pid=$!
  check "the performance begins" wait_for grep -q "frames at once" "$err"
  check "a stroke is recorded" wait_for recorded 0.1 3
  kill -$signal "$pid"
  kill -$signal "$pid" # as timeout(1) does
  wait "$pid"
  status=$?
  same "status after SIG$signal" $((128 + $(kill -l $signal))) "$status"
  check "the recording is whole after SIG$signal" "$INSPECT" peak "$signal.wav" >"$out"
  holds "something was recorded: $(cat "$out")" "$(cat "$out") > 0.001"
  same "nothing is left beside" "" "$(find . -name '.tabor-*' -o -name '*.part*')"
done

# ---- disks ----

(
  ulimit -f 40
  "$TABOR" play frame-drum --backend null --events strokes.csv --quality draft --duration 0.6 \
    --humanize 0 --record full.wav </dev/null >"$out" 2>"$err"
)
same "status after a full disk" 1 $?
same "it is said once" 1 "$(grep -c "cannot write 'full.wav'" "$err")"
check "playing goes on" grep -q '^0.6 s, 5 strokes' "$err"
frames=$("$INSPECT" sound full.wav | cut -d' ' -f5)
holds "the file is good up to there: $frames frames" "$frames > 10000 && $frames < 13700"
render long.wav --duration 0.6
"$TABOR" analyze full.wav >"$out" 2>"$err"
same "the file can be read" 0 $?
head -c $((frames * 3)) <(tail -c +45 long.wav) >expected.raw
head -c $((frames * 3)) <(tail -c +45 full.wav) >recorded.raw
check "and holds what was played" cmp expected.raw recorded.raw

if [ -w /dev/full ]; then
  run play frame-drum --backend null --quality draft --duration 0.1 --record /dev/full
  same "status with /dev/full" 1 "$status"
  check "/dev/full is said" grep -q "cannot write '/dev/full': No space left" "$err"
  same "and not that something was recorded" 0 "$(grep -c "recorded in" "$err")"
  run play frame-drum --backend null --quality draft --duration 0.1 --record /dev/full --json
  same "all frames are lost" "$(json frames)" "$(json recording.lost_frames)"
fi

# ---- wrong requests ----

refused "--backend 'nul': unknown; did you mean 'null'" play --backend nul
refused '--backend file needs --record' play --backend file
refused '--device: only --backend portaudio' play --backend null --device x
refused "--buffer '15': out of range; allowed: 16 to 4096" play --buffer 15
refused "--buffer '4097'" play --buffer 4097
refused "--buffer '64.5'" play --buffer 64.5
refused "--rate '8000'" play --backend null --rate 8000
refused "--duration '0'" play --backend null --duration 0
refused "--duration '0.2': too short; the last stroke comes at " play --backend null --events strokes.csv \
  --duration 0.2
refused "--duration '0.2': too short; the last stroke comes at " play --backend file --record x.wav \
  --events strokes.csv --duration 0.2
refused "--quality 'best'" play --quality best
refused "--gain 'loud'" play --gain loud
refused "--mic 'nope': the drum has no such microphone" play --mic nope
refused "unknown key 'batter.tensoin'" play --set batter.tensoin=3
refused "--record 'x.flac': the name must end in .wav or .au" play --backend null --record x.flac
refused "--record 'x': the name must end" play --backend null --record x
refused "--record '-'" play --backend null --record -
refused "the recording would overwrite the events 'strokes.wav'" play --backend null \
  --events strokes.wav --record strokes.wav
refused "unknown preset 'nosuch'" play nosuch --backend null
refused "the file holds no stroke" play --backend null --events /dev/null
failed "cannot read 'nosuch.csv'" play --backend null --events nosuch.csv
failed "cannot write 'no/such/x.wav'" play --backend null --duration 0.1 --record no/such/x.wav
failed "exists and is not overwritten" play --backend null --duration 0.1 --record clock.wav -n

# ---- no device ----

"$TABOR" devices --json >"$out" 2>"$err"
same "status of devices" 0 $?
same "devices prints nothing but facts" "" "$(cat "$err")"
same "of sound and MIDI" "devices midi_inputs" "$(json keys)"
same "no device" 0 "$(json devices.size)"
failed 'there is no sound output; --backend null plays without one' play
failed 'there is no sound output' play --device 'ALSA: hw'
run devices
same "status of devices without any" 0 "$status"
check "devices says that there is none" grep -q 'there is no sound output' "$err"

finish
