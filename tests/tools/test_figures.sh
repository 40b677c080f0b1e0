#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figures in the pages are those of the program: each line names a page and what it says, and the command that says it again.
#
# test_figures.sh SOURCE-FOLDER
tests=$(cd "$(dirname "$0")/.." && pwd)
source=$1
. "$tests/support/host_checks.sh"

# number_in FILE PATTERN: the number that the pattern's only group finds first.
number_in() { sed -nE "s/.*$2.*/\\1/p" "$1" | head -n 1; }

# agrees WHAT SAID NUMBER TOLERANCE
agrees() {
  if [ -z "$2" ] || [ -z "$3" ]; then complain "$1: '$2', and the program says '$3'"; return; fi
  holds "$1" "sqrt(($2 - $3) ^ 2) <= $4"
}

# figure PAGE PATTERN TOLERANCE OUTPUT-PATTERN ARGUMENT...: what the page says is what the program says, in output or messages.
figure() {
  local page=$1 pattern=$2 tolerance=$3 output=$4
  shift 4
  run "$@"
  cat "$err" >>"$out"
  agrees "$page: '$pattern' and tabor $*" "$(number_in "$source/$page" "$pattern")" "$(number_in "$out" "$output")" "$tolerance"
}

stroke=(--quality live --duration 0.3 -o stroke.wav)
figure docs/playing.md 'held: batter ([0-9.]+) Hz' 0.005 'held: batter ([0-9.]+) Hz' modes tom-12
figure docs/playing.md "14 inch snare's batter head reaches ([0-9]+) Hz" 0.6 'to ([0-9.]+) Hz, the pitches' render snare-14x5.5 --set batter.pitch=900 -o no.wav
figure NEWS.md 'peak at (-[0-9.]+) \(`bass-drum-18`\)' 0.05 'peak (-[0-9.]+) dBFS' render bass-drum-18 "${stroke[@]}"
figure NEWS.md 'and (-[0-9.]+) dBFS \(`bass-drum-22`\)' 0.05 'peak (-[0-9.]+) dBFS' render bass-drum-22 "${stroke[@]}"
figure NEWS.md 'peaks between (-[0-9.]+) and -8 dBFS' 0.1 'peak (-[0-9.]+) dBFS' render tom-12 "${stroke[@]}"

# A room's thousand instructions a sample, of those that half a second of the snare drum takes.
share=$(awk '$1 == "snare-14x5.5" { print 100 * 1000 * 24000 / $2 }' "$tests/reference/instruction_counts.txt")
agrees "docs/presets.md: the share of a room" "$(number_in "$source/docs/presets.md" 'instructions a sample, ([0-9.]+) %')" "$share" 0.06

finish
