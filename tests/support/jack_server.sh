# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced, after host_checks.sh or embed_checks.sh, by the tests that need a JACK server: a server without a sound card.
#
# All JACK servers and clients of a machine share files in /dev/shm, with places for eight servers. A server that is
# killed never gives its place back. Where the system permits it, such a test therefore runs in a mount namespace with a
# /dev/shm of its own.

needs jackd2 jackd jack_lsp
: "${STALLS:?host_stalls}"

# run_alone SCRIPT ARGUMENT...: runs the script again in a namespace of its own, if it is not there already and the
# system permits it. jack_is_alone then succeeds.
run_alone() {
  local isolate mount='mount -t tmpfs tmpfs /dev/shm'
  if [ -n "${TABOR_JACK_ALONE-}" ]; then return; fi
  for isolate in 'unshare --mount' 'unshare --user --map-root-user --mount'; do
    # shellcheck disable=SC2086 # words
    if $isolate sh -c "$mount" 2>/dev/null; then
      rm -rf "${private:-$scratch}"
      TABOR_JACK_ALONE=yes exec $isolate bash -c "$mount"' && exec bash "$@"' - "$@"
    fi
  done
}
jack_is_alone() { [ -n "${TABOR_JACK_ALONE-}" ]; }

run_alone "$0" "$@"

export JACK_DEFAULT_SERVER=tabor-test-$$ JACK_NO_START_SERVER=1 JACK_NO_AUDIO_RESERVATION=1
jack_period=1024
jack_files=${private:-$scratch}
jack=         # process of the server; empty if none is to run
jack_watcher= # process that measures whether the machine keeps time
exec {jack_report}>&1 # where skips are reported, though a command's output may go elsewhere

# JACK's clients can wait for ever for a server that has dropped them or that ends while they close, so none of its
# tools runs, and none of the processes is waited for, without a limit [s]. What they do here takes 2 s.
jack_patience=60
# shellcheck disable=SC2120 # as it can
jack_lsp() { timeout --kill-after=5 $jack_patience jack_lsp "$@"; }
jack_connect() { timeout --kill-after=5 $jack_patience jack_connect "$@"; }
jack_rec() { timeout --kill-after=5 $jack_patience jack_rec "$@"; }

# end_process PROCESS [SIGNAL]: sends the signal and waits for the end; kills what does not end. Its status.
end_process() {
  local i
  kill -"${2:-TERM}" "$1" 2>/dev/null || true
  for ((i = 0; i < 10 * jack_patience; i++)); do
    kill -0 "$1" 2>/dev/null || break
    sleep 0.1
  done
  kill -KILL "$1" 2>/dev/null || true
  wait "$1" 2>/dev/null
}

# Skips the test: a failure is none of Tabor's if JACK's own tools do not reach the server, if the machine stood
# still for as long as JACK waits for a client, half a second, or if JACK has dropped a client that was late, which the
# program says in its message.
excuse() {
  local stalled
  if [ -z "$jack_watcher" ]; then return; fi
  stalled=$(cat "$jack_files/jack_stalls")
  if [ -n "$jack" ] && ! jack_answers; then
    skip "the JACK server has failed: $(head -n 1 "$jack_files/jackd.log")" >&"$jack_report"
  fi
  if [ -n "$jack" ] && grep -qs "is gone: it asks for no more sound" "${err-}"; then
    skip "JACK has dropped the program, which the machine kept waiting" >&"$jack_report"
  fi
  if awk "BEGIN { exit !($stalled >= 0.5) }"; then
    skip "the machine stood still for $stalled s; JACK gives clients up after 0.5 s" >&"$jack_report"
  fi
}
jack_answers() { kill -0 "$jack" 2>/dev/null && jack_lsp >/dev/null 2>&1; }

# start_jack: starts the server; skips the test if that fails.
start_jack() {
  if [ -z "$jack_watcher" ]; then
    echo 0 >"$jack_files/jack_stalls"
    "$STALLS" "$jack_files/jack_stalls" &
    jack_watcher=$!
  fi
  jackd --no-realtime -n "$JACK_DEFAULT_SERVER" -d dummy -r 48000 -p $jack_period >"$jack_files/jackd.log" 2>&1 &
  jack=$!
  local i
  for ((i = 0; i < 300; i++)); do
    if jack_answers; then return; fi
    if ! kill -0 "$jack" 2>/dev/null; then break; fi
    sleep 0.2
  done
  skip "no JACK server can be started: $(head -n 1 "$jack_files/jackd.log")"
}

# stop_jack [SIGNAL]: the server ends. What a killed one leaves is removed if nobody else can use it.
stop_jack() {
  if [ -z "$jack" ]; then return; fi
  end_process "$jack" "${1:-TERM}" || true
  jack=
  if jack_is_alone && [ "${1-}" = KILL ]; then rm -rf /dev/shm/jack*; fi
}

# end_jack: for the script's end.
end_jack() {
  stop_jack
  if [ -n "$jack_watcher" ]; then kill "$jack_watcher" 2>/dev/null || true; fi
}
