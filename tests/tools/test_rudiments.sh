#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/rudiments: a rudiment and a file of strokes become sounds with pictures, and what cannot be played is said.
#
# test_rudiments.sh SOURCE-FOLDER

# shellcheck source=tests/support/find_python.sh
. "$(dirname "$0")/../support/find_python.sh"
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
tool=$1/tools/rudiments

python=$(find_python numpy,scipy,matplotlib,PIL) ||
  skip "needs python3 python3-numpy python3-scipy python3-matplotlib python3-pil"
export PYTHONDONTWRITEBYTECODE=1
play() { "$python" "$tool" --program "$TABOR" --quality draft --humanize 0 "$@" >"$out" 2>"$err"; }

is_picture() { [ "$(head -c 4 "$1" | tail -c 3)" = PNG ]; }

check "a rudiment" play -o made -r flams
same "what it says" made/flams.wav "$(cat "$out")"
check "its picture" is_picture made/flams.png
check "its strokes are what was played" "$TABOR" render snare-14x5.5 -q --quality draft --humanize 0 --normalize \
  --events made/flams.csv -o again.wav
same_bytes "a rudiment" made/flams.wav again.wav

printf 'time,striker,technique,hold\n0,brush,sweep,0.1\n' >sweep.csv
check "a file" play -o own sweep.csv
check "the picture of a file" is_picture own/sweep.png

play -o none -r flams --preset nobody
same "a preset that there is not" 2 $?
play -o none -r foo
same "a rudiment that there is not" 2 $?
same "in one line" 1 "$(wc -l <"$err")"
check "which says what there is" \
  grep -qE "^rudiments: .*'foo'.*single-stroke-roll.*flams.*press-roll.*brush-pattern" "$err"
play -o none nobody.csv
same "a file that there is not" "2 rudiments: nobody.csv: no such file" "$? $(cat "$err")"
finish
