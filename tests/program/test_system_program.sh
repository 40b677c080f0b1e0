#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The program doing what it is asked: facts, sounds, traces.

. "$(dirname "$0")/../support/host_checks.sh"

# What takes time is done at draft quality unless quality matters.
quick=(--quality draft)
short=(tabor -q "${quick[@]}" --duration 0.1)

# sound_of PRESET NAME ARGUMENT...: renders without a word.
sound_of() {
  local preset=$1 name=$2
  shift 2
  done_quietly render "$preset" -q "${quick[@]}" "$@" -o "$name"
}
# sound NAME ARGUMENT...: the same of a drum with wires that takes little time.
sound() { sound_of tabor "$@"; }
# brief NAME ARGUMENT...: the same for 0.1 s.
brief() { sound "$@" --duration 0.1; }
described() { same "what $1 is" "$2" "$("$INSPECT" sound "$1")"; }
setting() { grep -E "^$1 = " "$out" | sed 's/^[^=]*= *//; s/ *;.*//'; }

# ---- help and version ----

done_quietly --version
check "version" grep -qE '^tabor [0-9]+\.[0-9]+\.[0-9]+(-dev)?$' "$out"
version=$(cut -d ' ' -f 2 "$out")
done_quietly --version --json
same "version as JSON" "$version" "$(json version)"
done_quietly help render
check "help of a command" grep -q '^Usage: tabor render' "$out"
done_quietly help
cp "$out" help
done_quietly --help
check "help is --help" cmp -s help "$out"
for command in render presets show modes bench analyze; do
  check "help names $command" grep -q "^  $command " "$out"
  same "$command --version" "tabor $version" "$("$TABOR" $command --version)"
  check "$command --help" eval "'$TABOR' $command --help | grep -q '^Usage: tabor $command'"
  check "$command -h" eval "'$TABOR' $command --nothing -h 2>&1 | grep -q nothing"
done

# ---- presets ----

done_quietly presets
check "a table of presets" grep -qE '^tabor +[^ ]' "$out"
rows=$(wc -l <"$out")
done_quietly presets --json
same "presets as JSON" presets "$(json keys)"
same "as many" "$rows" "$(json presets.size)"
same "keys of a preset" "name category base comment file own" "$(json presets.0.keys)"
presets=()
for ((i = 0; i < rows; i++)); do presets+=("$(json "presets.$i.name")"); done
check "tabor is a preset" grep -qw tabor <<<"${presets[*]}"

# ---- the drum that is meant when none is named ----

done_quietly render "${quick[@]}" --duration 0.02 --json -o unnamed.wav
same "the default preset" snare-14x5.5 "$(json preset)"
done_quietly show
same "that show prints" snare-14x5.5 "$(setting name)"
for command in render show modes bench; do
  check "the help of $command names it" \
    eval "'$TABOR' $command --help | grep -qx 'Without one it is snare-14x5.5.'"
done

# ---- show ----

for preset in "${presets[@]}"; do
  done_quietly show "$preset"
  cp "$out" shown.ini
  check "a comment on every line of $preset" eval "! grep -E '^[a-z].*=' shown.ini | grep -vq ' ; '"
  same "no line of $preset too long" 0 "$(grep -cE '^.{199}' shown.ini)"
  done_quietly show ./shown.ini
  same_bytes "$preset reads back" shown.ini "$out"
  sound_of "$preset" a.wav --duration 0.05
  sound_of ./shown.ini b.wav --duration 0.05
  same_bytes "$preset sounds the same from its file" a.wav b.wav
done
done_quietly show --set shell.radius=0.2 --set batter.tension=1234.5 --set=shell.radius=0.21
same "the last --set counts" 0.21 "$(setting radius | head -n 1)"
same "all of them" 1234.5 "$(setting tension | head -n 1)"
check "unit and text" grep -qE '^tension = 1234.5 +; \[N/m\] [a-z]' "$out"

# tensions: those of both heads that `show` printed
tensions() { setting tension | head -n 2 | tr '\n' ' '; }
pitches() { echo "$(json pitches.batter) $(json pitches.resonant)"; }
done_quietly show --set batter.pitch=A3 --set resonant.pitch=330.5
tuned=$(tensions)
same "show writes the tension of a pitch" "0 0" "$(setting pitch | tr '\n' ' ' | sed 's/ $//')"
cp "$out" tuned.ini
done_quietly modes "${quick[@]}" --json ./tuned.ini
holds "which gives that pitch" "($(json pitches.batter) / 220 - 1)^2 + ($(json pitches.resonant) / 330.5 - 1)^2 < 1e-9"
in_file=$(pitches)
done_quietly modes "${quick[@]}" --json --set batter.pitch=A3 --set resonant.pitch=330.5
same "with or without a file between" "$in_file" "$(pitches)"
done_quietly show --set resonant.pitch=330.5 --set batter.tension=2000 --set batter.pitch=220
same "a pitch after a tension counts" "$tuned" "$(tensions)"
done_quietly show --set resonant.pitch=330.5 --set batter.pitch=220 --set batter.tension=2000
same "a tension after a pitch counts" 2000 "$(setting tension | head -n 1)"
done_quietly show --set shell.radius=0.16 --set batter.pitch=A3
smaller=$(tensions)
done_quietly show --set batter.pitch=A3 --set shell.radius=0.16
same "a pitch is that of the whole drum" "$smaller" "$(tensions)"
"$TABOR" show | sed '/^\[batter/,/^\[resonant/s/^pitch = 0 /pitch = A3 /' >pitched.ini
done_quietly show ./pitched.ini
same "a pitch in a file" "${tuned%% *}" "$(setting tension | head -n 1)"
refused "batter.pitch = 1046.5 is outside 48.2 to 522.5 Hz, the pitches of this head" show --set batter.pitch=C6
refused "pitched.ini with --set: batter.pitch = 523.25 is outside" show ./pitched.ini --set batter.pitch=C5
refused "neither a number from 0 to 20000 Hz nor a note such as Eb2\+30" show --set batter.pitch=H3
refused "resonant.pitch = 0.5 is neither 0 nor in 1 to 20000 Hz" show --set resonant.pitch=0.5

done_quietly show tabor --set drum.name=Mine
{ cat "$out" && printf '[mic.extra]\nheight = 0.5\n[striker.other]\nmass = 0.02\n'; } >more.ini
done_quietly show more.ini
check "a new microphone" grep -qx '\[mic.extra\]' "$out"
check "a new striker" grep -qx '\[striker.other\]' "$out"
cp "$out" shown.ini
done_quietly show shown.ini
same_bytes "they read back" shown.ini "$out"
outside=(--set mic.bottom.height=-0.2) # where a shell is no longer in its place
check "one head, one section" eval "! grep -q '^.resonant' '$out'"
done_quietly show frame-drum --set resonant.damping_0=17 "${outside[@]}"
check "a second head" grep -qx '\[resonant\]' "$out"
check "with defaults" grep -qE '^surface_density = 0.105 ' "$out"
cp "$out" shown.ini
done_quietly show shown.ini
same_bytes "it reads back" shown.ini "$out"
done_quietly show frame-drum --json --set resonant.damping_0=17 "${outside[@]}"
same "a key of the second head" 1 "$(grep -c '"resonant.damping_0"' "$out")"
refused "drum.comment" show --set 'drum.comment=one ; two'
for length in 187 188 189 254 255; do # as long as a text may be
  done_quietly show --set "drum.comment=$(printf 'x%.0s' $(seq $length))"
  cp "$out" shown.ini
  done_quietly show shown.ini
  same_bytes "a comment of $length bytes reads back" shown.ini "$out"
done
refused "drum.comment: the text is longer than 255 bytes" show --set "drum.comment=$(printf 'x%.0s' {1..256})"
done_quietly show --json
same "show as JSON" "name parameters" "$(json keys)"
same "keys of a parameter" "key value unit minimum maximum choices live text" "$(json parameters.0.keys)"

# ---- modes ----

done_quietly modes frame-drum "${quick[@]}"
rows=$(($(wc -l <"$out") - 3)) # without heading, empty line and pitch
check "the pitch at a lug" grep -qx 'at a lug: batter 190\.94 Hz (G3-45)' "$out"
done_quietly modes frame-drum --json "${quick[@]}"
same "modes as JSON" "modes pitches" "$(json keys)"
same "one head, one pitch" batter "$(json pitches.keys)"
holds "a single head's pitch is its (1,1)" "($(json pitches.batter) / $(json modes.1.frequency) - 1)^2 < 1e-8"
same "as many rows" "$rows" "$(json modes.size)"
same "keys of a mode" "m n frequency decay_rate t60 multiplicity head phase" "$(json modes.0.keys)"
same "the lowest mode" "0 1 1" "$(json modes.0.m) $(json modes.0.n) $(json modes.0.multiplicity)"
same "the next" "1 1 2" "$(json modes.1.m) $(json modes.1.n) $(json modes.1.multiplicity)"
same "head and phase" "batter null" "$(json modes.0.head) $(json modes.0.phase)"
holds "sorted" "$(json modes.0.frequency) < $(json modes.1.frequency)"
holds "t60" "$(json modes.0.t60) * $(json modes.0.decay_rate) - log(1000) < 1e-9"
vacuum=(--set air.density=0 --set batter.bending_stiffness=0 --set quality.losses=0 \
  --set batter.tension=3000 --set batter.surface_density=0.3 --set shell.radius=0.2)
done_quietly modes frame-drum --json "${quick[@]}" "${vacuum[@]}"
holds "Bessel's zero" \
  "($(json modes.0.frequency) / (2.404825557695773 / (2 * atan2(0, -1) * 0.2) * 100) - 1)^2 < 1e-18"
same "no decay, no t60" null "$(json modes.0.t60)"

# ---- the facts of a rendering ----

done_quietly render tabor "${quick[@]}" --json --duration 0.5 -o facts.wav --rate 44100 --mic top --mic top
same "keys" "preset rate frames channels peak real_time_factor newton energy output trace" "$(json keys)"
same "keys of newton" "mean max capped" "$(json newton.keys)"
same "keys of energy" "injected control stored head_loss wire_loss contact_loss damper_loss \
shell_loss radiated removed residual" "$(json energy.keys)"
same "facts" "tabor 44100 22050 2 facts.wav" \
  "$(json preset) $(json rate) $(json frames) $(json channels) $(json output)"
same "no trace" null "$(json trace)"
described facts.wav "wav pcm24 44100 2 22050"
holds "peak" "($(json peak) - $("$INSPECT" peak facts.wav))^2 < 1e-12"
holds "real time" "$(json real_time_factor) > 0"
holds "Newton" "$(json newton.mean) > 0 && $(json newton.max) >= $(json newton.mean)"
holds "a stick of some grams" "$(json energy.injected) > 1e-3 && $(json energy.injected) < 1"
holds "the ledger" "($(json energy.injected) + $(json energy.control) - $(json energy.stored) \
  - $(json energy.head_loss) - $(json energy.wire_loss) - $(json energy.contact_loss) \
  - $(json energy.damper_loss) - $(json energy.shell_loss) - $(json energy.radiated) \
  - $(json energy.removed) - $(json energy.residual))^2 < (1e-9 * $(json energy.injected))^2"
run render tabor "${quick[@]}" --duration 0.05 -o talk.wav
same "status" 0 "$status"
check "a line about it" grep -q '^talk.wav: tabor, 0.05 s, 48000 Hz, 1 channel, peak ' "$err"
same "nothing else" "1 0" "$(wc -l <"$err") $(wc -c <"$out")"
run render tabor "${quick[@]}" --duration 0.05 -v -o talk.wav
check "more" grep -q 'energy in J' "$err"
check "one wire is no wires" grep -q ', 1 wire with ' "$err"
done_quietly render tabor "${quick[@]}" --json --duration 0.02 -o facts.wav --trace facts.csv
same "the trace's name" facts.csv "$(json trace)"
run render tabor "${quick[@]}" --duration 0.05 --json -o talk.wav
same "JSON alone" 0 "$(wc -c <"$err")"

# ---- formats and rates ----

for rate in 22050 44100 96000 192000; do
  for container in wav flac au; do
    for encoding in pcm16 pcm24 float; do
      [ $container$encoding = flacfloat ] && continue
      sound f.$container --rate $rate --format $encoding --duration 0.02 --mic top --mic top
      described f.$container "$container $encoding $rate 2 $((rate / 50))"
    done
  done
done
sound rounded.wav --rate 22051 --duration 0.25
described rounded.wav "wav pcm24 22051 1 5513"
for encoding in pcm16 pcm24; do
  for container in wav flac au; do
    sound same.$container --format $encoding --duration 0.1
    check "$encoding in $container" "$INSPECT" equal same.wav same.$container
  done
done
sound whole.wav --duration 0.05 --format float
for bits in 16 24; do
  sound rounded.wav --duration 0.05 --format pcm$bits
  distance=$("$INSPECT" distance rounded.wav whole.wav)
  holds "$bits bits are the sound rounded to the nearest" \
    "$distance > 0 && $distance <= 0.5 / 2^($bits - 1)"
done

# ---- the same command, the same bytes ----

for file in once.wav once.flac once.au; do
  format=float
  [ $file = once.flac ] && format=pcm24
  sound $file --duration 0.3 --format $format
  cp $file first
  sleep 1.1
  sound $file --duration 0.3 --format $format
  same_bytes "twice the same $file" first $file
done

# ---- length ----

sound whole.wav --format float
frames=$("$INSPECT" sound whole.wav | cut -d ' ' -f 5)
holds "until it has died away" "$frames >= 24000 && $frames <= 20 * 48000"
sound traced.wav --format float --trace whole.csv
same_bytes "tracing changes nothing" whole.wav traced.wav
last=$(tail -n 1 whole.csv | cut -d , -f 7)
most=$(cut -d , -f 7 whole.csv | sort -g | tail -n 1)
holds "90 dB below the largest energy" "$last <= 1e-9 * $most || $frames == 20 * 48000"
sound later.wav --format float --strike time=3
same "the same length from the last stroke on" "0" "$((($("$INSPECT" sound later.wav |
  cut -d ' ' -f 5) - 144000 - frames) / 257))"
done_quietly render tabor -q "${quick[@]}" --set batter.damping_0=1000 --strike time=0 -o dead.wav
holds "half a second at least" "$("$INSPECT" sound dead.wav | cut -d ' ' -f 5) >= 24000"

ringing=(render frame-drum --quality draft --set air.density=0 --set batter.damping_0=0 \
  --set batter.damping_1=0 -o ringing.wav)
run "${ringing[@]}"
check "what is cut off is told" grep -q '^the drum still sounds where the file ends, 20 s after' "$err"
same "in one line" "2 0" "$(wc -l <"$err") $status"
run "${ringing[@]}" --duration 1
same "unless it was asked for" 1 "$(wc -l <"$err")"
done_quietly "${ringing[@]}" -q
run render tabor "${quick[@]}" --set batter.damping_0=100 -o dead.wav
same "nor where it has died away" 1 "$(wc -l <"$err")"

# ---- strokes ----

done_quietly show tabor
radius=$(setting radius | head -n 1)
holds "radius" "$radius >= 0.05"
sound none.wav --duration 0.2 --format float
sound zero.wav --duration 0.2 --format float --strike time=0
same_bytes "the preset's stroke" none.wav zero.wav
sound shifted.wav --duration 0.3 --format float --strike=time=0.1
same "0.1 s later" $(($("$INSPECT" first none.wav) + 4800)) "$("$INSPECT" first shifted.wav)"
sound two.wav --duration 0.3 --format float --strike time=0.1,velocity=1 --strike time=0
sound turned.wav --duration 0.3 --format float --strike time=0 --strike velocity=1,time=0.1
same_bytes "strokes in any order" two.wav turned.wav
# speed_of VELOCITY SPEED [OPTION...]
speed_of() {
  brief speed.wav --strike "velocity=$2"
  brief midi.wav --strike "midi=$1" "${@:3}"
  same_bytes "midi=$1 ${*:3} is $2 m/s" speed.wav midi.wav
}
speed_of 127 10
cp speed.wav fast.wav
speed_of 20 1
speed_of 1 0.3
other_bytes "and another sound" speed.wav fast.wav
speed_of 127 12 --velocity-range full
speed_of 1 0.3 --velocity-range full
speed_of 127 10 --velocity-curve hard
printf 'midi\n127\n' >events.csv
brief speed.wav --strike velocity=12
brief midi.wav --events events.csv --velocity-range full
same_bytes "in a file of events" speed.wav midi.wav
brief metres.wav --strike "radius=$(awk "BEGIN { printf \"%.17g\", $radius / 2 }")"
brief percent.wav --strike radius=50%
same_bytes "50 % of the head" metres.wav percent.wav
brief rim.wav --strike radius=100%
brief metres.wav --set "strike.radius=$radius"
same_bytes "on the rim" metres.wav rim.wav
brief centre.wav --strike radius=0%
other_bytes "and another sound" percent.wav centre.wav
brief named.wav --strike striker=stick,technique=normal
brief plain.wav
same_bytes "the stick is the striker" named.wav plain.wav
brief tight.wav --set batter.tension=5000
other_bytes "--set is heard" plain.wav tight.wav
brief draft.wav --quality draft
brief studio.wav --quality studio
other_bytes "--quality is heard" draft.wav studio.wav
brief live.wav --quality live
done_quietly render tabor -q --duration 0.1 -o default.wav
same_bytes "live is the default" live.wav default.wav
done_quietly render tabor -q --duration 0.1 -o key.wav --set quality.level=draft
same_bytes "unless --set says otherwise" draft.wav key.wav
brief key.wav --set quality.level=draft --quality studio
same_bytes "--quality says it louder" studio.wav key.wav
"$TABOR" show tabor | sed 's/^level = [a-z][a-z]*/level = draft/' >level.ini
check "a preset with a level" grep -q '^level = draft' level.ini
done_quietly render ./level.ini -q --duration 0.1 -o preset.wav
same_bytes "what a preset says is for programs that use the library" live.wav preset.wav
done_quietly modes tabor
cp "$out" modes
done_quietly modes tabor --quality live
same_bytes "modes are those of live, too" "$out" modes
done_quietly modes tabor --quality studio
other_bytes "of studio there are others" "$out" modes
strokes=()
for ((i = 0; i < 10000; i++)); do strokes+=(--strike "time=0.$((i % 10))"); done
run render "${short[@]}" -o many.wav "${strokes[@]}" --duration 1
same "a thousand strokes at once are no error" 0 "$status"
same "the rest is reported" 1 "$(grep -cE "9[0-9]{3} strokes were dropped" "$err")" # a few act, as sticks leave the head

# ---- gain ----

brief quiet.wav --format float
brief loud.wav --format float --gain 20
holds "20 dB are a factor of 10" \
  "($("$INSPECT" peak loud.wav) / $("$INSPECT" peak quiet.wav) / 10 - 1)^2 < 1e-12"
for encoding in pcm16 pcm24; do
  run render "${short[@]}" --format $encoding --gain 60 -o loud.wav
  same "saturation is no error" 0 "$status"
  same "one warning" 1 "$(grep -c 'warning: the peak of +[0-9.]* dBFS saturates' "$err")"
  holds "it saturates" "$("$INSPECT" peak loud.wav) >= 0.9999"
  gain=$(sed 's/.*--gain \([-0-9.]*\) .*/\1/' "$err")
  brief loud.wav --format $encoding --gain "$gain"
  holds "the gain of the warning just avoids it" \
    "$("$INSPECT" peak loud.wav) < 1 && $("$INSPECT" peak loud.wav) > 0.98"
done
brief loud.wav --format float --gain 60
holds "float does not saturate" "$("$INSPECT" peak loud.wav) > 1.5"

for encoding in pcm16 pcm24; do
  run render "${short[@]}" --format $encoding --gain -120 --set mic.top.gain=0.1 -o lost.wav
  same "silence is no error" "0 0" "$status $("$INSPECT" peak lost.wav)"
  same "but told" 1 "$(grep -c 'warning: the peak of -[0-9.]* dBFS is below half a step' "$err")"
done
brief kept.wav --format float --gain -120
holds "float keeps it" "$("$INSPECT" peak kept.wav) > 0"

# ---- the trace ----

sound t.wav --duration 0.25 --trace t.csv
same "columns" "time_s,head_m,wire_m,striker_m,striker_force_n,wire_force_n,energy_j" \
  "$(head -n 1 t.csv)"
same "a row a sample" 12001 "$(wc -l <t.csv)"
same "seven fields a row" 12001 "$(awk -F, 'NF == 7' t.csv | wc -l)"
same "times" 0 "$(awk -F, 'NR > 1 && ($1 * 48000 - NR + 1)^2 > 1e-12' t.csv | wc -l)"
same "only numbers" 0 "$(tail -n +2 t.csv | grep -cvE '^[-+0-9.e,]*$')"
check "the stick pushes" eval "awk -F, '\$5 > 0.1' t.csv | grep -q ."
sound_of frame-drum f.wav --duration 0.02 --trace f.csv
same "no wire, no fields" 0 "$(awk -F, 'NR > 1 && ($3 != "" || $6 != "")' f.csv | wc -l)"

finish
