#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/compare-recordings: its measures of known sounds and of recorded clips; presets pass its gate, and a drum that
# is spoilt does not; what it writes.
#
# test_compare_recordings.sh SOURCE-FOLDER

# shellcheck source=tests/support/find_python.sh
. "$(dirname "$0")/../support/find_python.sh"
tests=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
tools=$1/tools
export PYTHONDONTWRITEBYTECODE=1

python=$(find_python numpy,scipy,matplotlib,soundfile) ||
  skip "needs python3 python3-numpy python3-scipy python3-matplotlib python3-soundfile"

check "measures" "$python" "$tests/tools/recordings_checks.py" "$tools"

# A program that renders each stroke once, however often it is asked for. Its words are `render PRESET -o FILE ...`.
mkdir strokes
cat >program <<END
#!/bin/sh
preset=\$2 file=\$4
shift 4
kept=$work/strokes/\$(echo "\$preset \$*" | tr ' ' _)
if [ ! -e "\$kept" ]; then
  "$TABOR" render "\$preset" -o "\$kept-\$\$.wav" "\$@" || exit
  mv "\$kept-\$\$.wav" "\$kept"
fi
cp "\$kept" "\$file"
END
chmod +x program

# compare ARGUMENT...
compare() {
  "$python" "$tools/compare-recordings" --program ./program "$@" >"$out" 2>"$err"
  status=$?
}

compare --check
same "the presets pass: $(cat "$out" "$err")" 0 "$status"

# Figures at studio that were measured with another sound do not count.
mkdir -p stale/recordings
sed 's/"studio": "[0-9a-f]*"/"studio": "0"/' "$1/docs/recordings/figures.json" >stale/recordings/figures.json
compare --check --docs stale
same "stale figures at studio" "1 1" "$status $(wc -l <"$err")"
check "says how to renew them" grep -q ' no figures .* at studio: run tools/compare-recordings --quality live --quality studio$' "$err"

# A program whose snare drums have lost their snares and their room.
cat >spoilt <<END
#!/bin/sh
[ "\$2" = snare-14x5.5 ] || exec "$work/program" "\$@"
exec "$work/program" "\$@" --set wires.strainer=0 --set room.kind=none
END
chmod +x spoilt
compare --check --program ./spoilt
same "a snare drum without snares" 1 "$status"
check "says so" grep -q '^snare-14x5.5, snare/bottom: [0-9]* of 60 features of spectrum inside, 42 asked$' "$out"
check "its overhead in free air" grep -qE '^snare-14x5.5, snare/oh: [0-9]+ of 23 features of decay in the plain range, 15 asked; [0-9]+ in the widened range, 21 asked' "$out"
check "and what it is taken for" grep -qE '^snare-14x5.5: nearest to (tom|floortom)/top, not to snare/top$' "$out"
check "the verdict" grep -q '^compare-recordings: the gate fails; ' "$out"
check "nothing else is called known" grep -qE '^strict: snare-14x5.5, snare/top, live, [a-z]+: [^;]*;[^;]*; outside the plain range: [^;]*$' "$out"
same "the others pass" 0 "$(grep -vcE '^(snare-14x5.5[,:]|strict: |compare-recordings: )' "$out")"
check "says what the strict gate misses" grep -qE '^strict: snare-14x5.5, snare/bottom, live, spectrum: [0-9]+ of 60 in the plain range, 36 asked; [0-9]+ in the widened range, 57 asked; outside the plain range: to_e50_' "$out"
# The rest is shown with any sounds: a tom stands for the snare drums, whose strokes cost several times as much.
cat >quick <<END
#!/bin/sh
case \$2 in
snare-* | piccolo-* | marching-*) shift 2; exec "$work/program" render tom-12 "\$@" ;;
esac
exec "$work/program" "\$@"
END
chmod +x quick
compare --check --strict --quality draft --program ./quick
same "the strict gate of toms for snare drums" 1 "$status"

mkdir docs
compare --docs docs --quality draft --program ./quick --before ./quick
same "writes its page" 0 "$status"
for part in recordings.md recordings/figures.json recordings/snare-14x5.5-bottom.png; do
  check "$part" test -s "docs/$part"
done
check "the strict gate in a table" grep -qE '^\| `tom-12` \| tom/top \| draft \| \**[0-9]+/42, [0-9]+/57' docs/recordings.md
check "dynamics of recordings and presets" test 2 = "$(grep -cE '^\| (10x6-ash|tom-12) \| (snare|tom)/top \| [67] \| [0-9]+ \| [-+]' docs/recordings.md)"
check "before and now in one table" grep -qE '^\| `snare-14x5.5` \| snare/top \| 12 \| [0-9]+/60, \*\*[0-9]+/60\*\* ' docs/recordings.md
same "no place of the template is left open" 0 "$(grep -c '[$]' docs/recordings.md)"
mv docs/recordings.md written.md
compare --docs docs --kept
check "writes it again from what it keeps" cmp written.md docs/recordings.md
compare --docs none --kept
same "without figures" "1 1" "$status $(wc -l <"$err")"

compare --program ./none --check
same "without a program" "1 1" "$status $(wc -l <"$err")"
compare --clips ./none --docs docs
same "without clips" "1 1" "$status $(wc -l <"$err")"
compare --velocity fast
same "a wrong option" "2 1" "$status $(wc -l <"$err")"
finish
