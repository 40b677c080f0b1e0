#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# play --log keeps a performance, render --replay gives it again to the bit.
#
# test_system_replay.sh [SECONDS of random playing against a clock]

. "$(dirname "$0")/../support/host_checks.sh"
: "${TYPIST:?host_typist}"
seconds=${1:-6} seed=5
export JACK_NO_START_SERVER=1 JACK_DEFAULT_SERVER=tabor-test-none-$$ TERM=xterm

cat >strokes.csv <<'END'
time,velocity,radius,technique,pressure,id,event
0,2.5,30%,,,,
0.02,1,,rim,,,
0.1234,0.5,80%,buzz,0.2,1,
0.2,,,,0.6,1,press
0.28,,,,,,release
0.3,6,50%,rimshot,,,
0.35,2,60%,cross-stick,,,
END

# replayed NAME ARGUMENT...: the log NAME.log gives the sound NAME-EXTENSION again.
replayed() {
  local what=$1 name=$2
  shift 2
  done_quietly render -q --replay take.log -o "again-$name" "$@"
  check "$what" cmp "$name" "again-$name"
}

# ---- strokes, at every size of blocks ----

for buffer in 16 333 4096; do
  done_quietly play tabor -q --backend file --record take.wav --log take.log --events strokes.csv --quality draft \
    --buffer "$buffer"
  replayed "strokes, --buffer $buffer" take.wav
done
replayed_frames=$("$INSPECT" sound again-take.wav | cut -d' ' -f5)
same "frames of the log" "{\"frames\":$replayed_frames,\"lost\":0}" "$(tail -n 1 take.log)"
same "events of the log" 8 "$(grep -c '"event"' take.log)"

# What a drum can have besides: other microphones, rate, quality, parameters, gain, length, format.
done_quietly play frame-drum -q --backend file --record take.au --format float --log take.log --events strokes.csv \
  --mic far --mic top --mic far --gain -7.5 --rate 44100 --quality studio --set batter.tension=2900 --duration 0.7
replayed "microphones, gain, rate, quality, --set, --duration" take.au --format float
same "the log has the gain" 1 "$(grep -c '"gain":0.4216965034285822' take.log)"

# Integers saturate as the recording does; a float rendering does not.
run play tabor -q --backend file --record take.wav --log take.log --gain 30 --quality draft
check "this performance is clipped" grep -q clipped "$err"
run render -q --replay take.log -o again-take.wav
same "status of a replay that saturates" 0 "$status"
check "clipped samples" cmp take.wav again-take.wav
run render -q --replay take.log -o unclipped.wav --format float
holds "a float rendering goes beyond full scale" "$("$INSPECT" peak unclipped.wav) > 1"

# A song with gains, a live parameter, silence and two changes of the preset.
track="00992660 20 99267f 08 b91420 10 b90740 18 992450 30 c901 18 992664 20 b97800 02 99287f 30 b9077f"
track+=" 18 c900 04 992670 40 99265a 00 ff2f00"
hex=$(tr -d ' ' <<<"4d546864 00000006 0000 0001 0060 4d54726b $(printf '%08x' $(($(tr -d ' \n' <<<"$track" | wc -c) / 2))) $track")
# shellcheck disable=SC2059
printf "$(sed 's/../\\x&/g' <<<"$hex")" >song.mid
for buffer in 16 4096; do
  done_quietly play snare-14x5.5 -q --backend file --record take.wav --log take.log --midi-file song.mid \
    --quality draft --buffer "$buffer"
  replayed "a song, --buffer $buffer" take.wav
done
done_quietly play tabor -q --backend file --record roomy.wav --log take.log --midi-file song.mid --quality draft \
  --set room.kind=studio --mic left --mic right
replayed "a song in a room" roomy.wav
same "the room is in the log" 1 "$(head -n 1 take.log | grep -c '"room.kind = studio"')"
done_quietly play snare-14x5.5 -q --backend file --record take.wav --log take.log --midi-file song.mid --quality draft
same "both presets are in the log" "2 2" "$(grep -c '"model"' take.log) $(grep -c '"replace"' take.log)"
for field in '"expression"' '"event":"parameter"' '"event":"silence"'; do
  check "the log has $field" grep -q "$field" take.log
done

# Other sounds of a log: other microphones, another length.
done_quietly render -q --replay take.log --format float -o split.wav --split # other microphones may be louder
check "--split gives a file for each microphone" test -s split-top.wav
done_quietly render -q --replay take.log --format float -o top.wav --mic top
check "which is what --mic gives" cmp split-top.wav top.wav
done_quietly render -q --replay take.log -o half.wav --duration 0.25
same "--duration" 12000 "$("$INSPECT" sound half.wav | cut -d' ' -f5)"
done_quietly render -q --replay - -o again-take.wav <take.log
check "a log from standard input" cmp take.wav again-take.wav
run render --replay take.log -o again-take.wav --json
same "facts of a replay" "$(tail -n 1 take.log | grep -oE '[0-9]+' | head -n 1)" "$(json frames)"

# ---- against a clock, with keys ----

echo "$seconds s at random, seed $seed"
awk -v seed=$seed -v seconds="$seconds" 'BEGIN {
  srand(seed)
  print "time,velocity,radius,angle"
  for (t = 0.1; t < seconds - 0.3; t += 0.02 + 0.3 * rand()) {
    printf "%.6f,%.4f,%.2f%%,%.1f\n", t, 0.3 * exp(3 * rand()), 100 * rand(), 360 * rand()
  }
}' >random.csv
{
  printf 'wait ? help\nraw\n'
  awk -v seed=$seed -v seconds="$seconds" 'BEGIN {
    srand(seed + 1)
    count = split("s m n p + - a d f j k b [ ] < >", keys, " ")
    set[0] = ":set batter.tension 3100"; set[1] = ":set wires.tension 12"; set[2] = ":preset tom-12"
    set[3] = ":set batter.damping_0 30"; set[4] = ":gain -12"; set[5] = ":preset tabor"; set[6] = ":gain -20"
    for (t = 0; t < seconds - 2; t += 0.15) {
      if (rand() < 0.25) printf "type %s\\r\n", set[int(7 * rand())]
      else printf "type %s\n", keys[1 + int(count * rand())]
      print "sleep 0.15"
    }
  }'
} >script
"$TYPIST" script "$TABOR" play tabor --backend null --quality draft --gain -20 --events random.csv \
  --duration "$seconds" --record take.wav --format float --log take.log >typed
same "the performance ends well" "status 0" "$(grep '^status' typed)"
run render -q --replay take.log -o again-take.wav --format float
same "status of the replay" 0 "$status"
check "$seconds s at random" cmp take.wav again-take.wav
echo "messages: $(grep -c '^{"frame":' take.log), models: $(grep -c '^{"model":' take.log)"
holds "keys were heard: $(grep -c '"swap"\|"replace"' take.log) changes of the model" \
  "$(grep -c '"swap"\|"replace"' take.log) > 0"

# ---- kits ----

cat >small.ini <<'END'
[drum.snare]
preset = frame-drum
head = 38
buzz = 40
[drum.kick]
preset = bass-drum-22
x = 0.5
head = 36
[note.42]
sample = hat.wav
choke = 1
END
done_quietly render frame-drum -q --quality draft --duration 0.2 -o hat.wav
# Bass drum and hi-hat, snare drum, a hi-hat that is grabbed, the drums' volume, a buzz.
hex="4d546864000000060000000100604d54726b"
track="00992470 00992a70 30992660 10992a70 08a92a40 10b90740 18992870 30892800 18992460 40ff2f00"
# shellcheck disable=SC2059
printf "$(sed 's/../\\x&/g' <<<"$hex$(printf '%08x' $(($(tr -d ' ' <<<"$track" | wc -c) / 2)))$(tr -d ' ' <<<"$track")")" >kit.mid
for buffer in 16 4096; do
  done_quietly play --kit ./small.ini -q --backend file --record take.wav --log take.log --midi-file kit.mid --quality draft \
    --gain -3 --buffer "$buffer"
  mkdir -p elsewhere
  (cd elsewhere && "$TABOR" render -q --replay ../take.log -o ../again-take.wav)
  check "a kit from another folder, --buffer $buffer" cmp take.wav again-take.wav
done
for field in '"note":42,"event":"strike"' '"note":42,"event":"silence"' '"drum":1,"event":"strike"' '"event":"gain"' '"event":"release"'; do
  check "the log of a kit has $field" grep -q "$field" take.log
done
done_quietly render -q --replay take.log -o parts.wav --split
check "--split gives each drum of the log" test -s parts-kick.wav -a -s parts-snare.wav
refused "--mic: a kit is heard in its own mix" render -o x.wav --replay take.log --mic top
sed 's/"drum":1,/"drum":2,/' take.log >damaged.log
refused "damaged.log:2: drum: not one of the log's, which has 2" render -o x.wav --replay damaged.log
sed 's/"note":42/"note":43/' take.log >damaged.log
refused "damaged.log:3: note 43: there is no sample" render -o x.wav --replay damaged.log
sed '1s/head = 38/haed = 38/' take.log >damaged.log
refused "damaged.log:1: .*haed" render -o x.wav --replay damaged.log

# With keys: another tuning of one drum, another preset of the other, both while the kit rings.
printf '%s\n' 'wait ? help' 'type a' 'wait strokes 1  ' 'type :set batter.pitch C3\r' 'wait batter.pitch = C3' 'type sd.' 'type a]' \
  'gone (building)' 'type asd' 'type :gain -6\r' 'wait gain -6.0' \
  'type :set kit.overheads -40\r' 'wait kit.overheads = -40 dB' 'type a' 'type :set kit.coupling off\r' 'wait kit.coupling = off' 'type ,asd' 'type :undo\r' 'wait again' 'gone (building)' 'type a' \
  'type :silence\r' 'wait silence' 'type a' 'type :quit\r' >script
# So soft that strokes that come at once, where keys wait for a processor, are not clipped, which a replay is not either.
soft=(--set kit.overheads=-30 --set drum.snare.gain=-30 --set drum.kick.gain=-30)
"$TYPIST" script "$TABOR" play --kit ./small.ini "${soft[@]}" --humanize 0 --backend null --quality draft --record take.wav --format float --log take.log >typed
same "the kit ends well" "status 0" "$(grep '^status' typed)"
run render -q --replay take.log -o again-take.wav --format float
same "status of the replay" 0 "$status"
check "a kit that is tuned and changed" "$INSPECT" equal take.wav again-take.wav
same "each drum changes" "2 1" "$(grep -c '"swap":[0-9]*}' take.log) $(grep -c '"replace":[0-9]*,"drum":1}' take.log)"

# ---- signals and disks ----

for signal in INT TERM; do
  : >"$err"
  "$TABOR" play tabor --backend null --events random.csv --quality draft --record take.au --log "$signal.log" \
    </dev/null >"$out" 2>"$err" &
  pid=$!
  check "the performance begins" wait_for grep -q "frames at once" "$err"
  kill -$signal "$pid"
  wait "$pid"
  status=$?
  same "status after SIG$signal" $((128 + $(kill -l $signal))) "$status"
  cp "$signal.log" take.log
  replayed "after SIG$signal" take.au
  same "nothing is left beside" "" "$(find . -name '.tabor-*' -o -name '*.part*')"
done

if [ -w /dev/full ]; then
  run play tabor -q --backend null --quality draft --duration 0.1 --record take.wav --log /dev/full
  same "status with /dev/full" 1 "$status"
  check "/dev/full is said" grep -q "cannot write '/dev/full': No space left" "$err"
  check "the recording is whole" "$INSPECT" sound take.wav >"$out"
fi
awk 'BEGIN { print "time,velocity"; for (i = 0; i < 100; i++) print i / 100 ",1" }' >flood.csv
(
  ulimit -f 4
  "$TABOR" play tabor --backend null --quality draft --duration 1.2 --events flood.csv --log full.log </dev/null \
    >"$out" 2>"$err"
)
same "status after a full disk" 1 $?
same "it is said once" 1 "$(grep -c "cannot write 'full.log'.*there is no log then, playing goes on" "$err")"
check "playing goes on" grep -q '^1.2 s, ' "$err"
check "there is no log" test ! -e full.log

# ---- wrong requests ----

done_quietly play tabor -q --backend file --record take.wav --log take.log --events strokes.csv --quality draft
cp take.log old.csv
refused "--log '-': allowed" play --backend null --log -
refused "--log '': allowed" play --backend null --log ""
refused "--record and --log: both name the file 'x.wav'" play --backend null --record x.wav --log x.wav
refused "the log would overwrite the events 'old.csv'" play --backend null --events old.csv --log old.csv
failed "exists and is not overwritten" play --backend null --duration 0.1 --log take.log -n
for option in --strike=time=0 --events=strokes.csv --midi-file=song.mid --set=batter.tension=3000 --rate=48000 \
  --quality=live --gain=3 --stereo --humanize=0.5; do
  refused "--replay and ${option%%=*}" render -o x.wav --replay take.log "$option"
done
refused "--replay and 'tabor'" render tabor -o x.wav --replay take.log
refused "--replay: gives one sound" render -o folder/ --replay take.log
refused "--replay: gives one sound" render -o x.wav --replay take.log --each
refused "--mic 'nope': the drum has no such microphone" render -o x.wav --replay take.log --mic nope
failed "cannot read 'nosuch.log'" render -o x.wav --replay nosuch.log
refused "--replay needs the name of a file" render -o x.wav --replay ''
ln take.log x.wav
refused "the output would overwrite the log 'take.log'" render -o x.wav --replay take.log
rm x.wav

# damaged WHAT PATTERN SED-SCRIPT: the log is refused, with the number of the line.
damaged() {
  sed "$3" take.log >damaged.log
  refused "$2" render -o x.wav --replay damaged.log
}
last=$(wc -l <take.log)
damaged "no start" "damaged.log:1: not the start of a log" 1d
damaged "two starts" "damaged.log:2: the log starts twice" 1p
damaged "a line more" "damaged.log:$((last + 1)): text follows the end of the log" '$p'
damaged "no JSON" "damaged.log:3: not a line of a log" '3s/}//'
damaged "a list" "damaged.log:3: not a line of a log" '3s/.*/[1]/'
damaged "an empty line" "damaged.log:3: not a line of a log" '3s/.*//'
damaged "another object" "damaged.log:3: not a line of a log" '3s/.*/{"a":1}/'
damaged "an unknown field" "damaged.log:2: unknown field 'speed'" '2s/velocity/speed/'
damaged "an unknown event" "damaged.log:2: 'event': unknown: 'stroke'" '2s/strike/stroke/'
damaged "a text for a number" "damaged.log:2: 'velocity': allowed: a number" '2s/"velocity":[0-9.]*/"velocity":"fast"/'
damaged "a frame back" "damaged.log:[0-9]*: frame 1: earlier than the one before" '5s/"frame":[0-9]*/"frame":1/'
damaged "a negative frame" "damaged.log:2: 'frame': allowed: a whole number" '2s/"frame":[0-9]*/"frame":-1/'
damaged "too few frames" "damaged.log:$last: frames 5: not after the last message" '$s/"frames":[0-9]*/"frames":5/'
damaged "a model that is not there" "damaged.log:3: model 1: not a new one" '3s/.*/{"frame":960,"swap":1}/'
damaged "a model out of order" "damaged.log:2: model 2: expected number 1" '1{p;s/"tabor_log":1,.*"preset"/"model":2,"preset"/}'
damaged "another format" "damaged.log:1: a log of format 2; this program reads format 1" '1s/"tabor_log":1/"tabor_log":2/'
damaged "an impossible drum" "damaged.log:1: .*shell.radius" '1s/shell.radius = [0-9.]*/shell.radius = 99/'
damaged "an unknown key" "damaged.log:1: .*shell.colour" '1s/shell.radius/shell.colour/'
damaged "an unknown quality" "damaged.log:1: 'quality': unknown: 'best'" '1s/"draft"/"best"/'
damaged "another microphone" "damaged.log:1: 'mics': allowed: names of the drum's microphones" '1s/\["top"\]/["nope"]/'
damaged "a rate of nothing" "damaged.log:1: 'rate': allowed: 22050 to 192000" '1s/"rate":48000.0/"rate":1/'

damaged "nothing" "damaged.log:1: the log breaks off before its drum" 'd'
damaged "nothing but a drum" "damaged.log:[0-9]*: the log breaks off before any sound" '2,$d'
damaged "a line behind a mark" "damaged.log:3: text follows the end" '2s/.*/{"played":960,"lost":0}/'
damaged "half of the first line" "damaged.log:1: the log breaks off before its drum" '1s/"rate".*//;2,$d'

# A log without an end is played up to where it is complete: its mark, or else its last message.
done_quietly render -q --replay take.log -o whole.wav
# broken WHAT FRAMES SED-SCRIPT
broken() {
  sed "$3" take.log >broken.log
  run render -q --replay broken.log -o again-take.wav
  same "$1: status and message" \
    "0 tabor: warning: 'broken.log' ends after $(printf %.1f "$(awk "BEGIN { print $2 / 48000 }")") s without its end; the sound stops there" \
    "$status $(cat "$err")"
  same "$1: frames" "$2" "$("$INSPECT" sound again-take.wav | cut -d' ' -f5)"
  check "$1: sound" cmp <(head -c $(($2 * 3)) <(tail -c +45 whole.wav)) <(head -c $(($2 * 3)) <(tail -c +45 again-take.wav))
}
last_event=$(grep '"event"' take.log | tail -n 1 | sed -E 's/.*"frame":([0-9]*).*/\1/')
broken "no end" "$last_event" '$d'
broken "half of the end" "$last_event" '$s/"lost.*//'
broken "a mark" $((last_event + 100)) "\$s/.*/{\"played\":$((last_event + 100)),\"lost\":0}/"
broken "a mark before the last message" "$last_event" '$s/.*/{"played":100,"lost":0}/'
broken "half of a message" 960 '4s/"event".*//;5,$d'
sed '$d' take.log | head -c -1 >broken.log
run render -q --replay broken.log -o again-take.wav
same "a whole message without its line feed" "$last_event" "$("$INSPECT" sound again-take.wav | cut -d' ' -f5)"

# A log of another version is played, with a word about it.
sed '1s/"program":"[^"]*"/"program":"0.0.1"/' take.log >older.log
run render -o again-take.wav --replay older.log
same "status of an older log" 0 "$status"
check "its version is said" grep -q "'older.log' was written by version 0.0.1; this is" "$err"
sed '$s/"lost":0/"lost":3/' take.log >lossy.log
run render -q -o again-take.wav --replay lossy.log
check "lost messages are said" grep -q "'lossy.log' lacks 3 messages" "$err"

finish
