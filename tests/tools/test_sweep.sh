#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# examples/python/sweep.py over Dask: the bytes of the program, whatever happens to the workers.

source=$(cd "$(dirname "$0")/../.." && pwd)
. "$source/tests/support/host_checks.sh"
. "$source/tests/support/find_python.sh"

python=$(find_python dask,distributed) || skip "needs python3 python3-distributed"

# What the workers call: the program, which notes what it renders, and fails or is held for good if it is told to.
cat >program <<END
#!/bin/sh
if [ "\$1" = render ]; then
  echo "\$\$" >>"$work/calls"
  if [ -e "$work/hold" ] && [ "\$(wc -l <"$work/calls")" -gt 3 ]; then
    touch "$work/held"
    while [ -e "$work/hold" ]; do sleep 0.05; done
    exit 1
  fi
  if mkdir "$work/unlucky" 2>/dev/null; then echo "tabor: out of luck" >&2; exit 1; fi
fi
exec "$TABOR" "\$@"
END
chmod +x program
mkdir unlucky # luck, for now

study=(tabor --vary batter.tension=2000:4000:3 --vary "velocity=1,4" --takes 2 --quality draft --duration 0.3
  --program ./program)
sweep() { timeout --kill-after=10 120 "$python" "$source/examples/python/sweep.py" "$@" >"$out" 2>"$err"; }
calls() { wc -l <calls; }

# ends WHAT PROCESS: waits for a process of this script; its status. One that does not end says where it was, and fails.
ends() {
  if ! wait_for eval "! kill -0 $2 2>/dev/null"; then
    complain "$1 does not end"
    kill -ABRT "$2" # Python prints where its threads are
    cat "$err" log 2>/dev/null
  fi
  wait "$2"
}
export PYTHONFAULTHANDLER=1

# ---- one worker, and two: their times, for information ----

touch calls
for workers in 1 2; do
  check "$workers workers" sweep "${study[@]}" -o with-$workers --workers $workers
  grep ' jobs in ' "$err"
done
same "no job is done twice" 24 "$(calls)"
check "the same bytes from two workers" diff -r with-1 with-2
same "the files" "12 1" "$(find with-1 -name '*.wav' | wc -l) $(find with-1 ! -name '*.wav' -type f | wc -l)"

# as the program's own
row=$(grep ',4000,4,2$' with-1/index.csv)
done_quietly render tabor -q --quality draft --duration 0.3 --set batter.tension=4000 --strike velocity=4 \
  --humanize 0.3 --seed 2 -o own.wav
check "the sound of a row" cmp own.wav "with-1/${row%%,*}"
check "nothing is left to do" sweep "${study[@]}" -o with-1
same "so nothing is done" 24 "$(calls)"

# ---- what fails is tried again ----

rmdir unlucky
rm calls
check "a job that failed once" sweep "${study[@]}" -o again --workers 1
same "is done again" 13 "$(calls)"
check "with the same bytes" diff -r with-1 again

# ---- a worker that is killed, in a cluster of its own processes ----

export DASK_TEMPORARY_DIRECTORY=$work/dask
"$python" -m distributed.cli.dask_scheduler --host 127.0.0.1 --port 0 --no-dashboard --no-show \
  --scheduler-file "$work/cluster" >log 2>&1 &
scheduler=$!
worker() {
  exec "$python" -m distributed.cli.dask_worker --scheduler-file "$work/cluster" --host 127.0.0.1 --no-nanny \
    --nthreads 1 --no-dashboard >>log 2>&1
}
check "the scheduler is there" wait_for test -s cluster
worker &
victim=$!
rm calls
touch hold # its fourth job does not end: it is at work when it dies
"$python" "$source/examples/python/sweep.py" "${study[@]}" -o killed --scheduler \
  "$("$python" -c 'import json; print(json.load(open("cluster"))["address"])')" >"$out" 2>"$err" &
child=$!
check "it is at its fourth job" wait_for test -e held
kill -KILL $victim
wait $victim
rm hold
worker &
survivor=$!
ends "a sweep that lost a worker" $child
same "status of the sweep" 0 $?
same "the sounds have the same bytes, and none is missing" "" "$(diff -r with-1 killed)"
holds "the jobs of the killed worker are done again" "$(calls) > 12"
kill $survivor # first: a worker whose scheduler ends while it does sometimes never ends
ends "the worker" $survivor
kill $scheduler
ends "the scheduler" $scheduler

# ---- a sweep that is terminated, with its workers at work ----

rm -f calls held
touch hold
mkdir temporary
env -u DASK_TEMPORARY_DIRECTORY TMPDIR="$work/temporary" \
  "$python" "$source/examples/python/sweep.py" "${study[@]}" -o ended --workers 2 >"$out" 2>"$err" &
child=$!
check "it is at its fourth job" wait_for test -e held
kill -TERM $child
ends "a terminated sweep" $child
same "status of a terminated sweep" 143 $?
rm hold
same "its workers leave nothing behind" "" "$(ls temporary)"

# ---- wrong requests ----

says() {
  local pattern=$1
  shift
  sweep "${study[@]}" "$@"
  same "status: $*" 2 $?
  check "$pattern: $*" grep -q "$pattern" "$err"
}
says "'batter.tensoin'.*did you mean 'batter.tension'" -o wrong --vary batter.tensoin=1,2 --workers 1
says "allowed: KEY=VALUES" -o wrong --vary tension=1
says "a key is given twice" -o wrong --vary velocity=2
says "takes 0: allowed: 1 or more" -o wrong --takes 0
same "nothing is written" 0 "$(find wrong -type f 2>/dev/null | wc -l)"
same "nothing half-written anywhere" '' "$(find . -name '.tabor-*')"
finish
