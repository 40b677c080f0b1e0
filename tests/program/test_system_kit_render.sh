#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `tabor render --kit`: a General MIDI track on several drums, its report, its files, and what is refused.
#
# test_system_kit_render.sh GROOVE.MID [brief]: without the groove and the maps, for slow builds.
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
groove=$1 brief=${2-}
cp "$groove" groove.mid
# Bass drum, snare drum, low tom and hi-hat, a quarter of a second apart: 480 ticks a quarter, at 120 quarters a minute.
printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\24\0\231\44\144\201\160\46\144\201\160\55\144\201\160\52\144\0\377\57\0' >song.mid
short=(render --kit standard --midi-file song.mid --quality draft --duration 0.8)

run presets --kits
check "the kits are listed" grep -q '^standard ' "$out"

# ---- one command ----

if [ "$brief" != brief ]; then
  run render --kit standard --midi-file groove.mid --quality draft --duration 8 --json -o groove.wav
  same "status" 0 "$status"
  same "warnings and notes" 0 "$(wc -l <"$err")"
  same "frames" 384000 "$(json frames)"
  strokes=$(for i in 0 1 2 3 4 5 6 7; do echo "$(json "drums.$i.name") $(json "drums.$i.strokes")"; done | tr '\n' ' ')
  same "strokes" 'kick 11 snare 12 high-tom 4 low-tom 3 floor-tom 3 crash 2 ride 0 hihat 22 ' "$strokes"
  holds "a level for use" "$(json peak) > 0.1 && $(json peak) < 1"
fi
run render --kit standard --midi-file groove.mid --quality draft --duration 0.1 --json -o groove.wav
same "strokes within a tenth of a second" "kick 1, snare 0" \
  "$(json drums.0.name) $(json drums.0.strokes), $(json drums.1.name) $(json drums.1.strokes)"

# ---- a kit as text ----

for kit in standard jazz marching frame-drums; do
  run show --kit "$kit"
  same "status of show --kit $kit" 0 "$status"
  cp "$out" shown.ini
  run show --kit ./shown.ini
  check "$kit reads back to the same kit" cmp -s shown.ini "$out"
done
run show --kit standard --set drum.snare.batter.pitch=B3 --set kit.coupling=off --set note.42.sample=hat.wav
check "changes are shown" grep -q '^coupling = off ' "$out"
same "what a preset has is not shown again" 0 "$(grep -c '^batter\.[^p]' "$out")"
check "samples are shown" grep -qx 'sample = hat.wav' "$out"
check "a changed head is shown" grep -q '^batter.pitch = 246.94' "$out"
run show --kit standard --set "note.42.sample=$(printf 'x%.0s' {1..1000}).wav"
same "a path that no kit file holds" "2 1" "$status $(grep -c "note.42.sample: the text is longer than 255 bytes" "$err")"
for key in kit drum.snare.drum; do
  run show --kit standard --set "$key.comment=a ; b"
  same "a text of $key that no kit file holds" "2 0 1" \
    "$status $(wc -l < "$out") $(grep -c "$key.comment: a file cannot hold the text 'a ; b'" "$err")"
done
refused "--kit and 'tom-12': the kit has the drums" show tom-12 --kit jazz
run show tom-12
cp "$out" drum.ini
refused "drum.ini:3: a kit has no section 'drum'; is this file a drum, not a kit?" show --kit ./drum.ini
run show --kit standard
cp "$out" shown.ini
refused "unknown section 'kit'; is this file a kit, not a drum?" show ./shown.ini

# ---- the same sound however it is made ----

run "${short[@]}" --json -o mix.wav
same "one stroke on the hi-hat" "hihat 1" "$(json drums.7.name) $(json drums.7.strokes)"
run "${short[@]}" -o mix.wav
check "a line about the file" grep -q '^mix.wav: kit standard, 0.80 s, 48000 Hz, 2 channels, peak -' "$err"

run render --kit standard --midi-file song.mid --quality draft --duration 0.3 -o begun.wav
check "a song goes on after --duration" grep -q "^what is played goes on until 0.75 s; the sound stops at 0.3 s$" "$err"
run "${short[@]}" --normalize --verbose -o loud.wav
check "the mix can be normalized" grep -q '^loud.wav: kit standard, .*, peak -1.0 dBFS$' "$err"
check "its energy is told" grep -q '^energy in J: injected ' "$err"
done_quietly "${short[@]}" -q -o folder/
same_bytes "in a folder" mix.wav folder/standard.wav
done_quietly "${short[@]}" -q --stereo -o stereo.wav
same_bytes "its mix is stereo as it is" mix.wav stereo.wav

done_quietly "${short[@]}" -q -o again.wav
done_quietly render --kit ./shown.ini "${short[@]:3}" -q -o shown.wav
same_bytes "the kit that was shown" mix.wav shown.wav
same_bytes "twice" mix.wav again.wav
done_quietly "${short[@]}" -q --jobs 1 -o jobs.wav
same_bytes "on one thread" mix.wav jobs.wav
done_quietly "${short[@]}" -q --set kit.coupling=off -o alone.wav
other_bytes "drums hear each other" mix.wav alone.wav
done_quietly "${short[@]}" -q --split --format float -o take.wav
same "a file for each drum" "take-crash.wav take-floor-tom.wav take-high-tom.wav take-hihat.wav take-kick.wav take-low-tom.wav take-ride.wav take-snare.wav" "$(echo take-*)"

# A kit file with what is built in is the same kit.
sed 's/^name = .*/name = mine/' "$(dirname "$groove")/../kits/standard.ini" >mine.ini
done_quietly render --kit ./mine.ini --midi-file song.mid --quality draft --duration 0.8 -q -o file.wav
same_bytes "from a file" mix.wav file.wav

# A track for a kit on one drum: half of it is lost, and the program says what to do.
printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\13\0\231\46\144\0\52\144\0\377\57\0' >half.mid
run render frame-drum --midi-file half.mid --quality draft --duration 0.1 -o one.wav
check "the kit is recommended" grep -q -- '--kit standard' "$err"

# A sound file stands for the hi-hat; the note is not passed over any more.
done_quietly render frame-drum --quality draft --duration 0.2 -q -o hat.wav
{ cat mine.ini; printf '[note.42]\nsample = hat.wav\ngain = -6\nchoke = 1\n'; } >hat.ini
done_quietly render --kit ./hat.ini --midi-file song.mid --quality draft --duration 1.2 -q -o hats.wav
run render --kit standard --set note.42.sample=hat.wav --set note.42.gain=-6 --midi-file song.mid --quality draft --duration 1.2 -o set.wav
same "no note is passed over" 0 "$(grep -c 'no drum of the kit' "$err")"
same_bytes "on the command line as in the file" hats.wav set.wav
done_quietly render --kit ./mine.ini --midi-file song.mid --quality draft --duration 1.2 -q -o none.wav
other_bytes "it is heard" hats.wav none.wav

# ---- strokes that are written down ----

# The notes of the song, as the program plays them; in other orders of columns and of rows.
cat >strokes.csv <<'END'
velocity,drum,time,technique,id,hold
3,kick,0,,,
,snare,0.25,,,
2,"low-tom",0.5,,,
1.5,snare,0.6,buzz,7,0.1
END
strokes=(render --kit standard --quality draft --duration 0.8 -q)
done_quietly "${strokes[@]}" --events strokes.csv -o rows.wav
{ head -n 1 strokes.csv; tail -n +2 strokes.csv | tac; } >turned.csv
done_quietly "${strokes[@]}" --events turned.csv -o turned.wav
same_bytes "in any order of rows" rows.wav turned.wav
done_quietly "${strokes[@]}" --strike drum=kick,velocity=3 --strike time=0.25,drum=snare --strike time=0.5,drum=low-tom,velocity=2 \
  --strike id=7,velocity=1.5,time=0.6,hold=0.1,technique=buzz,drum=snare -o fields.wav
same_bytes "as fields" rows.wav fields.wav
done_quietly "${strokes[@]}" --events strokes.csv --each -o each/
same_bytes "a sound for each file" rows.wav each/standard-strokes.wav
run "${short[@]}" --events strokes.csv --json -o both.wav
same "beside a song" "kick 2, snare 3" "$(json drums.0.name) $(json drums.0.strokes), $(json drums.1.name) $(json drums.1.strokes)"
done_quietly play --kit standard --backend file --quality draft --humanize 0 --events strokes.csv --midi-file song.mid --duration 0.8 \
  -q --record played.wav
same_bytes "played as they are rendered" both.wav played.wav

# ---- maps by name ----

maps_by_name() {
  # The rim of Roland's second tom, its closed hi-hat's edge and a note that it has not.
  printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\24\0\231\44\144\201\160\57\144\201\160\26\144\201\160\74\144\0\377\57\0' >roland.mid
  mapped=(render --kit standard --midi-file roland.mid --quality draft --duration 0.8)
  run "${mapped[@]}" --map roland --json -o roland.wav
  same "status" 0 "$status"
  same "the rim plays its tom" "low-tom 1" "$(json drums.3.name) $(json drums.3.strokes)"
  same "the hi-hat's edge plays the hi-hat" "hihat 1" "$(json drums.7.name) $(json drums.7.strokes)"
  check "notes that play nothing are named" grep -q 'no drum of the kit: 60 (1)$' "$err"
  done_quietly "${mapped[@]}" -q -o general.wav
  other_bytes "a rimshot, not a stroke on the head" roland.wav general.wav
  run "${mapped[@]}" --map roland --set note.42.sample=hat.wav -o edge.wav
  check "a sample stands for the hi-hat's edge" grep -q 'no drum of the kit: 60 (1)$' "$err"
  other_bytes "it is heard" roland.wav edge.wav
  for map in alesis yamaha superior addictive; do done_quietly "${short[@]}" -q --map $map -o $map.wav; done
  same_bytes "plain notes of a module are General MIDI's" mix.wav alesis.wav

  # The place of a stroke comes before its note: 16 is the snare drum's, 18 the toms'.
  place() { printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\17\0\271'"$1"'\0\0\231\46\144\0\55\144\0\377\57\0' >place.mid; }
  placed=(render --kit standard --midi-file place.mid --quality draft --duration 0.3 -q --split)
  place '\21'
  done_quietly "${placed[@]}" --set kit.coupling=off --map roland -o none.wav
  place '\20'
  done_quietly "${placed[@]}" --set kit.coupling=off --map roland -o snare.wav
  other_bytes "16 moves the snare drum" none-snare.wav snare-snare.wav
  same_bytes "16 does not move the tom" none-low-tom.wav snare-low-tom.wav
  done_quietly "${placed[@]}" --set kit.coupling=off --map roland --place-cc 17,16 -o chosen.wav
  same_bytes "another controller, the snare drum" none-snare.wav chosen-snare.wav
  other_bytes "another controller, the tom" none-low-tom.wav chosen-low-tom.wav
}
if [ "$brief" != brief ]; then maps_by_name; fi

# ---- refused ----

refused "--map 'rolnd': unknown; did you mean 'roland'.*there are: roland, yamaha, alesis, superior, addictive" "${short[@]}" --map rolnd
refused "--map needs --kit" render tom-12 --map roland
refused "--map needs --kit" play tom-12 --map roland
refused "--place-cc needs --map" "${short[@]}" --place-cc 17
refused "--place-cc = 120|--place-cc.*120" "${short[@]}" --map roland --place-cc 16,120

printf '[note.42]\nsample = hat.wav\npitch = 2\n' >wrong.ini
refused "wrong.ini:3: 'note.42.pitch': allowed are" render --kit ./wrong.ini --midi-file song.mid
refused "note.0 to note.127" "${short[@]}" --set note.128.sample=hat.wav
run "${short[@]}" --set note.42.sample=hat.wav --rate 44100 -o rate.wav
same "a sample at another rate" 0 "$status"
failed "cannot read 'none.flac'" "${short[@]}" --set note.42.sample=none.flac

refused "unknown kit 'standart'.*did you mean 'standard'" render --kit standart --midi-file song.mid
refused "--kit needs what to play: --midi-file, --events or --strike" render --kit standard
refused "--replay and --kit" render --kit standard --replay take.log
refused "--kit and --trace" "${short[@]}" --trace trace.csv
refused "--strike drum: a kit's stroke needs one; there are: kick, snare," "${short[@]}" --strike time=0
refused "--strike drum 'snar': the kit has no such drum; did you mean 'snare'" "${short[@]}" --strike drum=snar
refused "--strike drum: given twice" "${short[@]}" --strike drum=snare,drum=kick
refused "--strike drum: only a kit's strokes have one" render tom-12 --strike drum=snare
refused "--strike radius '0.25': out of range" "${short[@]}" --strike drum=snare,radius=0.25
printf 'time,drum\n0,snare\n0.1,\n' >nobody.csv
refused "nobody.csv:3: drum: a kit's stroke needs one" "${short[@]}" --events nobody.csv
refused "too short; the last stroke comes at 3 s" render --kit standard --strike drum=snare,time=3 --duration 1
refused "--events - and --midi-file -" render --kit standard --midi-file - --events -
refused "--kit and 'tom-12'" render tom-12 --kit standard --midi-file song.mid
refused "a kit has no key 'kit.couplng'; did you mean 'coupling'" "${short[@]}" --set kit.couplng=off
refused "a kit has no key 'drum.snare.hight'; did you mean 'height'" "${short[@]}" --set drum.snare.hight=1
refused "a kit has no key 'batter.pitch', but its drums have: 'drum.NAME.batter.pitch'" "${short[@]}" --set batter.pitch=E3
refused "no drum 'snar'" "${short[@]}" --set drum.snar.x=1
refused "drum.snare: batter.tension = 1 is outside 100 to 20000" "${short[@]}" --set drum.snare.batter.tension=1
refused "note 36 plays both" "${short[@]}" --set drum.snare.rim=36
refused "-o 'mix.txt'" "${short[@]}" -o mix.txt
cp song.mid song.wav
cp hat.wav kept.wav
refused "would overwrite the sample 'kept.wav'" "${short[@]}" --set note.42.sample=kept.wav -o kept.wav
refused "would overwrite the MIDI file 'song.wav'" render --kit standard --midi-file song.wav -o song.wav
printf '[drum.a]\npreset = tom-12\nhaed = 38\n' >bad.ini
refused "bad.ini:3: .*haed" render --kit ./bad.ini --midi-file song.mid
printf '[kit]\nname = empty\n' >empty.ini
refused "no drum" render --kit ./empty.ini --midi-file song.mid
failed "cannot|No such file" render --kit standard --midi-file missing.mid

finish
