#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render --split and --normalize.

. "$(dirname "$0")/../support/host_checks.sh"

short=(tabor -q --quality draft --duration 0.2)
files() { find . -mindepth 1 -printf '%P\n' | sort | tr '\n' ' '; }
peak() { "$INSPECT" peak "$1"; }

# ---- a file for each microphone ----

done_quietly render "${short[@]}" --split -o take.wav
same "all microphones" "take-bottom.wav take-far.wav take-left.wav take-right.wav take-top.wav " "$(files)"
for mic in top bottom far left right; do
  done_quietly render "${short[@]}" --mic $mic -o one.wav
  check "the sound of $mic" cmp -s one.wav take-$mic.wav
done
rm -f ./*
done_quietly render "${short[@]}" --split
same "the default name" "strike-bottom.wav strike-far.wav strike-left.wav strike-right.wav strike-top.wav " "$(files)"
rm -f ./*
mkdir a.b
done_quietly render "${short[@]}" --split --mic far --mic top -o a.b/x.y.FLAC
same "chosen ones" "a.b a.b/x.y-far.FLAC a.b/x.y-top.FLAC " "$(files)"
rm -rf ./*
done_quietly render "${short[@]}" --split --mic far -o "$PWD/x.au"
same "a single one" "x-far.au " "$(files)"
done_quietly render "${short[@]}" --split --json -o x.wav
same "names as JSON" "5 x-top.wav x-bottom.wav x-far.wav" \
  "$(json output.size) $(json output.0) $(json output.1) $(json output.2)"
same "channels of all" 5 "$(json channels)"
run render tabor --quality draft --duration 0.2 --split -o x.wav
check "a line about them" \
  grep -q '^x-top.wav ... x-right.wav: tabor, 0.20 s, 48000 Hz, 5 channels, peak' "$err"
done_quietly render "${short[@]}" --split --trace x.csv -o x.wav
same "with a trace" 9601 "$(wc -l <x.csv)"

# ---- all or none ----

rm -f ./*
echo old >take-far.wav
failed "'take-far.wav' exists" render "${short[@]}" -n --split -o take.wav
failed "'take-far.wav' exists" render "${short[@]}" -n --trace take-far.wav --split -o other.wav
refused "both name" render "${short[@]}" --trace take-far.wav --split -o take.wav
done_quietly render "${short[@]}" --split -o take.wav
check "without -n it is replaced" test "$(wc -c <take-far.wav)" -gt 100
rm -f ./*
mkdir take-far.wav
failed "it is a folder" render "${short[@]}" --split -o take.wav
rmdir take-far.wav
echo old >take-far.wav
chmod 444 take-far.wav
failed "write-protected" render "${short[@]}" --split -o take.wav
rm -f take-far.wav
ln -s take-top.wav take-far.wav
refused "are the same file" render "${short[@]}" --split -o take.wav
rm -f take-far.wav
ln -s /dev/full take-far.wav
failed "No space left" render "${short[@]}" --split -o take.wav
rm -f take-far.wav
failed "No such file" render "${short[@]}" --split -o missing/take.wav

# What appears while the drum plays stays, and the others do not come then either. (Here and below, a trace keeps
# the program at work for a second, and longer on a busy machine.)
nice -n 5 "$TABOR" render tabor -q -n --duration 10 --quality draft --split -o late.wav --trace late.csv 2>"$err" &
child=$!
check "rendering has begun" wait_for eval 'ls .tabor-* >/dev/null 2>&1'
echo first >late-far.wav
wait $child
status=$?
: >"$out"
expect_error 1 "late-far.wav.*exists"
same "the file that came first" first "$(cat late-far.wav)"
same "it alone" "late-far.wav " "$(files)"

# What the others would replace comes back, whatever it was.
rm -rf ./*
mkdir old
for mic in top bottom; do echo "old $mic" >late-$mic.wav; done
ln late-top.wav second-name.wav
nice -n 5 "$TABOR" render tabor -q --duration 10 --quality draft --split -o late.wav --trace late.csv 2>"$err" &
child=$!
check "rendering has begun" wait_for eval 'ls .tabor-* >/dev/null 2>&1'
mkdir late-far.wav
wait $child
status=$?
: >"$out"
expect_error 1 "late-far.wav.*Is a directory"
same "older files" "old top, old bottom" "$(cat late-top.wav), $(cat late-bottom.wav)"
check "the very same" test late-top.wav -ef second-name.wav
same "them alone" "late-bottom.wav late-far.wav late-top.wav old second-name.wav " "$(files)"
rmdir late-far.wav
done_quietly render "${short[@]}" --split -o late.wav
check "and are replaced in the end" test "$(wc -c <late-top.wav)" -gt 100
same "with nothing left over" "late-bottom.wav late-far.wav late-left.wav late-right.wav late-top.wav old second-name.wav " "$(files)"

# A trace in a folder that has gone.
rm -rf ./*
mkdir sub
echo old >take.wav
nice -n 5 "$TABOR" render tabor -q --duration 10 --quality draft -o take.wav --trace sub/t.csv 2>"$err" &
child=$!
check "rendering has begun" wait_for eval 'ls sub/.tabor-* >/dev/null 2>&1'
mv sub gone
wait $child
status=$?
expect_error 1 "sub/t.csv.*No such file"
same "the sound stays as it was" old "$(cat take.wav)"

# ---- to a peak of -1 dBFS ----

rm -rf ./*
done_quietly render "${short[@]}" --normalize --format float -o loud.wav
holds "-1 dBFS" "($(peak loud.wav) - 10^(-1 / 20))^2 < 1e-14"
done_quietly render "${short[@]}" --format float -o plain.wav
gain=$(awk "BEGIN { printf \"%.12g\", 20 * log($(peak loud.wav) / $(peak plain.wav)) / log(10) }")
done_quietly render "${short[@]}" --format float -o gain.wav --gain "$gain"
holds "but for the level the same" "$("$INSPECT" distance gain.wav loud.wav) < 1e-6"
for name in loud.flac loud.au loud.wav; do
  for encoding in pcm16 pcm24; do
    done_quietly render "${short[@]}" --normalize --format $encoding -o $name
    holds "$name in $encoding" "($(peak $name) - 10^(-1 / 20))^2 < 1e-9"
  done
done
done_quietly render "${short[@]}" --normalize --strike velocity=30 -o loud.wav
holds "what would saturate" "($(peak loud.wav) - 10^(-1 / 20))^2 < 1e-12"
done_quietly render "${short[@]}" --normalize --format float -o all.wav --mic far --mic top
holds "all channels" "($(peak all.wav) - 10^(-1 / 20))^2 < 1e-14"
done_quietly render "${short[@]}" --normalize --format float --split -o s.wav --mic far --mic top
holds "the loudest of the files" "($(peak s-top.wav) - 10^(-1 / 20))^2 < 1e-14"
done_quietly render "${short[@]}" --format float --split -o p.wav --mic far --mic top
holds "all by the same gain" \
  "($(peak s-far.wav) / $(peak s-top.wav) / $(peak p-far.wav) * $(peak p-top.wav) - 1)^2 < 1e-10"
cp loud.wav first.wav
sleep 1.1
done_quietly render "${short[@]}" --normalize --strike velocity=30 -o loud.wav
check "twice the same" cmp -s first.wav loud.wav
done_quietly render "${short[@]}" --normalize --trace loud.csv -o loud.wav
same "with a trace" 9601 "$(wc -l <loud.csv)"
done_quietly render "${short[@]}" --normalize --json -o loud.wav
holds "the peak that it has" "($(json peak) - 10^(-1 / 20))^2 < 1e-14"
done_quietly render tabor --quality draft -q --normalize -o ring.wav
frames=$("$INSPECT" sound ring.wav)
done_quietly render tabor --quality draft -q -o ring.wav
same "the same length" "$frames" "$("$INSPECT" sound ring.wav)"
"$TABOR" render "${short[@]}" --normalize -o - >stream.au
"$TABOR" render "${short[@]}" --normalize -o file.au
check "as a stream" cmp -s stream.au file.au
run render tabor --quality draft --duration 0.2 --normalize -v -o loud.wav
check "the gain is told" grep -qE '^normalized by [+-][0-9.]+ dB$' "$err"
run render "${short[@]}" --normalize --set mic.top.gain=0 -o silent.wav
same "silence stays" "0 0" "$status $(peak silent.wav)"
same "with a warning" 1 "$(grep -c 'warning: the sound is silent' "$err")"

finish
