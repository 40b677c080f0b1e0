#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `tabor play --kit`: a MIDI file on a kit, on a device that is not heard, and what is refused.
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
# Bass drum, snare drum, low tom and hi-hat with a tambourine, which no kit has, a quarter of a second apart: 480 ticks a quarter, at 120 quarters a minute.
printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\27\0\231\44\144\201\160\46\144\201\160\55\144\201\160\52\144\0\66\144\0\377\57\0' >song.mid
short=(play --kit standard --backend null --quality draft)

run "${short[@]}" --duration 1 --midi-file song.mid --json
same "status" 0 "$status"
strokes=$(for i in 0 1 2 3 4 7; do echo "$(json "drums.$i.name") $(json "drums.$i.strokes")"; done | tr '\n' ' ')
same "strokes" 'kick 1 snare 1 high-tom 0 low-tom 1 floor-tom 0 hihat 1 ' "$strokes"
same "length" 1.0 "$(json seconds)"
holds "it is heard" "$(json peak) > 0.01"
check "a tambourine is named" grep -q '54 tambourine (1)$' "$err"

# The rim of a module's second tom.
printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\10\0\231\57\144\0\377\57\0' >rim.mid
run "${short[@]}" --duration 0.3 --midi-file rim.mid --map roland --json
same "a map by name" "low-tom 1" "$(json drums.3.name) $(json drums.3.strokes)"
refused "--map 'x': unknown; there are: roland" "${short[@]}" --map x

# What is played is recorded, on a device and without one, with the same bits as it is rendered.
"$TABOR" render --kit standard --quality draft --midi-file song.mid --duration 0.7 --format float -o rendered.wav -q
for backend in null file; do
  run play --kit standard --backend $backend --quality draft --humanize 0 --midi-file song.mid --duration 0.7 --format float --record $backend.wav
  same "status of $backend" 0 "$status"
  check "$backend says where" grep -q "recorded in $backend.wav" "$err"
  same "bits of $backend" "$(sha256sum <rendered.wav)" "$(sha256sum <$backend.wav)"
done

# Ctrl-C ends it.
"$TABOR" "${short[@]}" >"$out" 2>"$err" &
child=$!
check "it plays" wait_for catches $child 2
kill -INT $child
wait $child
same "status after SIGINT" 130 $?

refused "unknown kit" play --kit standart --backend null
refused "--kit and 'tom-12'" play tom-12 --kit standard --backend null
refused "needs --record" play --kit standard --backend file --duration 1
refused "--midi-in" play --kit standard --backend file --duration 1 --record take.wav --midi-in all
cp song.mid song.wav
refused "would overwrite the MIDI file" "${short[@]}" --midi-file song.wav --record song.wav
refused "--device: only" play --kit standard --backend file --duration 1 --record take.wav --device x
refused "--device: only" "${short[@]}" --device 'JACK: system'
refused "no drum 'snar'" "${short[@]}" --set drum.snar.x=1

finish
