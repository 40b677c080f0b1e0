#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render -o FOLDER/, --each and --jobs: many sounds at once, each as if it were rendered alone.

. "$(dirname "$0")/../support/host_checks.sh"

short=(-q --quality draft --duration 0.3 --format float)
files() { find "$1" -mindepth 1 -printf '%P\n' | sort | tr '\n' ' '; }

"$TABOR" show frame-drum --set batter.tension=5000 >mine.ini
printf 'time,velocity\n0,1\n' >soft.csv
printf 'time,velocity\n0,6\n0.1,3\n' >hard.csv

# ---- the same bytes as alone ----

mkdir alone
presets=(frame-drum mine.ini tabor tom-12 bodhran-d-string)
for preset in "${presets[@]}"; do
  done_quietly render "$preset" "${short[@]}" -o "alone/${preset%.ini}.wav"
done
for jobs in 1 2 8; do
  done_quietly render "${presets[@]}" "${short[@]}" -o jobs$jobs/ --jobs $jobs
  check "the sounds with $jobs jobs" diff -r alone jobs$jobs
done
mkdir default
done_quietly render "${presets[@]}" "${short[@]}" -o default
check "a folder that is there needs no slash" diff -r alone default
echo old >default/tabor.wav
done_quietly render "${presets[@]}" "${short[@]}" -o default/
check "older files are replaced" diff -r alone default
(umask 027 && exec "$TABOR" render "${presets[@]}" "${short[@]}" -o masked/ -j4)
same "permissions of new files" 640 "$(stat -c %a masked/* | uniq)"
rm -rf jobs? default masked

done_quietly render frame-drum tabor -q --normalize --quality live -o two/ -j2
for preset in frame-drum tabor; do
  done_quietly render $preset -q --normalize --quality live -o one.wav
  same_bytes "$preset until it has died away" one.wav two/$preset.wav
done

# ---- names ----

rm -rf two
done_quietly render tabor "${short[@]}" -o two/
same "a single sound in a folder" "tabor.wav " "$(files two)"
rm -rf two
mkdir sub
cp mine.ini sub/x.y.ini
cp mine.ini sub/plain-5.5
done_quietly render sub/x.y.ini sub/plain-5.5 snare-14x5.5-off "${short[@]}" -o "$PWD/two/"
same "of files and presets" "plain-5.5.wav snare-14x5.5-off.wav x.y.wav " "$(files two)"
rm -rf two
done_quietly render frame-drum tabor "${short[@]}" --split --mic far --mic top -o two/
same "with --split" "frame-drum-far.wav frame-drum-top.wav tabor-far.wav tabor-top.wav " \
  "$(files two)"
done_quietly render tabor "${short[@]}" --mic top -o one.wav
same_bytes "the sound of a microphone" one.wav two/tabor-top.wav
rm -rf two

# ---- takes ----

done_quietly render frame-drum tabor "${short[@]}" --each --events={soft,hard}.csv -o two/
same "every preset with every file" \
  "frame-drum-hard.wav frame-drum-soft.wav tabor-hard.wav tabor-soft.wav " "$(files two)"
done_quietly render tabor "${short[@]}" --events hard.csv -o one.wav
same_bytes "a take" one.wav two/tabor-hard.wav
rm -rf two
done_quietly render frame-drum tabor "${short[@]}" --events={soft,hard}.csv -o two/
same "without --each they add up" "frame-drum.wav tabor.wav " "$(files two)"
done_quietly render tabor "${short[@]}" --events={soft,hard}.csv -o one.wav
same_bytes "in every sound" one.wav two/tabor.wav
rm -rf two
done_quietly render tabor "${short[@]}" --each --events soft.csv --strike time=0.2 -o two/
done_quietly render tabor "${short[@]}" --events soft.csv --strike time=0.2 -o one.wav
same "one take" "tabor-soft.wav " "$(files two)"
same_bytes "--strike adds to every take" one.wav two/tabor-soft.wav
rm -rf two
done_quietly render tabor "${short[@]}" --each -o two/ --trace one.csv
same "--each without files" "tabor.wav " "$(files two)"
same "one sound has a trace" 14401 "$(wc -l <one.csv)"
rm -rf two one.*

# ---- what is said ----

facts=(--quality draft --duration 0.1 --json -o two/)
done_quietly render tabor frame-drum "${facts[@]}" -j2
same "a list" "renders 2" "$(json keys) $(json renders.size)"
same "keys" "preset rate frames channels peak real_time_factor newton energy output trace" \
  "$(json renders.0.keys)"
same "in order" "tabor frame-drum" "$(json renders.0.preset) $(json renders.1.preset)"
same "of outputs" "two/tabor.wav two/frame-drum.wav" \
  "$(json renders.0.output) $(json renders.1.output)"
done_quietly render tabor "${facts[@]}"
same "a list of one" 1 "$(json renders.size)"
run render tabor missing.ini frame-drum "${facts[@]}"
same "with a failure" "1 preset output failed" "$status $(json renders.1.keys)"
same "which one" "missing.ini two/missing.wav" "$(json renders.1.preset) $(json renders.1.output)"
same "the others" "4800 4800" "$(json renders.0.frames) $(json renders.2.frames)"
run render tabor frame-drum --quality draft --duration 0.1 -o two/ -j1
same "a line each" "two/tabor.wav: tabor two/frame-drum.wav: frame-drum " \
  "$(cut -d , -f 1 "$err" | tr '\n' ' ')"
run render tabor frame-drum --quality draft --duration 0.1 -o two/ -v
same "every line names its sound" 8 "$(grep -cE '^two/(tabor|frame-drum)(:|.wav:) ' "$err")"
run render tabor frame-drum -q --quality draft --duration 0.1 --gain 60 -o two/
same "so do warnings" "0 2" \
  "$status $(grep -cE '^tabor: warning: two/(tabor|frame-drum): the peak' "$err")"
rm -rf two

# ---- progress on a terminal ----

# Some minutes of strokes: long enough that a forecast is seen, and then nobody waits for the end.
awk 'BEGIN { print "time"; for (i = 0; i < 4000; i++) print i / 10 }' >many.csv
# shows_progress PATTERN ARGUMENT...: a line like this appears while that is rendered.
shows_progress() {
  local pattern=$1
  shift
  printf 'wait left\nshow\nsignal 2\n' >script
  "$TYPIST" script "$TABOR" render --quality draft "$@" >"$out"
  check "progress of: $*" grep -qxE "\|$pattern" "$out"
  same "the end of: $*" "status 130" "$(grep '^status' "$out")"
}
forecast='[0-9]+ %, about [0-9]+:[0-5][0-9] left'
shows_progress "0 of 2 done, $forecast" tabor frame-drum --events many.csv -o two/
shows_progress "[0-9]+ s, $forecast" tabor --events many.csv -o one.wav
shows_progress "[0-9]+ s, $forecast" tabor --events many.csv --duration 500 -o one.wav
if [ -n "$(command -v script)" ]; then # it gives the program a terminal, too, and keeps every byte
  script -qec "'$TABOR' render tabor frame-drum --quality draft -o two/ --duration 0.1 -q" log </dev/null >"$out"
  same "none with -q" 0 "$(wc -c <"$out")"
  rm -rf two log
else
  skip_part "progress on a terminal: needs bsdutils"
fi

# ---- wrong requests: nothing is rendered, and no folder created ----

two=(render tabor frame-drum)
refused "several sounds need a folder: -o FOLDER/" "${two[@]}"
refused "several sounds need a folder: -o FOLDER/" render --each --events soft.csv
refused "-o 'new': several sounds need a folder; 'new/' creates one" "${two[@]}" -o new
refused "-o 'mine.ini': several sounds" "${two[@]}" -o mine.ini
refused "-o -: standard output takes one" "${two[@]}" -o -
refused "-o -: standard output takes one" "${two[@]}" -o /dev/stdout
refused "-o needs" "${two[@]}" -o ''
refused "--trace: takes one sound only, but 2 were" "${two[@]}" -o new/ --trace t.csv
refused "--events -: several sounds cannot share" "${two[@]}" -o new/ --events -
refused "new/tabor: --mic 'tpo'.*did you mean 'top'" "${two[@]}" -o new/ --mic tpo
refused "new/tabro: unknown preset 'tabro'" "${two[@]}" tabro tom-12 -o new/
printf 'velocity\nfast\n' >bad.csv
refused "new/tabor-bad: bad.csv:2: velocity 'fast'" render tabor --each --events={soft,bad}.csv -o new/
refused "too short; the last stroke" "${two[@]}" --events hard.csv --duration 0.05 -o new/
for jobs in 0 -1 257 1.5 many ''; do
  refused "--jobs '$jobs'.*allowed: 1 to 256" "${two[@]}" -o new/ --jobs "$jobs"
  refused "--jobs '$jobs'.*allowed: 1 to 256" render tabor "--jobs=$jobs"
done

# Two sounds of one name.
cp mine.ini sub/mine.ini
refused "'tabor' and 'tabor' would both become 'new/tabor.wav'" render tabor tabor -o new/
refused "'mine.ini' and 'sub/mine.ini' would both become 'new/mine.wav'" \
  "${two[@]}" mine.ini tom-12 sub/mine.ini -o new/
cp soft.csv sub/soft.csv
refused "'soft.csv' and 'sub/soft.csv' would both become 'new/tabor-soft.wav'" \
  render tabor --each --events soft.csv --events hard.csv --events sub/soft.csv -o new/
cp mine.ini a.ini
{ cat mine.ini && printf '[mic.b]\n[mic.c]\n'; } >a-b.ini
{ cat mine.ini && printf '[mic.b-c]\n'; } >a.ini
refused "two sounds would both become 'new/a-b-c.wav'" render a.ini a-b.ini --split -o new/
mkdir links
ln -s tabor.wav links/frame-drum.wav
touch links/tabor.wav
refused "'links/tabor.wav' and 'links/frame-drum.wav' are the same file" "${two[@]}" -o links
cp mine.ini links/other.wav
rm -f links/tabor.wav links/frame-drum.wav
ln links/other.wav links/tabor.wav
refused "would overwrite the preset 'links/other.wav'" render tabor links/other.wav -o links
cp soft.csv links/take.wav
ln links/take.wav links/tabor-soft.wav
refused "would overwrite the events 'links/take.wav'" \
  render tabor --each --events soft.csv --events links/take.wav -o links

# ---- what fails does not stop the others ----

rm -rf links new
run render missing.ini tabor frame-drum "${short[@]}" -o two/ -j2
expect_error 1 "two/missing: missing.ini: No such file"
same "the others" "frame-drum.wav tabor.wav " "$(files two)"
rm -f two/tabor.wav
run render tabor frame-drum "${short[@]}" -n -o two/ -j1
expect_error 1 "'two/frame-drum.wav' exists and is not overwritten"
same_bytes "what was missing" alone/tabor.wav two/tabor.wav
rm -rf two
mkdir -p two/tabor.wav
run render tabor frame-drum "${short[@]}" -o two/
expect_error 1 "cannot write 'two/tabor.wav': it is a folder"
same_bytes "the other" alone/frame-drum.wav two/frame-drum.wav
rm -rf two
mkdir two
ln -s /dev/full two/tabor.wav
run render tabor frame-drum "${short[@]}" -o two/
expect_error 1 "cannot write 'two/tabor.wav': No space left"
same "the other" "frame-drum.wav tabor.wav " "$(files two)"
rm -rf two
failed "missing.ini" render missing.ini -o two/
failed "cannot create the folder 'missing/two/': No such file" "${two[@]}" -o missing/two/
failed "cannot write to 'mine.ini/': Not a directory" "${two[@]}" -o mine.ini/
run "${two[@]}" "${short[@]}" -o /proc/
same "a folder that takes no file" "1 2" "$status $(grep -c "cannot write '/proc/" "$err")"
if [ "$(id -u)" != 0 ]; then
  mkdir closed
  chmod 555 closed
  run "${two[@]}" "${short[@]}" -o closed
  same "a write-protected folder" "1 2" "$status $(grep -c 'Permission denied' "$err")"
fi
"$TABOR" render tabor frame-drum "${short[@]}" --json -o two/ >/dev/full 2>"$err"
status=$?
: >"$out"
expect_error 1 "standard output: No space left"
same_bytes "the sounds are there" alone/tabor.wav two/tabor.wav
same "leftovers" '' "$(find . -name '.tabor*')"

# ---- signals: complete files stay, no others ----

long=(render tabor frame-drum bodhran-d-string -q --quality draft --duration 3600 --rate 192000)
interrupted INT 130 2 "${long[@]}" -o two/ --jobs 2
interrupted TERM 143 3 "${long[@]}" -o two/ --jobs 3
interrupted TERM 143 1 "${long[@]}" -o two/ --jobs 1
interrupted INT 130 $(($(mics_of tabor) + $(mics_of frame-drum))) "${long[@]}" -o two/ --split --normalize --jobs 2
{ echo time && seq 0 0.1 3600; } >endless.csv
takes=(--each --events={soft,endless}.csv)
"$TABOR" render tabor frame-drum -q --quality draft "${takes[@]}" -o takes/ -j2 2>"$err" &
child=$!
check "two sounds are done" wait_for test -e takes/tabor-soft.wav -a -e takes/frame-drum-soft.wav
kill -INT $child
wait $child
same "status" 130 $?
same "the complete files" "frame-drum-soft.wav tabor-soft.wav " "$(files takes)"
for preset in tabor frame-drum; do
  done_quietly render $preset -q --quality draft --events soft.csv -o one.wav
  same_bytes "the sound of $preset" one.wav takes/$preset-soft.wav
done

finish
