# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced: count_instructions PROGRAM prints "PRESET INSTRUCTIONS BYTES" for each preset whose cost is watched. PROGRAM is
# instruction_counts. BYTES are those that a first cache of 32 KiB lacks, and has from the second one: lines of 64.

watched_presets="snare-14x5.5 bodhran-d-string tom-12 bass-drum-22"

count_instructions() {
  local program preset folder
  program=$(realpath "$1")
  folder=$(mktemp -d)
  for preset in $watched_presets; do
    valgrind --tool=callgrind --instr-atstart=no --cache-sim=yes --I1=32768,8,64 --D1=32768,8,64 --LL=1048576,16,64 \
      --callgrind-out-file="$folder/$preset" \
      "$program" "$preset" 2>"$folder/log" || { cat "$folder/log" >&2; rm -rf "$folder"; return 1; }
    # Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw
    echo "$preset $(awk '/^totals:/ { printf "%.0f %.0f", $2, 64 * ($6 + $7) }' "$folder/$preset.1")"
  done
  rm -rf "$folder"
}
