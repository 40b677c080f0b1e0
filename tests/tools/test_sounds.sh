#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The clips that the README links to are there, short and small, and not clipped; tools/docs/make-sounds makes the same ones.
#
# test_sounds.sh SOURCE-FOLDER
source=$1
. "$(dirname "$0")/../support/host_checks.sh"
make=$source/tools/docs/make-sounds

mapfile -t clips < <(grep -oE '\(docs/sounds/[^)]+\)' "$source/README.md" | tr -d '()')
holds "the README links to clips" "${#clips[@]} >= 5"

# check_clip FILE
check_clip() {
  local container encoding rate channels frames
  read -r container encoding rate channels frames < <("$INSPECT" sound "$1")
  same "what $1 is" "flac pcm16 48000" "$container $encoding $rate"
  holds "$1: mono or stereo" "${channels:-0} == 1 || ${channels:-0} == 2"
  holds "$1: 1 to 3 s" "${frames:-0} >= 48000 && ${frames:-0} <= 144000"
  holds "$1: loud, and not clipped" "$("$INSPECT" peak "$1") > 0.5 && $("$INSPECT" peak "$1") < 0.99"
}
for clip in "${clips[@]}"; do check_clip "$source/$clip"; done
size() { cat "$1"/*.flac | wc -c; }
holds "all of them together" "$(size "$source/docs/sounds") < 1.5e6"
same "nothing else lies there" "$(printf '%s\n' "${clips[@]##*/}" | sort)" "$(ls "$source/docs/sounds")"

check "they can be made" "$make" -p "$TABOR" -o made
for clip in made/*; do check_clip "$clip"; done
same "the same ones" "$(ls "$source/docs/sounds")" "$(ls made)"
# The program's files are larger than the best that FLAC can do, for the sake of equal bytes (host/files/audio_file.c).
holds "made anew they are small, too" "$(size made) < 1.8e6"

"$make" -p ./none >"$out" 2>"$err"
same "without a program" "1 1" "$? $(wc -l <"$err")"
"$make" --wrong >"$out" 2>"$err"
same "a wrong option" 2 $?
"$make" -o >"$out" 2>"$err"
same "an option without its value" 2 $?
finish
