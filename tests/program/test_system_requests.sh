#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Wrong requests: each is refused with status 2 and one line that names what is wrong.

. "$(dirname "$0")/../support/host_checks.sh"

echo precious >strike.wav # the default output
echo precious >a.wav

# ---- commands and options ----

refused "no command"
refused "unknown command 'rendr'; did you mean 'render'" rendr
refused "unknown command 'zzzzzzzz'; there are: render, library, play, presets, show, modes, bench, analyze, devices, fit$" zzzzzzzz
refused "unknown command ''; there are: render" ''
refused "unknown command 'hlep'" hlep
refused "unknown command 'rendr'; did you mean 'render'" help rendr
refused "unexpected argument 'b'" help render b
for command in presets show modes bench analyze; do refused "unknown option '-v'" $command -v; done
for command in render presets show modes bench; do
  refused "unknown option '--jsn'; did you mean '--json'" $command --jsn
  refused "unknown option '-x'" $command -x
  refused "--json takes no value" $command --json=yes
done
for command in show modes bench; do refused "unexpected argument" $command tabor second; done
refused "unexpected argument 'tabor'" presets tabor
refused "unknown option '--rate'" show --rate 48000
refused "unknown option '--durat'; did you mean '--duration'" render --durat 1
for option in output format rate quality duration strike events set mic gain trace jobs; do
  refused "--$option needs a value" render --$option
done
refused "--output needs a value" render -o

# ---- numbers ----

absurd=(nan NaN inf -inf infinity 1e400 -1e400 '' ' ' 3x x3 0x1p3 0x10 ' 1' '1 ' '1,5' 1e 1e+ . + - -e1 1.2.3 --3 $'1\n')
for number in "${absurd[@]}"; do
  refused "--rate .*allowed: 22050 to 192000" render "--rate=$number"
  refused "--duration .*allowed: 0.01 to 3600" render "--duration=$number"
  refused "--gain .*allowed: -120 to 120" render "--gain=$number"
  refused "shell.radius" render --set "shell.radius=$number"
  refused "strike: |--strike .*(allowed|FIELD=VALUE)" render --strike "velocity=$number"
done
for rate in 0 -1 22049 192001 48000.5 1e9 1e-400; do
  refused "--rate '$rate'.*allowed: 22050 to 192000" render --rate $rate
  refused "--rate '$rate'.*allowed: 22050 to 192000" modes --rate $rate
done
for duration in 0 -1 0.009 3600.1 1e300; do
  refused "--duration '$duration'.*allowed: 0.01 to 3600" render --duration $duration
done
for gain in -121 120.1 1e300; do
  refused "--gain '$gain'.*allowed" render --gain $gain
done
# The tabor's lower microphone stands where a second head would be.
refused "mic.bottom.height = -0.12: the microphone would be within 0.01 m of the resonant head" \
  show tabor --set resonant.tension=2000 --set shell.depth=0.12
for radius in 0 -1 0.04 0.61 1e300; do
  refused "shell.radius" render --set shell.radius=$radius
  refused "shell.radius" show --set shell.radius=$radius
  refused "shell.radius" modes --set shell.radius=$radius
done

# ---- names ----

for command in render show modes bench; do
  refused "tabro.*'?tabor" $command tabro
  refused "preset" $command ''
  refused "tension" $command --set batter.tensoin=3000
  refused "nonsense" $command --set nonsense=3
  refused "KEY=VALUE" $command --set batter.tension
  refused "KEY=VALUE" $command --set =3000
  refused "KEY=VALUE" $command --set ''
  refused "shell.boundary" $command --set shell.boundary=leather
  refused "wires.head = resonant: the drum has no resonant head" $command tabor --set wires.head=resonant
  refused "resonant.tension" $command --set resonant.tensoin=2000
  refused "shell.boundary = closed is for a single head" $command tabor \
    --set resonant.tension=2000 --set shell.boundary=closed --set mic.bottom.height=-0.2
  refused "wires.count" $command --set wires.count=1.5
  refused "wires.count" $command --set wires.count=41
  refused "wires.count" $command --set wires.count=-1
  refused "so long a key" $command --set "$(printf 'k%.0s' {1..5000})=3"
  refused "no microphone 'tpo'; did you mean 'mic.top'" $command --set mic.tpo.gain=3
  refused "no striker 'stik'; did you mean 'striker.stick'" $command --set striker.stik.mass=1
  refused "no microphone ''" $command --set mic..gain=1
  refused "mic.gain" $command --set mic.gain=1
  refused "mic.top.gian" $command --set mic.top.gian=1
done
refused "--mic 'tpo'.*did you mean 'top'" render --mic tpo
refused "--mic ''" render --mic ''
refused "--mic 'nosuch': .*; there are: top, bottom, far, left, right$" render tabor --mic nosuch
refused "no striker 'foo'; there are: striker.stick$" show tabor --set striker.foo.mass=1
refused "no microphone 'nosuch'; there are: mic.top, mic.bottom, mic.far, mic.left, mic.right$" show tabor --set mic.nosuch.gain=1
for text in nan x '' 1e; do
  refused "batter.tension = '$text' is not a number from 100 to 20000 N/m" show --set "batter.tension=$text"
done
refused "unknown key 'foo.bar'$" show --set foo.bar=1
refused "unknown key '-'$" show --set -=1
refused "unknown preset 'foo.bar'; 'tabor presets' lists them" show foo.bar
refused "unknown preset '-'; 'tabor presets' lists them" show -
refused "--quality 'sudio'.*did you mean 'studio'" render --quality sudio
refused "--quality" modes --quality ''
refused "--format 'pcm32'.*pcm16, pcm24, float" render --format pcm32
refused "--format ''" render --format ''

# ---- strokes ----

refused "FIELD=VALUE" render --strike ''
refused "FIELD=VALUE" render --strike velocity
refused "FIELD=VALUE" render --strike velocity=2,
refused "FIELD=VALUE" render --strike ,velocity=2
refused "unknown field 'velocty'; did you mean 'velocity'" render --strike velocty=2
refused "unknown field ''" render --strike =2
refused "unknown field 'foo'; there are: time, velocity, midi, radius, angle, striker, technique, pressure, hold, id, event, wire, place, displacement, pull, drum$" \
  render --strike foo=2
refused "time: given twice" render --strike time=1,time=2
refused "given twice" render --strike velocity=1,midi=3
refused "time '-0.1'.*allowed: 0 to 3600" render --strike time=-0.1
refused "time '3601'.*allowed" render --strike time=3601
refused "velocity '0'.*allowed: 0.01 to 30" render --strike velocity=0
refused "velocity '31'.*allowed: 0.01 to 30" render --strike velocity=31
refused "angle '361'.*allowed: -360 to 360" render --strike angle=361
refused "radius '-0.01'.*allowed: 0 to" render --strike radius=-0.01
refused "radius '0.6'.*allowed: 0 to" render --strike radius=0.6
refused "per cent '101'.*allowed: 0 to 100" render --strike radius=101%
refused "per cent '-1'.*allowed: 0 to 100" render --strike radius=-1%
refused "per cent ''" render --strike radius=%
refused "per cent 'nan'" render --strike radius=nan%
for midi in 0 128 1.5 -3 nan; do
  refused "midi '$midi'.*allowed: 1 to 127" render --strike midi=$midi
done
refused "striker 'stik'.*did you mean 'stick'" render --strike striker=stik
refused "striker ''" render --strike striker=
refused "striker 'foo': the drum has no such striker; there are: stick$" render tabor --strike striker=foo
refused "technique 'foo': unknown; there are: normal, rimshot, cross-stick, rim, buzz, sweep, pedal, pluck$" render --strike technique=foo
refused "technique 'pluck': the drum has no wires" render tom-12 --strike technique=pluck
refused "wire '21': out of range; allowed: 1 to 20" render snare-14x5.5 --strike technique=pluck,wire=21
refused "velocity: a pluck has none; it has wire, place, displacement and pull" render --strike technique=pluck,velocity=3
refused "wire: only strokes of technique pluck have one" render --strike wire=1
refused "place '1.5'.*0 to 1" render --strike technique=pluck,place=1.5
refused "technique 'sweep': striker 'stick' is no brush$" render --strike technique=sweep,striker=stick
refused "technique 'cross-stick': striker 'brush' is a brush, which has no shaft to meet the hoop$" render snare-14x5.5 --strike technique=cross-stick,striker=brush
refused "--strike hold: only strokes of technique buzz or sweep have one$" render --strike technique=rimshot,hold=1
refused "--strike pressure: only strokes of technique buzz or sweep have one$" render --strike pressure=0.5
refused "velocity '5.1': out of range for a sweep; allowed: 0.01 to 5$" \
  render --strike striker=brush,technique=sweep,velocity=5.1
refused "velocity '10': out of range for a sweep; allowed: 0.01 to 5$" \
  render --strike midi=127,technique=sweep,striker=brush
refused "technique 'norml'.*did you mean 'normal'" render --strike technique=norml
refused "too long" render --strike "striker=$(printf 's%.0s' {1..5000})"
refused "the last stroke comes at 2 s" render --strike time=2 --strike time=1 --duration 1.5
refused "the last stroke comes at 1 s" render --strike time=1 --duration 1

# ---- outputs that cannot be meant ----

refused "-o needs" render -o ''
refused ".wav, .flac or .au" render -o sound.mp3
refused ".wav, .flac or .au" render -o sound
refused ".wav, .flac or .au" render -o sound.wav.
refused "both would go to standard output" render -o - --json
refused "both would go to standard output" render -o /dev/stdout --json
refused "--trace '': allowed: the name of a file" render --trace ''
refused "--trace '-': allowed: the name of a file" render --trace -
for name in .wav .flac ./.au folder/.wav; do
  refused "-o '$name': the name must end in .wav, .flac or .au" render -o $name
done
refused "-o '.wav': the name must end in" render --split -o .wav
if [ -n "$(command -v script)" ]; then # it gives the program a terminal
  for name in - /dev/stdout; do
    script -qec "'$TABOR' render -o $name --duration 0.01" log <"/dev/null" >"$out" 2>"$err"
    status=$?
    same "status where sound would go to the terminal" 2 $status
    check "and why" grep -q 'standard output is a terminal' "$out"
    rm -f log
  done
else
  skip_part "sound for a terminal: needs bsdutils"
fi
refused "--gain and --normalize" render --gain 3 --normalize
refused "--normalize takes no value" render --normalize=-1
refused "--split and -o -" render --split -o -
refused "--split and -o -" render --split -o /dev/stdout
refused ".wav, .flac or .au" render --split -o take
refused ".wav, .flac or .au" render --split -o take.mp3
refused "--mic 'top': given twice" render --split --mic top --mic far --mic top
refused "--mic 'tpo'.*did you mean 'top'" render --split --mic tpo
refused "FLAC" render --split -o a.flac --format float
refused "FLAC" render -o a.flac --format float
refused "FLAC.*8 channels" render -o a.flac --mic top --mic top --mic top --mic top --mic top \
  --mic top --mic top --mic top --mic top
refused "FLAC.*multiples of 10" render -o a.flac --rate 100001
refused "both name" render -o a.wav --trace a.wav
refused "both name" render -o new.wav --trace ./new.wav
refused "both name" render --trace strike.wav
ln -s a.wav link.csv
refused "both name" render -o a.wav --trace link.csv
mkdir folder
ln -s folder other
refused "both name" render -o folder/new.wav --trace other/new.wav

# However long a path is, the reason is seen, in a line of bounded length.
long=$(printf 'long/%.0s' {1..1200})
failed "cannot write 'long/long.*\.\.\..*long/a.wav': File name too long$" render -o "${long}a.wav"
same "a line of bounded length" 1 "$(($(wc -c <"$err") < 1100))"
failed "cannot read '.*/a.csv': File name too long$" render --events "${long}a.csv"
failed "cannot read '.*/a.wav': File name too long$" analyze "${long}a.wav"
failed "long/a.ini: File name too long$" show "${long}a.ini"

# A name with a line feed in it still makes one line.
refused "unknown command" $'two\nlines'
refused "preset" render $'two\nlines'
refused "KEY=VALUE" render --set $'two\nlines'
refused "new" render -o $'new\nline.mp3'

# ---- what is right after all ----

run render tabor -o b.wav --duration 0.01 --strike time=0.0099 --rate 22050 -q
same "stroke just inside" 0 "$status"

finish
