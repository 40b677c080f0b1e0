#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render --events: strokes from a file, as people and spreadsheets write them.

. "$(dirname "$0")/../support/host_checks.sh"

short=(tabor -q --quality draft --duration 0.3 --format float --set shell.mass=0.5)

# render_events NAME ARGUMENT...: renders strokes.csv without a word.
render_events() {
  local name=$1
  shift
  done_quietly render "${short[@]}" --events strokes.csv -o "$name" "$@"
}

# ---- the same as --strike ----

# a buzz is a stroke that is pressed, and lifted after half a second or when the hand strikes again
render_strikes strikes.wav technique=buzz,pressure=0.3,id=1 time=0.1,technique=buzz,id=1,hold=0.2 \
  time=0.2,event=press,pressure=0.9,id=1
cat >strokes.csv <<'END'
time,technique,pressure,id,hold,event
0,,,1,,strike
0,,0.3,1,,press
0.1,,,,,release
0.1,,,1,,
0.1,,0,1,,press
0.2,,0.9,,,press
0.3,,,1,,release
END
render_events events.wav
same_bytes "a buzz, pressed harder and lifted" strikes.wav events.wav

# what a drum cannot do is said for what it is: a press or a move of nothing, a striker too many
drops() {
  run render snare-14x5.5 -q --quality draft --duration 0.3 --events strokes.csv -o dropped.wav
  same "status" 0 "$status"
  sed 's/^tabor: warning: //; s/ in play, or a hand.*//' "$err"
}
nothing_met="events were dropped: a press or a move met no such stick or brush"
printf 'time,technique,velocity,pressure,id,event\n0,buzz,1.5,0,1,\n0.2,,,0.6,7,press\n0.2,,,,1,move\n' >strokes.csv
same "a press of no stick, a move of no brush" "2 $nothing_met" "$(drops)"
printf 'time,technique,velocity,pressure,id,event\n0,buzz,1.5,0,1,\n0.2,,,0.6,1,press\n' >strokes.csv
same "a press of a stick" "" "$(drops)"
{
  printf 'time,technique,id,event\n'
  for id in {1..11}; do printf '0,buzz,%s,\n' "$id"; done
} >strokes.csv
same "strikers too many" "3 strokes were dropped: more than 8 strikers at once" "$(drops)"
printf '0.1,,99,press\n' >>strokes.csv
same "both" "3 strokes were dropped: more than 8 strikers at once
1 $nothing_met" "$(drops)"

# A rim at rest says that it is silent.
run render frame-drum -q --quality draft --duration 0.3 --strike technique=rim -o rim.wav
check "a silent rim" grep -q "^tabor: warning: the hoop is silent under 1 stroke: the shell of 'frame-drum' has no mass" "$err"
run render tom-12 -q --quality draft --duration 0.3 --strike technique=rim -o rim.wav
same "one that sounds" "" "$(cat "$err")"

render_strikes strikes.wav technique=rimshot time=0.1,technique=cross-stick,radius=60% time=0.2,technique=rim
cat >strokes.csv <<'END'
time,technique,radius
0,rimshot,
0.1,cross-stick,60%
0.2,rim,
END
render_events events.wav
same_bytes "strokes on the hoop" strikes.wav events.wav

# rows say where a brush is; a sweep lasts as long as its way, in whatever order its rows come
render_way() {
  done_quietly render snare-14x5.5 -q --quality draft --duration 0.7 --events strokes.csv -o "$1"
}
cat >strokes.csv <<'END'
time,technique,striker,radius,angle,id,hold,event
0,sweep,brush,30%,0,1,0.6,
0.3,,,70%,90,1,,move
0.6,,,20%,180,1,,move
END
render_way way.wav
cat >strokes.csv <<'END'
time,technique,striker,radius,angle,id,event
0.6,,,20%,180,1,move
0.3,,,70%,90,,move
0,sweep,brush,30%,0,1,
END
render_way rows.wav
same_bytes "a brush's way" way.wav rows.wav
sed -i /0.3,/d strokes.csv
render_way rows.wav
other_bytes "a place left out of a brush's way" way.wav rows.wav

render_strikes strikes.wav time=0,velocity=1,radius=20%,angle=10,striker=stick,technique=normal \
  time=0.1,velocity=3 time=0.2,midi=100,radius=0.05
cat >strokes.csv <<'END'
time,velocity,midi,radius,angle,striker,technique
0,1,,20%,10,stick,normal
0.1,3,,,,,
0.2,,100,0.05,,,
END
render_events events.wav
same_bytes "all columns" strikes.wav events.wav
cat strokes.csv >good.csv
{ head -n 1 good.csv && tail -n +2 good.csv | tac; } >strokes.csv
render_events events.wav
same_bytes "lines in any order of time" strikes.wav events.wav
cat >strokes.csv <<'END'
# a comment

  # another
 technique , "time",striker,midi ,velocity,	angle,radius
"normal",0,"stick",,1 , 10,20%
   
,0.1,,,"3",,
,,,,,,
# in between
,2e-1,,100,,,"0.05"
,,,,,,
END
render_events events.wav
same_bytes "columns in any order, blanks, quotes, comments" strikes.wav events.wav
cp strokes.csv plain.csv
sed 's/$/\r/' plain.csv >strokes.csv
render_events events.wav
same_bytes "CR LF" strikes.wav events.wav
{ printf '\357\273\277' && sed 's/$/\r/' plain.csv; } >strokes.csv
render_events events.wav
same_bytes "a byte order mark" strikes.wav events.wav
printf '%s' "$(cat plain.csv)" >strokes.csv
render_events events.wav
same_bytes "no line end at the end" strikes.wav events.wav

done_quietly render "${short[@]}" --events - -o events.wav <good.csv
same_bytes "standard input" strikes.wav events.wav
done_quietly render "${short[@]}" --events <(cat good.csv) -o events.wav
same_bytes "a pipe" strikes.wav events.wav

printf 'time\n0.1\n' >strokes.csv
render_strikes strikes.wav time=0.1
render_events events.wav
same_bytes "the preset's stroke where nothing else is said" strikes.wav events.wav
printf 'velocity\n1\n' >strokes.csv
render_strikes strikes.wav velocity=1
render_events events.wav
same_bytes "time 0 where nothing else is said" strikes.wav events.wav

render_strikes strikes.wav time=0.2,velocity=1 time=0,velocity=2 time=0.1
printf 'velocity,time\n1,0.2\n,0.1\n' >strokes.csv
render_events events.wav --strike time=0,velocity=2
same_bytes "with --strike" strikes.wav events.wav
cp strikes.wav both.wav
printf 'time,velocity\n0,2\n' >second.csv
render_events events.wav --events second.csv
same_bytes "with a second --events" both.wav events.wav

{ echo time && for ((i = 0; i < 100000; i++)); do echo "0.0$((i % 10))"; done; } >strokes.csv
run render tabor -q --quality draft --duration 0.1 --events strokes.csv -o many.wav
same "100,000 strokes" 0 "$status"
echo 0 >>strokes.csv
refused "strokes.csv:100002: too many strokes; allowed: up to 100000" render --events strokes.csv

# ---- what is wrong ----

# bad PATTERN LINE...: a file of these lines is refused.
bad() {
  local pattern=$1
  shift
  printf '%s\n' "$@" >bad.csv
  refused "$pattern" render --events bad.csv
}
refused "--events needs" render --events ''
failed "missing.csv': No such file" render --events missing.csv
failed "cannot read '.': it is a folder" render --events .
if [ "$(id -u)" != 0 ]; then
  cp good.csv secret.csv
  chmod 0 secret.csv
  failed "Permission denied" render --events secret.csv
  rm -f secret.csv
fi
: >bad.csv
refused "bad.csv: the file holds no stroke" render --events bad.csv
refused "standard input: the file holds no stroke" render --events - </dev/null
failed "standard input" render --events - <&-
bad "bad.csv: the file holds no stroke" "time,velocity" "# nothing" ""
refused "larger than 8388608 bytes" render --events /dev/zero
{ cat good.csv && printf '0,1\0,,,,,\n'; } >bad.csv
refused "bad.csv: not a text" render --events bad.csv
bad "bad.csv:1: unknown column 'velocty'; did you mean 'velocity'" time,velocty 0,1
bad "bad.csv:1: unknown column 'foo'; there are: time, velocity, midi" time,foo 0,1
bad "bad.csv:3: unknown column '0'" "" "# no header" 0,1
bad "bad.csv:1: unknown column ''" time, 0,
bad "bad.csv:1: unknown column 'time;velocity'" 'time;velocity' '0;1'
bad "bad.csv:1: the column 'time' occurs twice" time,velocity,time 0,1,0
bad "bad.csv:3: fields: 1; the header names 2" time,velocity 0,1 0
bad "bad.csv:2: fields: 3; the header names 2" time,velocity 0,1,
bad "bad.csv:2: fields: 4; the header names 2" time,velocity 0,5,1,5
bad "bad.csv:2: a quote is not closed" time '"0'
bad "bad.csv:2: text follows a closing quote" time '"0"1'
bad "bad.csv:2: time '\"'" time '""""'
bad "bad.csv:2: midi: given twice \(midi is a velocity" time,velocity,midi 0,1,64
bad "bad.csv:2: time '-0.1': out of range; allowed: 0 to 3600" time -0.1
bad "bad.csv:2: time '3601'" time 3601
bad "bad.csv:4: velocity '31': out of range; allowed: 0.01 to 30" velocity 1 "# c" 31
bad "bad.csv:2: velocity 'fast': not a number" velocity fast
bad "bad.csv:2: velocity 'nan'" velocity nan
bad "bad.csv:2: midi '128'.*allowed: 1 to 127" midi 128
bad "bad.csv:2: midi '1.5': not a whole number" midi 1.5
bad "bad.csv:2: angle '361'" angle 361
bad "bad.csv:2: radius '0.6'" radius 0.6
bad "bad.csv:2: radius in per cent '101'.*allowed: 0 to 100" radius 101%
bad "bad.csv:2: striker 'stik'.*did you mean 'stick'" striker stik
bad "bad.csv:2: technique 'norml'.*did you mean 'normal'" technique norml
bad "bad.csv:2: event 'pres': unknown.*did you mean 'press'" event pres
bad "bad.csv:2: technique 'sweep': striker 'stick' is no brush" technique sweep
bad "bad.csv:2: velocity '6': out of range for a sweep; allowed: 0.01 to 5$" technique,striker,velocity sweep,brush,6
bad "bad.csv:2: pressure '1.1'.*allowed: 0 to 1" pressure 1.1
bad "bad.csv:2: hold '0'.*allowed: 0.001 to 60" hold 0
bad "bad.csv:2: id '-1'.*allowed: 0 to 1000000" id -1
bad "bad.csv:2: striker: the value is too long" striker "$(printf 's%.0s' {1..5000})"
bad "unknown column" "$(printf 's%.0s' {1..5000})"
bad "bad.csv:1: the column 'time' occurs twice" "time$(printf ',time%.0s' {1..5000})x"
printf 'time\n2\n1\n' >bad.csv
refused "the last stroke comes at 2 s" render --events bad.csv --duration 1.5

# A file of strokes is not overwritten by their sound.
cp good.csv take.wav
refused "would overwrite the events 'take.wav'" render --events take.wav -o take.wav
refused "would overwrite the events 'take.wav'" render --events take.wav --trace ./take.wav
cp good.csv take-far.wav
refused "would overwrite the events 'take-far.wav'" render --events take-far.wav --split -o take.wav

finish
