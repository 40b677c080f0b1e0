# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced: count_instructions PROGRAM prints "PRESET INSTRUCTIONS" for each preset whose cost is watched. PROGRAM is
# instruction_counts.

watched_presets="snare-14x5.5 bodhran-d-string tom-12 bass-drum-22"

count_instructions() {
  local program preset folder
  program=$(realpath "$1")
  folder=$(mktemp -d)
  for preset in $watched_presets; do
    valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file="$folder/$preset" \
      "$program" "$preset" 2>"$folder/log" || { cat "$folder/log" >&2; rm -rf "$folder"; return 1; }
    echo "$preset $(sed -n 's/^totals: //p' "$folder/$preset.1")"
  done
  rm -rf "$folder"
}
