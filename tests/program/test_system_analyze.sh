#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tabor analyze: partials of sounds that are known.

. "$(dirname "$0")/../support/host_checks.sh"
: "${SYNTHESISE:?host_synthesise}"

# partials HZ,DBFS,DECAY...: the last run found just these, each within 1 cent, 0.3 dB and 2 %.
partials() { near 1 0.3 0.02 "$@"; }
# near CENTS DB SHARE HZ,DBFS,DECAY...
near() {
  local cents=$1 level=$2 share=$3 wanted
  shift 3
  same "as many partials" $# "$(json partials.size)"
  "$INSPECT" json partials <"$out" |
    rows_of_json >rows
  for wanted in "$@"; do
    checks=$((checks + 1))
    awk -v wanted="$wanted" -v cents="$cents" -v level="$level" -v share="$share" '
      BEGIN { split(wanted, w, ",") }
      function size(x) { return x < 0 ? -x : x }
      size(1200 * log($1 / w[1]) / log(2)) < cents && size($2 - w[2]) < level &&
        size($3 - w[3]) <= share * w[3] { found = 1 }
      END { exit !found }' rows || complain "no partial near $wanted in: $(tr '\n' ';' <rows)"
  done
}
# "frequency level decay_rate" of each partial, from JSON on one line.
rows_of_json() {
  tr -d ' \n' | grep -oE '"frequency":[^}]*' |
    sed 's/"frequency":\([^,]*\),"level":\([^,]*\),"decay_rate":\([^,]*\),.*/\1 \2 \3/'
}

# ---- single partials ----

# single RATE PARTIAL
single() {
  "$SYNTHESISE" one.wav "$1" 1 2 0.1 -999 "$2"
  done_quietly analyze one.wav --json
  partials "$2"
}
for partial in 40,-3,2 110,-20,5 440,0,1 997.3,-30,25 3141.6,-60,80 8000,-6,300; do single 48000 $partial; done
for rate in 22050 44100 96000 192000; do
  for partial in 40,-3,2 8000,-6,300; do single $rate $partial; done
done
"$SYNTHESISE" one.wav 48000 1 3 0 -999 440,-6,0
done_quietly analyze one.wav --json
partials 440,-6,0
same "a steady tone has no t60" null "$(json partials.0.t60)"
"$SYNTHESISE" one.wav 48000 1 1 0 -999 440,-40,-5
done_quietly analyze one.wav --json
holds "a growing one" "($(json partials.0.decay_rate) + 5)^2 < 0.01"
same "has none either" null "$(json partials.0.t60)"

# ---- several ----

drum=("200,-6,10" "348,-12,9" "485,-20,12" "524,-14,19" "2000,-10,60" "5000,-20,200")
"$SYNTHESISE" drum.wav 48000 1 2 0.25 -999 "${drum[@]}"
done_quietly analyze drum.wav --json
partials "${drum[@]}"
same "keys" "file rate channels frames partials" "$(json keys)"
same "keys of a partial" "frequency level decay_rate t60" "$(json partials.0.keys)"
same "facts" "drum.wav 48000 1 96000" \
  "$(json file) $(json rate) $(json channels) $(json frames)"
holds "t60" "($(json partials.0.t60) * $(json partials.0.decay_rate) - log(1000))^2 < 1e-18"
holds "strongest first" "$(json partials.0.level) >= $(json partials.1.level) && \
  $(json partials.1.level) >= $(json partials.2.level)"
cp "$out" whole.json
done_quietly analyze drum.wav --json
check "twice the same" cmp -s "$out" whole.json
done_quietly analyze drum.wav --json --count 2
partials 200,-6,10 2000,-10,60
done_quietly analyze drum.wav --json --min-level=-15
partials 200,-6,10 2000,-10,60 348,-12,9 524,-14,19
done_quietly analyze drum.wav
same "a table" "7 4" "$(wc -l <"$out") $(awk 'NR == 2 { print NF }' "$out")"
check "with a heading" grep -q '^ *frequency/Hz *level/dBFS *decay/(1/s) *t60/s$' "$out"
wide=()
for ((i = 1; i <= 12; i++)); do wide+=("$((150 * i)),$((-5 * i)),$((4 + i))"); done
"$SYNTHESISE" wide.wav 44100 1 3 0.1 -999 "${wide[@]}"
done_quietly analyze wide.wav --json --count 100
partials "${wide[@]}"
done_quietly analyze wide.wav --json
same "ten by default" 10 "$(json partials.size)"
"$SYNTHESISE" close.wav 48000 1 4 0.1 -999 440,-6,1.5 452,-10,2 470,-20,1
done_quietly analyze close.wav --json
partials 440,-6,1.5 452,-10,2 470,-20,1

# ---- noise ----

"$SYNTHESISE" noisy.wav 48000 1 3 0.1 -80 200,-6,10 348,-12,9 485,-20,12 2000,-10,60
done_quietly analyze noisy.wav --json
partials 200,-6,10 348,-12,9 485,-20,12 2000,-10,60
"$SYNTHESISE" noisy.wav 48000 1 3 0.1 -50 200,-6,10 348,-12,9 2000,-10,60
done_quietly analyze noisy.wav --json
near 2 0.7 0.05 200,-6,10 348,-12,9 2000,-10,60
# noise RATE SECONDS
noise() {
  "$SYNTHESISE" noise.wav "$1" 1 "$2" 0 -20
  run analyze noise.wav --json
  same "noise has no partials" "0 0" "$status $(json partials.size)"
  same "with a warning" 1 "$(grep -c 'warning: .*noise.wav.* no partial that stands out' "$err")"
}
for seconds in 0.1 1 6; do noise 48000 $seconds; done
for rate in 22050 192000; do noise $rate 1; done

# ---- files, channels, parts ----

"$SYNTHESISE" three.wav 44100 3 1 0.1 -999 300,-10,10
done_quietly analyze three.wav --channel 3 --json
partials 300,-10,10
same "of three" 3 "$(json channels)"
run analyze three.wav --json
same "silence has none" "0 0" "$status $(json partials.size)"
same "with a warning" "tabor: warning: 'three.wav' is silent" "$(cat "$err")"
refused "--channel '4': 'three.wav' has 3" analyze three.wav --channel 4
"$SYNTHESISE" first.wav 48000 1 2 0 -999 250,-10,8
"$SYNTHESISE" second.wav 48000 1 4 2 -999 400,-10,8
done_quietly analyze second.wav --json --from 1.5 --to 3.5
partials 400,-10,8
same "frames of the file" 192000 "$(json frames)"
run analyze second.wav --to 1.9
check "a silent part" grep -q 'silent' "$err"
refused "--from '4': 'second.wav' is 4 s long" analyze second.wav --from 4
refused "--from '2': not before --to 2" analyze second.wav --from 2 --to 2
failed "'second.wav' is too short: 0.030 s" analyze second.wav --from 2 --to 2.03
"$SYNTHESISE" brief.wav 48000 1 0.03 0 -999 1000,-10,8
failed "too short: 0.030 s from its onset on; needed: 0.040 s" analyze brief.wav
"$SYNTHESISE" brief.wav 48000 1 0.05 0 -999 1000,-10,8
done_quietly analyze brief.wav --json
partials 1000,-10,8
"$SYNTHESISE" empty.wav 48000 1 0 0 -999
run analyze empty.wav
check "no frame at all" grep -q 'silent' "$err"
"$SYNTHESISE" long.wav 22050 1 121 0 -999 1000,-10,1
refused "'long.wav' is too long; take at most 120 s" analyze long.wav
done_quietly analyze long.wav --to 5 --json
partials 1000,-10,1
same "all frames counted" 2668050 "$(json frames)"

refused "analyze needs a sound file" analyze
refused "analyze needs a sound file" analyze ''
refused "unexpected argument" analyze first.wav second.wav
failed "cannot read 'missing.wav': No such file" analyze missing.wav
failed "cannot read '.': it is a folder" analyze .
failed "cannot read standard input: " analyze - <<<"no sound"
failed "cannot read standard input: it is a folder" analyze - <.
failed "cannot read '/dev/null'" analyze /dev/null
echo "no sound at all" >text.wav
failed "cannot read 'text.wav'" analyze text.wav
head -c 20 first.wav >cut.wav
failed "cannot read 'cut.wav'" analyze cut.wav
if [ "$(id -u)" != 0 ]; then
  chmod 0 cut.wav
  failed "cannot read 'cut.wav': Permission denied" analyze cut.wav
  chmod 644 cut.wav
fi
head -c 200000 first.wav >cut.wav
done_quietly analyze cut.wav --json
partials 250,-10,8
for value in 0 -1 1.5 nan 1001 x; do refused "--count '$value'.*allowed" analyze first.wav --count $value; done
for value in 0 1025 nan; do refused "--channel '$value'.*allowed" analyze first.wav --channel $value; done
for value in -1 nan 1e300; do
  refused "--from '$value'.*allowed" analyze first.wav --from $value
  refused "--to '$value'.*allowed" analyze first.wav --to $value
done
refused "--min-level '-201'.*allowed: -200 to 100" analyze first.wav --min-level=-201
refused "unknown option '--chanel'; did you mean '--channel'" analyze first.wav --chanel 1
for option in count channel from to min-level; do
  refused "--$option needs a value" analyze first.wav --$option
done
"$TABOR" analyze drum.wav >/dev/full 2>"$err"
status=$?
: >"$out"
expect_error 1 "standard output: No space left"

# ---- a drum ----

done_quietly modes frame-drum --quality studio --json
for mode in 0 1 2; do frequencies[mode]=$(json "modes.$mode.frequency"); done
for container in wav flac au; do
  done_quietly render frame-drum --quality studio -q --duration 1.5 --mic bottom -o drum.$container
  done_quietly analyze drum.$container --json --count 50
  rows_of_json <"$out" >rows
  for frequency in "${frequencies[@]}"; do
    check "$frequency Hz within 2 cents in $container" awk -v f="$frequency" '
      { c = 1200 * log($1 / f) / log(2) } c * c < 4 { found = 1 } END { exit !found }' rows
  done
done
"$TABOR" render frame-drum --quality studio -q --duration 1.5 --mic bottom -o - | "$TABOR" analyze - --json --count 50 >piped
sed 's/"file": "[^"]*"/"file": "-"/' "$out" | diff - piped >/dev/null
same "through a pipe" 0 $?

finish
