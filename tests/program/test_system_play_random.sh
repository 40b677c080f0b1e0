#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# play against a clock for a while, at random, in blocks of 256: memory stays constant, nothing is lost, and
# nothing goes wrong. The processor time of blocks is test_player's matter.
#
# test_system_play_random.sh SECONDS [PRESET]

. "$(dirname "$0")/../support/host_checks.sh"
seconds=${1:-20} preset=${2:-tabor}
seed=7
export JACK_NO_START_SERVER=1 JACK_DEFAULT_SERVER=tabor-test-none-$$

echo "$seconds s of $preset, seed $seed"
awk -v seed=$seed -v seconds="$seconds" 'BEGIN {
  srand(seed)
  print "time,velocity,radius,angle"
  for (t = 0.1; t < seconds - 0.5; t += 0.02 + 0.3 * rand()) {
    printf "%.6f,%.4f,%.2f%%,%.1f\n", t, 0.3 * exp(3.7 * rand()), 100 * rand(), 360 * rand()
  }
}' >random.csv
strokes=$(($(wc -l <random.csv) - 1))

memory() { awk '/^VmRSS:/ { print $2 }' "/proc/$1/status"; } # [KiB]

watch_machine
"$TABOR" play "$preset" --backend null --buffer 256 --events random.csv --duration "$seconds" \
  --record random.wav --format float --no-ui --json </dev/null >"$out" 2>"$err" &
player=$!
check "the performance begins" wait_for grep -q "frames at once" "$err"
check "three seconds are played" wait_for recorded 3 4
early=$(memory $player)
while now=$(memory $player) && [ -n "$now" ]; do
  late=$now
  sleep 0.2
done 2>/dev/null
wait $player
same "status" 0 $?
watched
holds "memory stays: $early, then $late KiB" "$late - $early < 2048"
same "frames" $((seconds * 48000)) "$(json frames)"
same "recovered" 0 "$(json recovered)"
# The player is told of strokes a second ahead, and keeps seconds of the recording.
if machine_kept_time 0.5; then
  same "strokes" "$strokes" "$(json strokes)"
  same "dropped" 0 "$(json dropped)"
  same "lost frames" 0 "$(json recording.lost_frames)"
else
  skip_part "whether strokes or frames are lost: the machine stood still for $stalled s"
fi
peak=$("$INSPECT" peak random.wav)
holds "it is heard, and finite: $peak" "$peak > 0.01 && $peak <= 1"
echo "load: median $(json load.median), worst $(json load.worst); gaps: $(json xruns)"

finish
