#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Preset files as users write, cut and damage them.

docs=$(cd "$(dirname "$0")/../../docs" && pwd)
. "$(dirname "$0")/../support/host_checks.sh"

done_quietly show tabor
cp "$out" good.ini

# bad PATTERN: the preset bad.ini is refused by every command.
bad() {
  local command
  for command in show render modes; do
    refused "$1" $command bad.ini
  done
}

# with LINE...: a good preset with these lines behind it.
with() {
  { cat good.ini && printf '%s\n' "$@"; } >bad.ini
}

# ---- the user's own ----

mkdir -p "$XDG_DATA_HOME/tabor"
"$TABOR" show tom-12 | sed "s/^comment = .*/comment = a tom of mine/" >"$XDG_DATA_HOME/tabor/my-tom.ini"
"$TABOR" show --kit jazz >"$XDG_DATA_HOME/tabor/my-kit.ini"
echo "[window]" >"$XDG_DATA_HOME/tabor/else.ini"
done_quietly presets
same "presets lists a drum of one's own, last" "my-tom tom a tom of mine (your own)" "$(tail -n 1 "$out" | tr -s ' ')"
same "and no kit, and nothing else" 0 "$(grep -c 'my-kit\|else' "$out")"
done_quietly presets --kits
same "kits likewise" "my-kit kit" "$(tail -n 1 "$out" | tr -s ' ' | cut -d ' ' -f 1,2)"
done_quietly presets --json
at=$(($(json presets.size) - 1))
same "as JSON" "my-tom true $XDG_DATA_HOME/tabor/my-tom.ini" \
  "$(json presets.$at.name) $(json presets.$at.own) $(json presets.$at.file)"
rm -r "$XDG_DATA_HOME"

# ---- files that cannot be read ----

failed "missing.ini" show missing.ini
failed "missing/tabor.ini" show missing/tabor.ini
failed "good.ini/x" show good.ini/x
mkdir folder.ini
failed "folder.ini" show folder.ini
failed "\./" show ./
failed "/dev/null" show /dev/null
mkfifo fifo.ini
failed "fifo.ini" show fifo.ini
if [ "$(id -u)" != 0 ]; then
  cp good.ini secret.ini
  chmod 0 secret.ini
  failed "secret.ini" show secret.ini
  rm -f secret.ini
fi

# ---- files that are no presets ----

: >bad.ini
run show bad.ini # no pairs at all: a drum of defaults without striker or microphone
same "empty preset" 2 "$status"
head -c 3000 "$TABOR" >bad.ini
bad "bad.ini"
printf '\211PNG\r\n\032\n' >bad.ini
bad "bad.ini"
{ head -n 8 good.ini && printf 'comment = a\0b\n' && tail -n +9 good.ini; } >bad.ini
bad "bad.ini"
printf '[drum]\nname = caf\351\n' >bad.ini
bad "bad.ini"
with "; $(printf 'x%.0s' {1..900})"
bad "bad.ini"
with "; $(printf 'x%.0s' {1..510})"
bad "bad.ini"
{ cat good.ini && for ((i = 0; i < 22000; i++)); do echo "; forty-eight bytes of comment to fill a preset up"; done; } >bad.ini
check "the large preset is too large" test "$(wc -c <bad.ini)" -gt 1048576
bad "bad.ini"
echo 'tension = 3000' >bad.ini
bad "bad.ini"
{ echo tension = 3000 && cat good.ini; } >bad.ini
bad "bad.ini"

# Cut within a key or a value: the rest of a number is a number, too.
for cut in tens 'tension ' 'tension =' 'tension = ' 'tension = 3' 'tension = 30'; do
  sed "/^tension = /{s/.*/$cut/;q}" good.ini | head -c -1 >bad.ini
  bad "bad.ini:"
done
head -c 3 good.ini >bad.ini
run show bad.ini
same "cut in the first line" 2 "$status"

# ---- lines that are wrong ----

with "[batter]" "tension = 3000"
bad "batter|tension"
sed 's/^tension = .*/&\n&/' good.ini >bad.ini
bad "tension"
with "[nonsense]" "key = 3"
bad "nonsense"
with "[baffle]" "tension = 3"
bad "baffle"
sed 's/^tension /tensoin /' good.ini >bad.ini
bad "tensoin"
sed 's/^\(tension =\).*/\1/' good.ini >bad.ini
bad "tension"
sed 's/^\(tension\) =.*/\1/' good.ini >bad.ini
bad "bad.ini"
sed 's/^\(tension\) =/\1:/' good.ini >bad.ini
bad "bad.ini"
sed 's/^\(tension\) =/ \1 =/' good.ini >bad.ini
bad "bad.ini"
for value in nan inf 1e400 -3000 0 1e300 3000x "3000 4000" 0x800 "3,000"; do
  sed "s/^\(tension =\).*/\1 $value ; [N\/m]/" good.ini >bad.ini
  bad "tension"
done
with "[wires]" "count = 3.5"
bad "bad.ini"

with "[foo]"
bad "bad.ini:[0-9]*: unknown section 'foo'$"
with "[strikr.z]"
line=$(wc -l <bad.ini)
bad "bad.ini:$line: unknown section 'strikr.z'; did you mean 'striker.z'"
with "[resonnant]" "tension = 2000"
bad "bad.ini:$((line)): unknown section 'resonnant'; did you mean 'resonant'"
with "[striker]"
bad "unknown section 'striker'; did you mean 'striker.NAME'"
with "[wire.41]"
bad "unknown section 'wire.41': wires are numbered 1 to 40"
with "[mic.a b]"
bad "unknown section 'mic.a b': a name has 1 to 40 letters"
with "[mic.$(printf 'x%.0s' {1..41})]"
bad "a name has 1 to 40 letters"
with "[mic.1]" "[mic.2]" "[mic.3]" "[mic.4]" "[mic.5]" "[mic.6]"
bad "bad.ini:[0-9]*: mic.4: a drum has at most 8 microphones"
printf '[drum]\nname = nothing else\n' >bad.ini
bad "bad.ini: the drum has 0 strikers; it needs 1 to 8"
sed '/^\[strike\]/,$s/^radius = .*/radius = 0.5/' good.ini >bad.ini
bad "bad.ini: strike.radius = 0.5 is beyond shell.radius"
refused "good.ini with --set: strike.radius = 0.5" show good.ini --set strike.radius=0.5

# ---- files that are right ----

done_quietly show good.ini
check "show reads back what it wrote" cmp -s good.ini "$out"
sed 's/$/\r/' good.ini >dos.ini
done_quietly show dos.ini
check "line ends of Windows" cmp -s good.ini "$out"
sed '0,/^tension =.*/s//tension = 2345/' good.ini >mine.ini
done_quietly show ./mine.ini
check "a changed value" grep -q '^tension = 2345 ' "$out"
mkdir presets
cp mine.ini presets/mine
done_quietly show presets/mine
check "a '/' means a file" grep -q '^tension = 2345 ' "$out"
done_quietly render mine.ini -q --quality draft -o mine.wav --duration 0.05
done_quietly render tabor -q --quality draft --set batter.tension=2345 -o set.wav --duration 0.05
check "file and --set give the same sound" cmp -s mine.wav set.wav
{ sed 's/^height = -.*/height = -0.3/' good.ini && printf '[resonant]\ntension = 2100\n'; } >two.ini
done_quietly show two.ini
same "a section brings the second head" "[resonant] tension = 2100 pitch = 0 surface_density = 0.105" \
  "$(grep -A 3 '^\[resonant\]' "$out" | sed 's/ *;.*//' | tr '\n' ' ' | sed 's/ $//')"
cp "$out" shown.ini
done_quietly show shown.ini
check "and reads back" cmp -s shown.ini "$out"
{ sed 's/^height = -.*/height = -0.3/' good.ini && printf '[mic.b]\n[resonant]\n[striker.a]\n'; } >bare.ini
done_quietly show bare.ini
cp "$out" shown.ini
sed 's/^height = -.*/height = -0.3/' good.ini >keyed.ini
printf '[mic.b]\ngain = 1\n[resonant]\ntension = 2600\n[striker.a]\nmass = 0.012\n' >>keyed.ini
done_quietly show keyed.ini
check "sections without a key make what sections with one make" cmp -s shown.ini "$out"
printf '[striker.a]\n[mic.b]\n' >bare.ini
done_quietly show bare.ini
same "a drum of defaults" "3000" "$(sed -n 's/^tension = \([0-9]*\) .*/\1/p' "$out" | head -n 1)"
done_quietly render bare.ini -q --quality draft --duration 0.02 --format float -o bare.wav
{ cat two.ini && printf 'tensoin = 3\n'; } >bad.ini
bad "bad.ini:[0-9]*: unknown key 'resonant.tensoin'; did you mean 'resonant.tension'"
{ cat two.ini && printf 'surface_density = 9\n'; } >bad.ini
bad "surface_density = 9 is outside"
sed -n '/^```ini$/,/^```$/{/^```/!p}' "$docs/presets.md" >manual.ini
done_quietly render manual.ini -q --quality draft --duration 0.02 --format float -o manual.wav
cp good.ini guarded.ini
refused "overwrite the preset" render guarded.ini -q --trace guarded.ini

finish
