#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Keys typed on a pseudo-terminal come out as strokes in the recording, at the right times. With "jack" as its
# argument, through PortAudio and a JACK server without a sound card; else on the null backend.

. "$(dirname "$0")/../support/host_checks.sh"
: "${TYPIST:?host_typist}"
export TERM=xterm

via=${1-null}
if [ "$via" = jack ]; then
  # shellcheck source=tests/support/jack_server.sh
  . "$(dirname "$0")/../support/jack_server.sh"
  trap 'status=$?; end_jack; leave $status' EXIT
  start_jack
  backend=(--device "JACK: system")
else
  backend=(--backend null)
fi

# types SCRIPT-LINE...: plays $played, as a rule a drum whose strokes die away at once, types, and quits.
dull=(frame-drum --set batter.damping_0=300)
played=("${dull[@]}")
types() {
  printf 'wait ? help\n' >script
  printf '%s\n' "$@" 'wait ? help' 'type :quit\r' >>script
  timeout 300 "$TYPIST" script "$TABOR" play "${played[@]}" --humanize 0 \
    "${backend[@]}" --record take.wav "${options[@]}" >typed
  same "the typist's status" 0 $?
  same "the program's status" "status 0" "$(grep ^status typed)"
  same "the terminal's settings" "settings same" "$(grep ^settings typed)"
  "$INSPECT" sounds take.wav >onsets
}
options=()
strokes() { awk 'END { print NR }' onsets; }
peak() { awk -v n="$1" 'NR == n { print $2 }' onsets; }

# Lines of a script: a key, and all that it sounds, however long that takes. What is shown is older than 0.1 s only
# on a machine that stands still.
struck=()
strike_with() { struck+=("type $1" "wait strokes $2  " 'sleep 0.1' 'wait asleep'); }

# ---- when, and how fast ----

strike_with a 1
strike_with s 2
struck+=('sleep 0.13')
strike_with s 3
strike_with w 4
strike_with ' ' 5
struck+=('type 5' 'sleep 0.1')
strike_with s 6
strike_with ' ' 7

type_strokes() {
  types 'type 9' "${struck[@]}"
  same "every key is a stroke" 7 "$(strokes)"
  [ "$(strokes)" = 7 ] || return 0 # a failure already
  holds "a ghost note is much softer" "$(peak 4) < 0.6 * $(peak 3)"
  same "the same key, the same stroke" "$(peak 2)" "$(peak 3)"
  same "space repeats a ghost note" "$(peak 4)" "$(peak 5)"
  holds "a lower digit is softer" "$(peak 6) < 0.6 * $(peak 3)"
  same "space repeats the last stroke" "$(peak 6)" "$(peak 7)"
  grep ^typed typed | sed -n '2,6p; 8,9p' >keys
  # Intervals, so that the constant latency cancels.
  paste -d ' ' keys onsets |
    awk 'NR > 1 { d = ($2 - t) - ($3 - s); print d < 0 ? -d : d } { t = $2; s = $3 }' | sort -g >late
  echo "keys and strokes are apart by $(sed -n 3p late) s in half of the cases, by $(tail -n 1 late) s at most"
  awk 'NR == 3 && $1 >= 0.01 || $1 >= 0.1 { exit 1 }' late
}
in_time $CALM "strokes come at the times of their keys" type_strokes
if [ "$via" = jack ]; then
  finish
  exit
fi

# ---- a roll, as the terminal repeats a held key; and keys in a batch ----

roll=()
for ((i = 0; i < 10; i++)); do roll+=('type d' 'sleep 0.03'); done
types "${roll[@]}" 'wait strokes 10  '
check "a held key is a roll" test "$(strokes)" -ge 1
types 'type asd' 'wait strokes 3' 'sleep 0.1' 'wait asleep'
same "a batch is played at once" 1 "$(strokes)"

# Its hand lets go by the clock.
type_buzz() {
  types 'type v' 'wait last    release' 'wait strikers 0' 'wait strokes 1  '
  [ "$(strokes)" -ge 1 ]
}
in_time 0.05 "a buzz is heard" type_buzz

# ---- commands ----

types 'type :' 'type set wires.asdf' 'wait :set wires.asdf' 'type \x15\x7f' 'gone :set' 'wait ? help'
same "no strokes while typing" 0 "$(strokes)"
# ---- the list of parameters ----

types 'type \t' 'wait Tab closes' 'wait tension of the head' 'type \e[5~' 'wait radius of the heads' \
  'type \r' 'wait :set shell.radius' 'type 8 in\r' 'wait shell.radius = 0.2032 m' \
  'type \e[6~\e[C' 'wait batter.tension = ' 'type a' 'wait Tab closes' 'type \t' 'wait ? help'
same "a key plays on while the list is open" 1 "$(strokes)"

types 'type :set batter.tens\t9000\r' 'wait batter.tension = 9000 N/m' 'type :\e[A' \
  'wait :set batter.tension 9000' 'type \x7f\x7f\x7f\x7f1\r' 'wait is outside 100 to 20000 N/m' \
  'type :set batter.pitch C6\r' 'wait batter.pitch = 1046.5 is outside' \
  'type :set batter.pitch A3\r' 'wait batter.pitch = A3 (Batter head pitch A3)' \
  'type :set batter.pitch A3 +12 ct\r' 'wait Hz (Batter head pitch A3 +12 ct)' \
  'type :set batter.muffle_strength 50 %\r' 'wait batter.muffle_strength = 7.5 N s/m (Batter head muffling 50 %)' \
  'type :set batter.muffle_strength open\r' 'wait (Batter head muffling Open)' \
  'type :set batter.muffle_strength wide\r' "wait 'wide'" \
  'type :set wires.tenson 3\r' 'wait did you mean' 'type :foo\r' "wait unknown command 'foo'" \
  'type :preset nodrum\r' "wait nodrum" 'type :preset tom-21\r' "wait did you mean 'tom-12'" 'type :gain 3\r' 'wait gain +3.0 dB' 'type ++-' \
  'wait gain +4.0 dB' 'type :gain 99\r' 'wait allowed: -60 to 24' 'type :speed 4\r' 'wait 4.00 m/s' \
  'type :humanize 0.5\r' 'wait humanize 0.5' 'type :set' 'sleep 0.1' 'type \e' 'wait ? help' \
  'type :gain\r' 'wait gain needs more: gain DB' 'type :silence now\r' "wait nothing may follow 'silence'"
same "commands make no strokes" 0 "$(strokes)"
types 'type :undo\r' 'wait undo: nothing was set' 'type :set batter.tension 5000\r' 'wait batter.tension = 5000' \
  'type :set batter.tension 6000\r' 'wait batter.tension = 6000' 'type :undo\r' 'wait batter.tension = 5000 again' \
  'type :save mine.ini\r' 'wait saved mine.ini' 'type :save none/mine.ini\r' 'wait none/mine.ini'
same "a saved drum is the drum as it stands" 1 "$(grep -c '^tension = 5000 ' mine.ini)"
"$TABOR" show mine.ini >"$out"
same "it reads back" "$(tail -n +2 mine.ini)" "$(tail -n +2 "$out")"
export XDG_DATA_HOME="$PWD/data"
types 'type :set batter.tension 5000\r' 'wait batter.tension = 5000' 'type :set batter.pitch A3\r' 'wait batter.pitch = A3' \
  'type :undo\r' 'wait batter.tension = 5000 again' 'type :redo\r' 'wait (Batter head pitch A3)' 'type :redo\r' 'wait redo: nothing was undone' \
  'type :undo\r' 'wait batter.tension = 5000 again' 'type :save frame-drum\r' 'wait that is a built-in drum' \
  'type :save mine\r' 'wait /data/tabor/mine.ini' 'type :save ./other.ini\r' 'wait saved ./other.ini' \
  'type :preset mine\r' 'wait tabor  mine' 'type :preset tom-12\r' 'wait tabor  tom-12'
same "one's own drum is saved in one's own folder" "$(cat other.ini)" "$(cat data/tabor/mine.ini)"
"$TABOR" show mine >"$out"
same "it is found by its name" "$(tail -n +2 other.ini)" "$(tail -n +2 "$out")"
# Only what this session opened or saved is replaced, unless it is told to; what is no drum never is.
printf 'my notes\n' >notes.ini
types 'type :save mine\r' "wait mine.ini is there already" 'type :save ./notes.ini\r' 'wait notes.ini is no drum' \
  'type :save! ./notes.ini\r' 'wait notes.ini is no drum' 'type :save! mine\r' 'wait saved' 'type :preset mine\r' 'wait tabor  mine' \
  'type :save mine\r' 'wait saved'
same "what is no drum stays" "my notes" "$(cat notes.ini)"
"$TABOR" show --kit jazz >data/tabor/club.ini
types 'type :save club\r' 'wait club.ini is no drum'
"$TABOR" show --kit club >"$out"
same "so is a kit" "$(tail -n +2 data/tabor/club.ini)" "$(tail -n +2 "$out")"
types 'type :preset tom-12\r' 'wait tabor  tom-12' 'type ]' 'wait tabor  floor-tom-16' 'type [[' \
  'gone floor-tom-16' 'type b' 'wait snares off' 'type b' 'wait snares on' 'type n' 'wait muffle on' \
  'type n' 'wait muffle off' 'type ?' 'wait ghost notes' 'type ?' 'gone ghost notes' \
  'wait strokes 0' 'type z' 'wait strokes 1' 'type xc' 'wait strokes 3'
same ":quit and :q quit" "status 0 status 0" "$(for command in quit q; do
  printf 'wait ? help\ntype :%s\\r\n' $command >script
  "$TYPIST" script "$TABOR" play frame-drum --backend null | grep ^status
done | xargs)"

# ---- a kit: one drum at a time has the keys ----

cat >small.ini <<'END'
[kit]
overheads = 6
[drum.snare]
preset = snare-14x5.5
head = 38
[drum.tom]
preset = tom-12
x = 0.5
head = 48
[note.42]
sample = hat.wav
END
"$TABOR" render frame-drum --quality draft --duration 0.1 -q -o hat.wav
played=(--kit ./small.ini --quality draft)
printf '[drum.kick]\npreset = bass-drum-22\nmic = inside\nhead = 36\n[drum.own]\npreset = mine\nx = 0.6\nhead = 38\n' >own.ini
types 'wait snare, snare-14x5.5' 'type a' 'wait strokes 1  ' 'type b' 'wait snares off' 'type .' 'wait drum tom' \
  'wait tom, tom-12' 'type b' 'wait this drum has no snares' 'type sd' 'wait strokes 3  ' 'type .' 'wait snare, snare' \
  'type ,' 'wait tom, tom-12' 'type :drum sanre\r' "wait the kit has no drum 'sanre'; did you mean 'snare'" 'type :set drum.tom.batter.pitch A3\r' 'wait those of one drum' 'type :drum snare\r' 'wait snare, snare' \
  'type :drum tom\r' 'wait tom, tom-12' 'type :set batter.pitch A3\r' 'wait batter.pitch = A3' 'gone (building)' \
  'type :undo\r' 'wait again' 'type :redo\r' 'wait (Batter head pitch A3)' 'gone (building)' 'type ]' 'wait tom, floor-tom-16' 'gone (building)' \
  'type a' 'wait strokes 4  ' 'type :set room.kind=hall\r' 'wait the room stays' 'type :gain -6\r' 'wait gain -6.0 dB' \
  'type :set kit.overheads=-9\r' 'wait kit.overheads = -9 dB' 'type :set kit.coupling 25\r' 'wait allowed: -60 to 24' \
  'type :set kit.coupling off\r' 'wait kit.coupling = off' 'type :set kit.name=x\r' 'wait those of one drum' \
  'type :save standard\r' 'wait that is a built-in kit' 'type :save mine\r' 'wait mine.ini is no kit' \
  'type :save band\r' 'wait /data/tabor/band.ini' 'type :silence\r' 'wait asleep'
"$TABOR" show --kit band >"$out"
same "the kit is saved with its drums as they are" "snare-14x5.5 floor-tom-16" \
  "$(sed -n 's/^preset = //p' "$out" | xargs)"
same "and with its overheads and coupling" "overheads = -9 coupling = off" "$(grep -oE '^(overheads|coupling) = [^ ]+' "$out" | sort -r | xargs)"
same "and with its samples, wherever it is" "$PWD/hat.wav" "$(sed -n 's/^sample = //p' "$out")"
same "and called as it is saved" "name = band" "$(grep '^name = ' "$out")"
# A drum whose new preset lacks the kit's close microphone; a preset of one's own in a kit's file.
played=(--kit ./own.ini --quality draft)
types 'wait own, frame-drum' 'type :drum kick\r' 'type :preset tom-12\r' 'wait kick, tom-12' 'gone (building)' 'type a' 'wait strokes 1  ' \
  'type :save ./other.ini\r' 'wait other.ini is no kit' 'type :save ./changed.ini\r' 'wait saved'
"$TABOR" show --kit ./changed.ini >"$out"
same "it is saved as it plays" "tom-12" "$(sed -n '/drum.kick/,/drum.own/s/^preset = //p' "$out")"
played=("${dull[@]}")
types 'type .' 'wait there is one drum' 'type :drum tom\r' 'wait there is one drum'

# ---- sizes ----

types 'size 20 5' 'sleep 0.2' 'type a' 'sleep 0.2' 'size 1 1' 'sleep 0.2' 'size 300 100' 'sleep 0.2' \
  'size 80 24' 'wait ? help' 'wait strokes 1  '

# ---- keys of one's own ----

printf '[keys]\na = none\nf2 = stroke 50%%\nsemicolon = :gain -6\n' >keys.ini
options=(--keys keys.ini)
types 'type a' 'type \eOQ' 'wait strokes 1  ' 'type ;' 'wait gain -6.0 dB' 'wait asleep'
same "remapped keys" 1 "$(strokes)"
printf '[keys]\na = fly\n' >keys.ini
refused "--keys: keys.ini:2: 'a = fly': unknown action; there are" play --keys keys.ini --backend null
failed "--keys: no.ini: No such file" play --keys no.ini --backend null

# ---- without a screen: lines ----

# lines SCRIPT-LINE ARGUMENT...: the messages of a performance that is typed on, which stand in err.txt. The line
# waits for the first stroke, since two at once are told as one.
lines() {
  local first=$1
  shift
  rm -f err.txt
  printf '%s\n' raw 'type a' "$first" 'type z:gain 99\r:gain 2\r?' 'read err.txt out of range' escape >script
  timeout 300 "$TYPIST" script bash -c '"$@" 2>err.txt' - "$TABOR" play frame-drum --backend null --humanize 0 "$@" >typed
  same "settings without a screen" "settings same" "$(grep ^settings typed)"
}
lines 'read err.txt s: stroke' --no-ui
for line in ' s: stroke at 0 % of the radius, 20 degrees, 4.50 m/s' 'allowed: -60 to 24' \
  'gain +2.0 dB' 'a s d f g h j k l      strokes, from' 'Escape again quits'; do
  check "--no-ui says: $line" grep -qF -e "$line" err.txt
done
lines 'sleep 0.1' --no-ui -q
same "-q says what goes wrong" "gain '99': out of range; allowed: -60 to 24" \
  "$(grep -vE '  |^[[:punct:]]|ran dry' err.txt)"
TERM=dumb lines 'read err.txt s: stroke'
check "a terminal without a cursor has lines" grep -q 's: stroke at 0 %' err.txt
run play frame-drum --backend null --duration 0.2 </dev/null
same "without a terminal" 0 "$status"
same "that is said once" 1 "$(grep -c 'standard input is no terminal: there are no keys' "$err")"

finish
