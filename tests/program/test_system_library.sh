#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# library: a drum as samples. Files, the instrument, loudness, and runs that are ended and taken up again.

. "$(dirname "$0")/../support/host_checks.sh"

one=(--velocities 1 --positions 1 --takes 1)
short=(--quality draft --duration 0.2 --set quality.two_way_bandwidth=1000)
files() { find "$1" -mindepth 1 -printf '%P\n' | sort | tr '\n' ' '; }
sounds() { find "$1" -name '*.wav' | wc -l; }
library() { done_quietly library "$@" "${short[@]}" -q; }

# ---- a sound for each stroke ----

library tabor --velocities 3 --positions 2 --takes 2 -o two
expected=
for radius in 00 80; do
  for velocity in 001 064 127; do
    expected+="tabor-normal-r$radius-v$velocity-t1.wav tabor-normal-r$radius-v$velocity-t2.wav "
  done
done
same "the files" "tabor-library.json tabor-library.sums ${expected}tabor.sfz " "$(files two)"

# as the program's own strokes sound
library tabor --velocities 3 --positions 2 --takes 1 -o one/ --seed 9
for radius in 0 80; do
  for velocity in 1 64 127; do
    done_quietly render tabor "${short[@]}" -q -o stroke.wav --strike "midi=$velocity,radius=$radius%"
    check "velocity $velocity at $radius %" cmp stroke.wav \
      "$(printf 'one/tabor-normal-r%02d-v%03d-t1.wav' $radius $velocity)"
  done
done
library tabor "${one[@]}" -o single
same "of one place and velocity" "tabor-library.json tabor-library.sums tabor-normal-r33-v064-t1.wav tabor.sfz " \
  "$(files single)"
done_quietly render tabor "${short[@]}" -q -o stroke.wav --strike midi=64
check "it is the preset's place" cmp stroke.wav single/tabor-normal-r33-v064-t1.wav

# buzzes, by themselves and beside normal strokes
library tabor "${one[@]}" --techniques buzz -o buzzes
library tabor "${one[@]}" --techniques normal,buzz -o both
done_quietly render tabor "${short[@]}" -q -o stroke.wav --strike midi=64,technique=buzz
check "a buzz" cmp stroke.wav buzzes/tabor-buzz-r33-v064-t1.wav
check "beside a normal stroke" cmp stroke.wav both/tabor-buzz-r33-v064-t1.wav
check "that is none" cmp single/tabor-normal-r33-v064-t1.wav both/tabor-normal-r33-v064-t1.wav
same "they have keys of their own" "38 62" "$(sed -n 's/^key=//p' both/tabor.sfz | paste -sd ' ')"
# all that there are, each to the bit; a stroke on the rim has no place on the head
shell=(--set shell.mass=2) # one that sounds
library tabor --velocities 1 --positions 2 --takes 1 "${shell[@]}" --techniques normal,rimshot,cross-stick,rim,buzz -o all
for technique in normal rimshot cross-stick buzz; do
  for radius in 0 80; do
    done_quietly render tabor "${short[@]}" "${shell[@]}" -q -o stroke.wav --strike "midi=64,technique=$technique,radius=$radius%"
    check "$technique at $radius %" cmp stroke.wav "$(printf 'all/tabor-%s-r%02d-v064-t1.wav' $technique $radius)"
  done
done
done_quietly render tabor "${short[@]}" "${shell[@]}" -q -o stroke.wav --strike midi=64,technique=rim
check "a stroke on the rim" cmp stroke.wav all/tabor-rim-r33-v064-t1.wav
same "each has keys of its own" "14 36 38 60 62 84 86 108 110" "$(sed -n 's/^key=//p' all/tabor.sfz | sort -n | paste -sd ' ')"
library tabor "${one[@]}" --techniques normal -o plain --set strike.technique=buzz
check "nor of a preset that buzzes" cmp single/tabor-normal-r33-v064-t1.wav plain/tabor-normal-r33-v064-t1.wav

for sound in two/*-t1.wav; do
  other_bytes "takes of $sound differ" "$sound" "${sound/-t1/-t2}"
  other_bytes "and from the stroke itself" "$sound" "${sound/two/one}"
done
library tabor --velocities 3 --positions 2 --takes 2 -o again --seed 1 --humanize 0.5 --jobs 1
check "the same again with one job" diff -r two again
library tabor --velocities 3 --positions 2 --takes 2 -o seed --seed 2
other_bytes "another seed, other takes" two/tabor-normal-r80-v127-t1.wav seed/tabor-normal-r80-v127-t1.wav

# ---- loudness ----

peaks=
for velocity in 001 064 127; do
  peaks+=" $("$INSPECT" peak one/tabor-normal-r80-v$velocity-t1.wav)"
done
read -r soft medium loud <<<"$peaks"
holds "harder is louder" "$soft * 3 < $medium && $medium * 3 < $loud && $loud < 1"
library tabor --velocities 3 --positions 2 --takes 1 -o quiet --gain -20 --format float
holds "one gain is for all" \
  "($("$INSPECT" peak quiet/tabor-normal-r80-v127-t1.wav) / $loud - 0.1) ^ 2 < 1e-10"

# ---- the instrument ----

# groups INSTRUMENT: a line for each group, with all it says.
groups() {
  awk '/^<group>/ { if (line) print line; line = "" } /^[a-z]/ && !/^(loop|amp)/ { line = line $0 " " }
    END { print line }' "$1"
}
same "a group for each velocity at each place" 6 "$(groups two/tabor.sfz | wc -l)"
group() {
  printf 'key=%s lovel=%s hivel=%s seq_length=2 ' "$1" "$2" "$3"
  printf 'seq_position=1 sample=tabor-normal-r%s-v%s-t1.wav ' "$4" "$5"
  printf 'seq_position=2 sample=tabor-normal-r%s-v%s-t2.wav \n' "$4" "$5"
}
{
  group 36 1 32 00 001 && group 36 33 95 00 064 && group 36 96 127 00 127
  group 38 1 32 80 001 && group 38 33 95 80 064 && group 38 96 127 80 127
} >expected
check "what they say" diff expected <(groups two/tabor.sfz)
same "the velocities are not applied twice" 1 "$(grep -cx 'amp_veltrack=0' two/tabor.sfz)"
same "of one take no round robin" 0 "$(grep -c seq_ one/tabor.sfz)"
same "one place is on the head's key" "key=38 lovel=1 hivel=127 sample=tabor-normal-r33-v064-t1.wav " \
  "$(groups single/tabor.sfz)"

# layers INSTRUMENT: velocities and speed of each layer of its first place.
layers() {
  awk '/^\/\/ normal/ { speed = $(NF - 1) } /^lovel/ { low = $0 }
    /^hivel/ && !seen[$0]++ { print low, $0, speed }' "$1" | sed 's/[a-z]*=//g'
}
same "layers and their speeds [m/s]" "1 32 0.3,33 95 2.58,96 127 10" "$(layers two/tabor.sfz | paste -sd ,)"
library tabor --velocities 3 --positions 1 --takes 1 -o full --velocity-range full
same "in the full range" "1 32 0.3,33 95 1.9,96 127 12" "$(layers full/tabor.sfz | paste -sd ,)"
done_quietly render tabor "${short[@]}" -q -o stroke.wav --strike midi=64 --velocity-range full
check "whose sounds are those strokes" cmp stroke.wav full/tabor-normal-r33-v064-t1.wav

# Every velocity of every key plays one group, whatever their number, and every sample is there.
for velocities in 1 2 8 127; do
  rm -rf many
  positions=$((velocities == 127 ? 1 : 8))
  run library frame-drum --velocities $velocities --positions $positions --takes 1 -o many --quality draft \
    --duration 0.01 --set quality.two_way_bandwidth=500
  same "status of $velocities velocities" 0 "$status"
  keys="36 38 41 43 45 47 48 50"
  [ $positions = 8 ] || keys=38
  gaps=$(groups many/frame-drum.sfz | awk -v keys="$keys" '
    { split($1, note, "="); split($2, low, "="); split($3, high, "=")
      for (v = low[2]; v <= high[2]; v++) count[note[2], v]++ }
    END {
      n = split(keys, key, " ")
      for (k = 1; k <= n; k++) for (v = 1; v <= 127; v++) if (count[key[k], v] != 1) wrong++
      print wrong + 0, length(count)
    }')
  same "of $velocities velocities none is missing or played twice" "0 $((127 * positions))" "$gaps"
  [ $velocities = 8 ] || continue
  sed -n 's/^sample=//p' many/frame-drum.sfz | sort >named
  check "it names the sounds that are there" diff named <(find many -name '*.wav' -printf '%f\n' | sort)
done
rm -rf many

# ---- what is said ----

run library tabor --velocities 2 --positions 2 --takes 2 -o facts "${short[@]}" --json
same "facts" "preset folder instrument rendered kept failed sounds" "$(json keys)"
same "of the run" "tabor facts/ facts/tabor.sfz 8 0 0 8" \
  "$(json preset) $(json folder) $(json instrument) $(json rendered) $(json kept) $(json failed) $(json sounds.size)"
same "of a sound" "tabor-normal-r80-v127-t2.wav normal 38 65 127 127 2" \
  "$(for key in file technique key low high midi take; do json sounds.7.$key; done | paste -sd ' ')"
holds "its stroke is scattered" "sqrt(($(json sounds.7.velocity) - 10) ^ 2) <= 10 * 0.06 * 0.5 &&
  $(json sounds.7.velocity) != 10 && sqrt(($(json sounds.7.radius) - 0.12) ^ 2) <= 0.015 * 0.5"
run library tabor --velocities 2 --positions 2 --takes 2 -o facts/ "${short[@]}"
same "a line" "facts/tabor.sfz: 8 sounds, 8 of them from before" "$(cat "$err")"
run library tabor --velocities 1 --positions 1 --takes 1 -o verbose "${short[@]}" -v --gain 60
check "a line for the sound" grep -q '^verbose/tabor-normal-r33-v064-t1.wav: tabor, ' "$err"
check "a warning that names it" grep -q '^tabor: warning: verbose/tabor-.*saturates' "$err"
printf 'wait left\nshow\nsignal 2\n' >script
"$TYPIST" script "$TABOR" library tabor -o seen --quality draft --duration 600 -j 1 >"$out"
check "progress on a terminal" grep -qE '^\|[0-9]+ of 96 done, [0-9]+ %, about [0-9]+:[0-5][0-9] left$' "$out"
done_quietly library frame-drum -o default --velocities 1 --positions 1 --takes 1 --duration 0.01 -q
check "live is the default" grep -q '"quality": *"live"' default/tabor-library.json

# Names that samplers would misread.
"$TABOR" show tabor >'my $drum=1.ini'
library 'my $drum=1.ini' --velocities 1 --positions 1 --takes 1 -o own
same "names" "my__drum_1-normal-r33-v064-t1.wav my__drum_1.sfz tabor-library.json tabor-library.sums " "$(files own)"
library tabor --velocities 1 --positions 1 --takes 1 -o stereo --mic top --mic top --rate 44100
same "two microphones" "2 44100" \
  "$("$TABOR" analyze stereo/*.wav --json | tee facts.json | "$INSPECT" json channels) $("$INSPECT" json rate <facts.json)"

# ---- taking up again ----

library tabor --velocities 3 --positions 2 --takes 2 -o two
check "nothing changes in a library that is there" diff -r two again
touch -d '2001-01-01' two/*.wav
rm two/tabor-normal-r00-v064-t2.wav two/tabor.sfz
library tabor --velocities 3 --positions 2 --takes 2 -o two
check "what is missing comes back" diff -r two again
same "the others are kept" 11 "$(find two -name '*.wav' ! -newermt 2002-01-01 | wc -l)"

# What was damaged is rendered again: emptied, cut off, or of another length.
done_quietly render tabor --quality draft --duration 0.1 -q -o short.wav
damaged() { same "$1 is rendered again" "1 11" "$(json rendered) $(json kept)" && check "$1" diff -r two again; }
for damage in 'truncate -s 0' 'truncate -s -1' 'truncate -s 44' 'truncate -s 6' "cp short.wav"; do
  $damage two/tabor-normal-r80-v001-t1.wav
  run library tabor --velocities 3 --positions 2 --takes 2 -o two "${short[@]}" --json
  damaged "a sound after '$damage'"
done
overwritten() { dd if=/dev/zero of="$1" bs=1 seek="$2" count="$3" conv=notrunc status=none; }
overwritten two/tabor-normal-r80-v001-t1.wav 200 8000
run library tabor --velocities 3 --positions 2 --takes 2 -o two "${short[@]}" --json
damaged "a sound of which a part was overwritten"
check "which is said" grep -qx 'two/tabor-normal-r80-v001-t1.wav: not the bytes that were written; it is rendered again' "$err"
truncate -s -5 two/tabor-library.sums
run library tabor --velocities 3 --positions 2 --takes 2 -o two "${short[@]}" --json
damaged "a sound whose checksum was cut off"
echo nonsense >>two/tabor-library.sums
run library tabor --velocities 3 --positions 2 --takes 2 -o two "${short[@]}" --json
same "a line that means nothing changes nothing" "0 12" "$(json rendered) $(json kept)"
check "and is gone" diff -r two again
rm two/tabor-library.sums
run library tabor --velocities 3 --positions 2 --takes 2 -o two "${short[@]}" --json
same "without checksums everything is rendered again" "12 0 " "$(json rendered) $(json kept) $(cat "$err")"
check "as a folder of an older version" diff -r two again
ringing=(library frame-drum "${one[@]}" --quality draft -o ringing)
done_quietly "${ringing[@]}" -q
cp -r ringing whole
run "${ringing[@]}" --json
same "a sound that rings as long as it does is kept" "0 1" "$(json rendered) $(json kept)"
truncate -s -4000 ringing/*.wav
done_quietly "${ringing[@]}" -q
check "unless it was cut off" diff -r whole ringing

long=(library tabor --velocities 4 --positions 2 --takes 2 --quality draft --duration 4 --format pcm16)
done_quietly "${long[@]}" -q -o undisturbed -j2
for signal in KILL TERM; do
  nice -n 5 "$TABOR" "${long[@]}" -o killed -j2 2>said &
  child=$!
  some_done() { [ "$(sounds killed 2>/dev/null)" -ge "$1" ]; }
  check "some sounds are done" wait_for some_done $(($(sounds killed 2>/dev/null) + 3))
  kill -$signal $child
  wait $child 2>/dev/null
  same "the run was ended by SIG$signal before its end" 0 "$(find killed -name '*.sfz' | wc -l)"
  holds "and sounds are missing" "$(sounds killed) < 16"
done
check "how to go on is said" grep -qx 'tabor: stopped; the same command renders what is missing' said
: >killed/.tabor-aBc123
done_quietly "${long[@]}" -q -o killed -j2
check "the bytes of an undisturbed run, and nothing else" diff -r undisturbed killed

# Until a folder is a library, nothing in it is of a run before.
mkdir shared
: >shared/.tabor-aBc123
library tabor "${one[@]}" -o shared
check "somebody else's file stays" test -e shared/.tabor-aBc123

# ---- two runs at once ----

rm -rf killed
nice -n 5 "$TABOR" "${long[@]}" --velocities 20 -o killed -j1 2>/dev/null &
child=$!
check "the first is at work" wait_for some_done 1
run "${long[@]}" --velocities 20 -o killed
expect_error 1 "another run is at work in 'killed/'"
kill $child
wait $child
same "which ends as it should" 143 $?
rm -rf killed

# ---- wrong requests: nothing is created or changed ----

shape=(--velocities 3 --positions 2 --takes 2)
other() { refused "'two/' holds another library, with $1" library tabor "${shape[@]}" -o two "${short[@]}" "${@:2}"; }
other "takes 2, not 3" --takes 3
other "velocities 3, not 4" --velocities 4
other 'quality "draft", not "live"' --quality live
other "rate 48000, not 44100" --rate 44100
other "seed 1, not 2" --seed 2
other "humanize 0.5, not 0.7" --humanize 0.7
other 'velocity-curve "linear", not "soft"' --velocity-curve soft
other 'velocity-range "normal", not "full"' --velocity-range full
other 'format "pcm24", not "float"' --format float
other "gain 0.0, not 1.0" --gain 1
other "frames 9600, not 4800" --duration 0.1
other 'batter.tension "3000", not "3100"' --set batter.tension=3100
refused "'two/' holds another library, with preset" library frame-drum "${shape[@]}" -o two "${short[@]}"
sed -i 's/tension = 3000/tension = 3200/' 'my $drum=1.ini'
refused "'own/' holds another library, with batter.tension" \
  library 'my $drum=1.ini' --velocities 1 --positions 1 --takes 1 -o own "${short[@]}"
mkdir foreign own_instrument broken
touch foreign/tabor-normal-r33-v064-t1.wav
refused "'foreign/tabor-.*' exists, but 'foreign/' holds no library" library tabor "${one[@]}" -o foreign
echo mine >own_instrument/tabor.sfz
refused "'own_instrument/tabor.sfz' exists, but 'own_instrument/' holds no library" \
  library tabor "${one[@]}" -o own_instrument
same "which stays" "tabor.sfz mine" "$(ls own_instrument) $(cat own_instrument/tabor.sfz)"
echo '{' >broken/tabor-library.json
refused "'broken/tabor-library.json' is no library's" library tabor "${one[@]}" -o broken
for json in '{}' '[]' '{"takes": 1}'; do
  echo "$json" >broken/tabor-library.json
  refused "'broken/tabor-library.json' is no library's: it names no" library tabor "${one[@]}" -o broken
done
refused "a library needs a folder: -o FOLDER" library tabor
refused "a library needs a folder" library tabor -o ''
refused "-o 'expected': not a folder" library tabor -o expected
refused "--techniques 'sweep': .*; there are: normal, rimshot, cross-stick, rim, buzz$" library tabor -o new --techniques normal,sweep
refused "--techniques 'rimshot': .*; there are: normal, rim, buzz$" library snare-14x5.5 --set strike.striker=brush -o new --techniques rimshot
refused "--techniques 'rimshit': .*; did you mean 'rimshot'" library tabor -o new --techniques rimshit
refused "--techniques: 'normal' given twice" library tabor -o new --techniques normal,normal
refused "--techniques: 'buzz' given twice" library tabor -o new --techniques buzz,normal,buzz
refused "--techniques ''" library tabor -o new --techniques ''
refused "--velocities '128': out of range; allowed: 1 to 127" library tabor -o new --velocities 128
refused "--positions '9': out of range; allowed: 1 to 8" library tabor -o new --positions 9
refused "--takes '0': out of range; allowed: 1 to 32" library tabor -o new --takes 0
refused "--takes '1.5': not a whole number" library tabor -o new --takes 1.5
refused "make 32512 sounds; allowed: up to 4096" library tabor -o new --velocities 127 --positions 8 --takes 32
refused "--takes 4: takes are all the same with --humanize 0" library tabor -o new --humanize 0
refused "--mic: 3 given; allowed: up to 2" library tabor -o new --mic top --mic top --mic top
refused "--mic 'tpo'" library tabor -o new --mic tpo
refused "unknown preset 'tabro'" library tabro -o new
refused "--jobs '0'" library tabor -o new --jobs 0
refused "unknown option '--normalize'" library tabor -o new --normalize
refused "unexpected argument 'tom-12'" library tabor tom-12 -o new
failed "missing.ini" library missing.ini -o new
failed "cannot create the folder 'missing/new/'" library tabor "${one[@]}" -o missing/new

# ---- what fails is said, and the instrument waits ----

two=(library tabor --velocities 2 --positions 1 --takes 1 -o failing "${short[@]}")
(ulimit -f 20 && exec "$TABOR" "${two[@]}" --json >"$out" 2>"$err")
same "status without room" 1 $?
same "two lines" 2 "$(grep -c "^tabor: cannot write 'failing/tabor-.*: File too large" "$err")"
same "facts" "null 0 0 2" "$(json instrument) $(json rendered) $(json kept) $(json failed)"
same "no instrument, nothing half-written" "tabor-library.json tabor-library.sums " "$(files failing)"
done_quietly "${two[@]}" -q
same "with room again" 2 "$(sounds failing)"

# Nothing is to be done, and nobody may write there; root may everywhere, and does it as somebody else.
chmod 755 "$private" "$work"
chmod 555 failing
somebody=()
if [ "$(id -u)" = 0 ]; then somebody=(setpriv --reuid 65534 --regid 65534 --clear-groups); fi
if "${somebody[@]}" "$TABOR" --version >"$out" 2>&1 && ! "${somebody[@]}" touch failing/x 2>"$err"; then
  before=$(snapshot)
  "${somebody[@]}" "$TABOR" "${two[@]}" --json >"$out" 2>"$err"
  same "status where nobody may write" "0 " "$? $(cat "$err")"
  same "all is there" "failing/tabor.sfz 0 2" "$(json instrument) $(json rendered) $(json kept)"
  same "and stays" "$before" "$(snapshot)"
else
  skip_part "a library where nobody may write: needs util-linux"
fi
chmod 755 failing
if "$TABOR" "${two[@]}" --json >/dev/full 2>"$err"; then complain "standard output is full"; fi
check "which is said" grep -q '^tabor: .*standard output: No space left' "$err"

finish
