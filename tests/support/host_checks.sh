# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the scripts that test the program. $TABOR is the program and $INSPECT is host_inspect. Each script
# works in a folder of its own.

# shellcheck source=tests/support/skips.sh
. "$(dirname "${BASH_SOURCE[0]}")/skips.sh"

set -u
export LC_ALL=C
unset NO_COLOR
: "${TABOR:?the program}" "${INSPECT:?host_inspect}"

private=$(mktemp -d)
trap leave EXIT
work=$private/work out=$private/out err=$private/err
mkdir "$work"
cd "$work" || exit 1

# No sound card, and no plugin of ALSA's: what the machine has must not matter.
echo 'pcm.default { type hw card 99 }' >"$private/asound.conf"
export ALSA_CONFIG_PATH=$private/asound.conf
# Nor drums of the user's own.
export XDG_DATA_HOME=$private/data

checks=0 failures=0 finished=no

# leave [STATUS]: for the end, whose status is $? unless given; a script that has neither come to its finish nor skipped has failed, whatever its last command says.
leave() {
  local status=${1-$?}
  chmod -R u+w "$private"
  rm -rf "$private"
  if [ $status = 0 ] && [ $finished = no ]; then
    echo "FAILED: $(basename "$0") has no finish"
    exit 1
  fi
}

# complain WHAT: reports a failed check, unless there is an excuse.
complain() {
  excuse
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$1"
}

# check WHAT COMMAND...: the command must succeed.
check() {
  local what=$1
  shift
  checks=$((checks + 1))
  "$@" || complain "$what"
}

# same WHAT EXPECTED ACTUAL: both must be equal.
same() {
  checks=$((checks + 1))
  [ "$2" = "$3" ] || complain "$1: expected '$2', got '$3'"
}

# holds WHAT EXPRESSION: the expression, in awk's language, must be true.
holds() {
  checks=$((checks + 1))
  awk "BEGIN { exit !($2) }" || complain "$1: $2"
}

# snapshot: prints the files of the folder and checksums of their contents.
snapshot() {
  { find . -printf '%p %y %m %l\n'; find . -type f -exec cksum {} + 2>&1; } | sort
}

# run ARGUMENT...: runs the program; its output is in $out, its messages in $err.
run() {
  "$TABOR" "$@" >"$out" 2>"$err"
  status=$?
}

# expect_error STATUS PATTERN: the last run must have this status, one matching line on standard error, and nothing
# on standard output.
expect_error() {
  checks=$((checks + 1))
  if [ "$status" != "$1" ] || [ "$(wc -l <"$err")" != 1 ] || [ -s "$out" ] ||
    ! grep -qE "^tabor: .*$2" "$err"; then
    complain "expected status $1 and one line with '$2', got status $status and: $(cat "$err")"
  fi
}

# refused PATTERN ARGUMENT..., failed PATTERN ARGUMENT...: the program must end with status 2 or 1 respectively,
# with one matching line on standard error and nothing on standard output, and must not change the folder.
refused() { rejected 2 "$@"; }
failed() { rejected 1 "$@"; }
rejected() {
  local expected=$1 pattern=$2 before
  shift 2
  before=$(snapshot)
  run "$@"
  expect_error "$expected" "$pattern"
  same "folder after: $*" "$before" "$(snapshot)"
}

# done_quietly ARGUMENT...: the program must succeed and print nothing.
done_quietly() {
  run "$@"
  checks=$((checks + 1))
  if [ "$status" != 0 ] || [ -s "$err" ]; then
    complain "expected success of: $*; got status $status and: $(cat "$err")"
  fi
}

# render_strikes FILE STROKE...: renders these strokes silently, with the script's options in `short`.
render_strikes() {
  local file=$1 stroke words=()
  shift
  for stroke in "$@"; do words+=(--strike "$stroke"); done
  # shellcheck disable=SC2154 # it is the script's
  done_quietly render "${short[@]}" -o "$file" "${words[@]}"
}

# same_bytes WHAT FILE FILE, other_bytes WHAT FILE FILE: the files must be equal, or different.
same_bytes() { check "$1" cmp -s "$2" "$3"; }
other_bytes() { check "$1" eval "! cmp -s '$2' '$3'"; }

# mics_of DRUM: the number of its microphones.
mics_of() { "$TABOR" show "$1" | grep -c '^\[mic\.'; }

# interrupted SIGNAL STATUS BEGUN ARGUMENT...: sends the signal when the program has BEGUN temporary files. The
# program must end with this status and not change the folder.
interrupted() {
  local signal=$1 expected=$2 begun=$3 before child
  shift 3
  before=$(snapshot)
  "$TABOR" "$@" >"$out" 2>"$err" &
  child=$!
  check "files have been begun: $*" wait_for eval "[ \$(find . -name '.tabor-*' | wc -l) = $begun ]"
  kill -"$signal" $child
  wait $child
  same "status after SIG$signal" "$expected" $?
  same "folder after SIG$signal: $*" "$before" "$(snapshot)"
}

# json PATH: prints the value at this path in the output of the last run.
json() { "$INSPECT" json "$1" <"$out"; }

# wait_for COMMAND...: waits until the command succeeds, for `patience` seconds at most. Only a very busy machine
# needs a minute.
patience=60
wait_for() {
  local i
  for ((i = 0; i < 20 * patience; i++)); do
    "$@" && return
    sleep 0.05
  done
  return 1
}

# ---- time ----
# No check may fail because the machine is slow. A test waits for an effect of the program, not for a fixed time. If a
# test compares times, it measures the delays of the machine as well.

# Largest delay of a sleeping process on a calm machine [s].
# shellcheck disable=SC2034 # of the tests
CALM=0.002

# watch_machine: starts to measure by how much the machine delays a sleeping process.
watch_machine() {
  : "${STALLS:?host_stalls}"
  echo 0 >"$private/stalled"
  "$STALLS" "$private/stalled" &
  watcher=$!
}
# watched: ends the measurement; `stalled` is then the largest delay [s].
watched() {
  kill "$watcher"
  wait "$watcher"
  stalled=$(cat "$private/stalled")
}
# machine_kept_time SECONDS: true if the largest delay measured is below SECONDS.
machine_kept_time() { awk "BEGIN { exit !($stalled < $1) }"; }

# in_time SECONDS WHAT COMMAND...: a command that is late is tried again, up to four times, because the machine may be
# busy. If all tries are late, the check fails if the machine kept time in one of them, and is skipped otherwise. A
# failed check within the command is a failure at once.
in_time() {
  local limit=$1 what=$2 try excused=yes before=$failures
  shift 2
  checks=$((checks + 1))
  for try in 1 2 3 4 5; do
    watch_machine
    "$@" && { watched; return; }
    watched
    [ "$failures" = "$before" ] || return
    echo "$what: late at try $try; the machine made sleepers late by up to $stalled s"
    machine_kept_time "$limit" && excused=no
  done
  if [ $excused = yes ]; then
    skip_part "$what: the machine is too busy"
  else
    complain "$what: late, though the machine kept time"
  fi
}

# recorded_size: prints the size of the running recording in this folder [bytes].
recorded_size() { stat -c %s ./*.part.[aw]* 2>/dev/null; }
# recorded SECONDS BYTES: true if the recording has SECONDS of sound, with BYTES per frame at 48 kHz.
recorded() {
  local size
  size=$(recorded_size) || return 1
  awk "BEGIN { exit !($size >= $1 * 48000 * $2) }"
}
# catches PROCESS SIGNAL-NUMBER: true if the process has a handler for the signal, and is no longer the shell that
# was forked to start it, which has handlers of its own.
catches() {
  [ "$(readlink "/proc/$1/exe")" != "$(readlink /proc/$$/exe)" ] || return 1
  (((0x$(awk '/^SigCgt/ { print $2 }' "/proc/$1/status") >> ($2 - 1)) & 1))
}
# record_more SECONDS BYTES: waits until SECONDS more sound is recorded, with BYTES per frame.
record_more() {
  local size
  size=$(recorded_size)
  check "the recording goes on" wait_for recorded "$(awk "BEGIN { print $1 + ${size:-0} / 48000 / $2 }")" "$2"
}

# finish: prints the summary; must be the last line of every script.
finish() {
  finished=yes
  printf '%s: %d checks, %d failed\n' "$(basename "$0" .sh)" "$checks" "$failures"
  [ "$failures" = 0 ]
}
