#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render --humanize and --seed: strokes that differ, reproducibly.

. "$(dirname "$0")/../support/host_checks.sh"

# sound NAME ARGUMENT...: four equal strokes.
sound() {
  local name=$1
  shift
  done_quietly render tabor -q --quality draft --duration 0.4 --format float -o "$name" \
    --strike time=0,radius=0.1 --strike time=0.1,radius=0.1 --strike time=0.2,radius=0.1 \
    --strike time=0.3,radius=0.1 "$@"
}

sound plain.wav
sound zero.wav --humanize 0
sound zero-seed.wav --humanize 0 --seed 7
check "--humanize 0 changes no byte" cmp plain.wav zero.wav
check "--humanize 0 changes no byte, whatever the seed" cmp plain.wav zero-seed.wav
sound seed.wav --seed 7
check "without --humanize render scatters nothing" cmp plain.wav seed.wav

sound one.wav --humanize 0.3
sound again.wav --humanize 0.3 --seed 1
sound two.wav --humanize 0.3 --seed 2
sound more.wav --humanize 1 --seed 1
check "the default seed is 1" cmp one.wav again.wav
other_bytes "--humanize changes the sound" plain.wav one.wav
other_bytes "another seed, another sound" one.wav two.wav
other_bytes "another amount, another sound" one.wav more.wav

printf 'time,radius\n0.3,0.1\n0.1,0.1\n0,0.1\n0.2,0.1\n' >strokes.csv
done_quietly render tabor -q --quality draft --duration 0.4 --format float -o file.wav \
  --events strokes.csv --humanize 0.3
check "whatever the order in which the strokes are given" cmp one.wav file.wav

refused "--humanize '1.1': out of range; allowed: 0 to 1" render --humanize 1.1
refused "--humanize '-0.1'" render --humanize -0.1
refused "--humanize 'nan': not a number" render --humanize nan
refused "--humanize needs a value" render --humanize
refused "--seed '1.5': not a whole number" render --humanize 1 --seed 1.5
refused "--seed '4294967296': out of range; allowed: 0 to 4294967295" render --seed 4294967296

finish
