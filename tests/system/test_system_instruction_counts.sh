#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: test_system_instruction_counts.sh INSTRUCTION-COUNTS FILE COMPILER
# Half a second of a stroke takes as many instructions as FILE says, within 1 %: a drum that costs more, or less, does so
# on purpose. Other compilers make other code: the file names the one that it is for.
set -euo pipefail
program=$1 file=$2 compiler=$3
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=tests/support/skips.sh
. "$here/../support/skips.sh"
# shellcheck source=tests/support/count_instructions.sh
. "$here/../support/count_instructions.sh"
command -v valgrind >/dev/null || skip "needs valgrind"
grep -qw avx2 /proc/cpuinfo 2>/dev/null || skip "the processor lacks AVX2"
[ -e "$file" ] || skip "there is no ${file##*/} yet: tools/renew-instruction-counts writes it"
[ "$(sed -n 's/^compiler //p' "$file")" = "$compiler" ] || skip "the counts are those of another compiler than $compiler"

status=0
while read -r preset count; do
  expected=$(sed -n "s/^$preset //p" "$file")
  awk -v preset="$preset" -v count="$count" -v expected="${expected:-0}" 'BEGIN {
    ratio = expected > 0 ? count / expected : 0
    printf "%s: %.1f million instructions, %.4f times those of the file\n", preset, count / 1e6, ratio
    exit !(ratio > 0.99 && ratio < 1.01)
  }' || { echo "FAILED: $preset"; status=1; }
done < <(count_instructions "$program")
[ "$status" = 0 ] || echo "tools/renew-instruction-counts WHY accepts the change"
exit $status
