#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: test_system_event_costs.sh EVENT-COSTS QUALITY
# A block of 64 frames with a thousand events of any mix of kinds takes at most 8 times the instructions of a block
# with one stroke, on the drum whose events cost the most: the bass drum. Callgrind counts them.
set -euo pipefail

program=$(realpath "$1")
quality=$2
most=8
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=tests/support/skips.sh
. "$here/../support/skips.sh"
command -v valgrind >/dev/null || skip "needs valgrind"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

seed=${SEED:-$RANDOM}
echo "seed $seed"
# One stroke, then floods: of one kind, of two in turns, of all by chance.
mixes=(1s 1000s 1000d 1000hs 1000hd 1000Rt 1000tu 100X 200Xs 1000?)
valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file=counts \
  "$program" bass-drum-22 "$quality" "$seed" "${mixes[@]}" >dropped.txt 2>valgrind.txt ||
  { cat valgrind.txt; exit 1; }

status=0 stroke=0
for ((i = 0; i < ${#mixes[@]}; i++)); do
  count=$(sed -n 's/^totals: //p' "counts.$((i + 1))")
  if [ "$i" -eq 0 ]; then stroke=$count; fi
  line=$(sed -n "$((i + 1))p" dropped.txt)
  awk -v line="$line" -v count="$count" -v stroke="$stroke" -v most="$most" 'BEGIN {
    printf "%s, %.1f million instructions, %.2f times one stroke\n", line, count / 1e6, count / stroke
    exit !(count > 0 && count <= most * stroke)
  }' || { echo "FAILED: more than $most times one stroke" ; status=1; }
done
exit $status
