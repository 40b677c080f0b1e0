#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# library --kit: a kit as one instrument of a sampler. Its sounds are those of `render --kit`, each on the notes that the
# kit has for it.
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"

cat >two.ini <<'END'
[kit]
overheads = -10
[drum.deep]
preset = frame-drum
quality.two_way_bandwidth = 1000
x = -0.4
head = 36, 35
buzz = 50
[drum.small]
preset = tabor
quality.two_way_bandwidth = 1000
x = 0.4
head = 38
rimshot = 40
END
short=(--quality draft --duration 0.6)
library() { done_quietly library --kit ./two.ini "${short[@]}" -q "$@"; }

library --velocities 2 --takes 1 -o one
expected=
for stroke in deep-buzz deep-head small-head small-rimshot; do
  expected+="two-$stroke-v001-t1.wav two-$stroke-v127-t1.wav "
done
same "a sound for each kind of stroke" "$expected" "$(find one -name '*.wav' -printf '%f\n' | LC_ALL=C sort | tr '\n' ' ')"

# song NOTE VELOCITY, in octal: the note, and its end after half a second.
song() {
  printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\15\0\231'"\\$1\\$2"'\203\140\211'"\\$1"'\0\0\377\57\0' >song.mid
}
while read -r note velocity sound; do
  song "$note" "$velocity"
  done_quietly render --kit ./two.ini --midi-file song.mid "${short[@]}" -q -o note.wav
  same_bytes "$sound is what its note plays" note.wav "one/two-$sound-t1.wav"
done <<'END'
43 177 deep-head-v127
44 1 deep-head-v001
62 177 deep-buzz-v127
46 177 small-head-v127
50 177 small-rimshot-v127
END

# groups: key, velocities and sounds of each.
groups() {
  awk -F= '/^<group>/ { if (line) print line; line = "" } /^(key|lovel|hivel|sample)=/ { line = line $2 " " }
    END { print line }' "$1"
}
cat >expected <<'END'
35 1 64 two-deep-head-v001-t1.wav 
36 1 64 two-deep-head-v001-t1.wav 
35 65 127 two-deep-head-v127-t1.wav 
36 65 127 two-deep-head-v127-t1.wav 
50 1 64 two-deep-buzz-v001-t1.wav 
50 65 127 two-deep-buzz-v127-t1.wav 
38 1 64 two-small-head-v001-t1.wav 
38 65 127 two-small-head-v127-t1.wav 
40 1 64 two-small-rimshot-v001-t1.wav 
40 65 127 two-small-rimshot-v127-t1.wav 
END
check "every note has its sounds" diff expected <(groups one/two.sfz)

library --velocities 2 --takes 1 -o jobs --jobs 1
check "one at a time, the same" diff -r one jobs
library --velocities 1 --takes 2 -o takes
other_bytes "takes differ" takes/two-small-head-v064-t1.wav takes/two-small-head-v064-t2.wav
cp -r takes before
rm takes/two-deep-head-v064-t2.wav
run library --kit ./two.ini "${short[@]}" --velocities 1 --takes 2 -o takes --json
same "one is rendered again" "two.ini 1 7 0 8" \
  "$(basename "$(json kit)") $(json rendered) $(json kept) $(json failed) $(json sounds.size)"
check "it is the same" diff -r before takes
same "facts of a sound" "small rimshot 40 1 127" \
  "$(json sounds.7.drum) $(json sounds.7.technique) $(json sounds.7.key) $(json sounds.7.low) $(json sounds.7.high)"
check "all its keys" grep -qzE '"keys": \[[[:space:]]*35,[[:space:]]*36[[:space:]]*\]' "$out"
run library --kit ./two.ini "${short[@]}" --velocities 1 --takes 1 -o loud -v --gain 80
check "a warning that names the sound" grep -q '^tabor: warning: loud/two-.*saturates' "$err"

refused "holds another library, with deep.x -0.4, not -0.3" \
  library --kit ./two.ini "${short[@]}" --velocities 1 --takes 2 -o takes --set drum.deep.x=-0.3
refused "holds another library, with small.note.40 .rimshot., not .rim." \
  library --kit ./two.ini "${short[@]}" --velocities 1 --takes 2 -o takes --set drum.small.rimshot= --set drum.small.rim=40
refused "--kit and --positions" library --kit standard --positions 3 -o none
refused "--kit and 'tom-12'" library tom-12 --kit standard -o none
refused "unknown kit 'standart'.*did you mean 'standard'" library --kit standart -o none
refused "make 52832 sounds of 13 kinds of stroke; allowed: up to 4096" \
  library --kit standard --velocities 127 --takes 32 -o none
check "nothing was made for what was refused" test ! -e none

finish
