#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every allocation of a command fails once, or some hundred of them evenly spread: the command then says so in one line
# and ends with status 1, and leaves no file half written; or it did without and writes what it always writes. FFTW
# ends the process where it finds no memory; nobody else may.
#
# test_system_memory.sh FAILING-MEMORY.SO [TRIES]; TABOR is the program.
set -euo pipefail
library=$1 tries=${2-25}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failures=0 excused=0

# A drum that is computed at once.
"$TABOR" show tom-12 >drum.ini
small=(./drum.ini --quality draft --set quality.two_way_bandwidth=300 --set quality.bandwidth=600)
"$TABOR" render "${small[@]}" -q --duration 1 -o sound.wav
"$TABOR" play "${small[@]}" -q --backend file --duration 0.05 --record take.wav --log take.log

# with_failure NUMBER COMMAND...: runs it in an empty folder, with what it prints in out and err.
with_failure() {
  local number=$1
  shift
  rm -rf out err made count
  mkdir made
  TABOR_FAIL_AT=$number TABOR_COUNT_IN=$work/count LD_PRELOAD=$library "$TABOR" "$@" >out 2>err
}

# What a command made: names and contents of its files, and its output.
result() {
  (cd made && find . -type f | sort | while IFS= read -r file; do echo "$file $(sha256sum <"$file")"; done)
  sha256sum <out
}

wrong() {
  echo "FAILED: tabor $1, allocation $2: $3"
  head -n 3 err
  failures=$((failures + 1))
}

# An unfinished file would be one that the complete run does not have, or another one. Only a library's checksums grow with
# its sounds, so they are none before the first sound.
check_files() {
  local file none
  none="./samples/tabor-library.sums $(sha256sum </dev/null)"
  while IFS= read -r file; do
    if [ "$file" = "$none" ]; then continue; fi
    [ -z "$file" ] || grep -qxF "$file" good-files || wrong "$1" "$2" "it left ${file%% *}"
  done < <(result | sed '$d')
}

try_command() {
  local number count status step
  with_failure 0 "$@" || { wrong "$*" none "status $?"; return; }
  result >good
  sed '$d' good >good-files
  count=$(cat count)
  step=$((count / tries + 1))
  for ((number = 1; number <= count; number += step)); do
    status=0
    with_failure "$number" "$@" 2>/dev/null || status=$?
    if grep -q '^fftw: .*assertion failed' err; then excused=$((excused + 1)); continue; fi
    if [ "$status" = 0 ]; then
      result | cmp -s - good || wrong "$*" "$number of $count" "status 0, but another result"
    else
      [ "$status" = 1 ] || wrong "$*" "$number of $count" "status $status"
      [ "$(grep -c '^tabor: ' err)" = 1 ] || wrong "$*" "$number of $count" "not one line of reason"
      if grep -qF '%' err; then wrong "$*" "$number of $count" "a format is printed"; fi
      check_files "$*" "$number of $count"
    fi
  done
  echo "tabor $1: $count allocations, tried every ${step}th"
}

try_command modes "${small[@]}" --json
try_command show ./drum.ini --json
try_command presets --json
try_command analyze sound.wav --json
try_command render "${small[@]}" -q --json --duration 0.05 -o made/sound.wav
try_command render -q --replay take.log -o made/sound.wav
try_command library "${small[@]}" -q --json --velocities 1 --takes 1 --positions 1 --duration 0.05 -o made/samples
if [ "$excused" -gt 0 ]; then echo "$excused allocations of FFTW failed, which ends the process by itself"; fi
exit $((failures > 0))
