#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Each fuzz target reaches, by its corpus alone, a stated share of the edges of what it is meant for, and sees the
# engine: a target that links a library without counters would try inputs blindly, and without sanitizers.
#
# test_fuzz_reach.sh SOURCE CMAKE BUILD [CLAP-HEADERS]: builds preset fuzz in the folder BUILD, which may stay.
set -eu
source=$1 cmake=$2 build=$3 clap=${4:-}
# shellcheck source=tests/support/find_clang.sh
. "$source/tests/support/find_clang.sh"
# shellcheck source=tests/support/skips.sh
. "$source/tests/support/skips.sh"
compiler=$(find_clang) || skip "needs clang-22"
needs binutils addr2line

# Target, per cent, sources. Edges that only a sanitizer's complaint takes count too, so that 40 % is nearly all of a
# function. The shares are some three quarters of what the corpora reached when this was written.
shares="
api         15  engine/src/drum/ engine/src/step/ engine/src/strikers/
api         20  engine/src/state/
clap        10  host/clap/
clap        16  host/plugin/
clap        18  engine/src/model/
clap        20  engine/src/room/
definition  26  engine/src/definition/
definition  25  host/drums/definition_text.c
events_file 30  host/strokes/events_file.c
keymap      30  host/ui/keymap.c
kit         9   host/drums/definition_text.c
kit         28  engine/src/kit/
kit         21  engine/src/definition/
log         17  host/render/log_line.c
log         17  engine/src/definition/
manifest    17  host/library/library_manifest.c
midi_file   28  host/midi/midi_file.c
midi_map    25  host/midi/midi_map_file.c
preset      20  engine/src/definition/
replay      28  host/render/replay.c
replay      19  engine/src/definition/
room_state  15  engine/src/room/
sound_file  25  host/inspect/
state       8   engine/src/step/
"

failures=0
fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

mkdir -p "$build"
"$cmake" -S "$source" --preset fuzz -B "$build" -DCMAKE_C_COMPILER="$compiler" \
  ${clap:+-DTABOR_CLAP_INCLUDE_DIR="$clap"} >"$build/log" 2>&1 &&
  "$cmake" --build "$build" --parallel 2 --target fuzz-targets >>"$build/log" 2>&1 || {
  tail -20 "$build/log"
  echo "FAILED: building the fuzz targets"
  exit 1
}

# reached FOLDER-OR-FILE...: edges reached and edges there are, of functions of these sources, by the coverage in stdin.
reached() {
  awk -v places="$*" '
    BEGIN { count = split(places, place, " ") }
    /COVERED_FUNC/ {
      split($5, edges, "/")
      for (i = 1; i <= count; i++) {
        if (index($NF, "/" place[i])) { reached += edges[1]; all += edges[2] }
      }
    }
    END { print reached + 0, all + 0 }'
}

for file in "$source"/tests/fuzz/fuzz_?*.c; do
  target=$(basename "$file" .c)
  name=${target#fuzz_}
  if [ ! -x "$build/tests/$target" ]; then
    skip_part "$target: there are no CLAP headers (tools/setup --plugins brings them)"
    continue
  fi
  coverage=$build/$target.coverage
  ASAN_OPTIONS=external_symbolizer_path=$(command -v addr2line) "$build/tests/$target" -runs=0 -print_coverage=1 \
    -seed_inputs=@"$build/tests/$target.seeds" >"$coverage" 2>&1 || {
    tail -20 "$coverage"
    fail "$target: its corpus breaks something"
    continue
  }
  read -r _ all < <(reached engine/src/ <"$coverage")
  if [ "$all" = 0 ]; then fail "$target sees no edge of the engine"; fi
  rows=0
  while read -r row least places; do
    if [ "$row" != "$name" ]; then continue; fi
    rows=$((rows + 1))
    # shellcheck disable=SC2086 # words
    read -r edges all < <(reached $places <"$coverage")
    echo "$target: $edges of $all edges of $places, at least $least %"
    if [ $((100 * edges)) -lt $((least * all)) ] || [ "$edges" = 0 ]; then fail "$target reaches too little of $places"; fi
  done <<<"$shares"
  if [ $rows = 0 ]; then fail "$target: no share is stated above"; fi
done

[ $failures = 0 ]
