#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: test_system_instruction_counts.sh INSTRUCTION-COUNTS FILE COMPILER
# Half a second of a stroke takes as many instructions as FILE says, within 1 %, and as many bytes of the second cache, within
# 2 % (where memory lies moves them by 0.2 %): a drum that costs more, or less, does so on purpose. Other compilers make
# other code: the file names the one that it is for.
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
while read -r preset instructions bytes; do
  expected=$(sed -n "s/^$preset //p" "$file")
  awk -v preset="$preset" -v n="$instructions" -v bytes="$bytes" -v expected="$expected" 'BEGIN {
    split(expected, of)
    instructions = of[1] > 0 ? n / of[1] : 0
    traffic = of[2] > 0 ? bytes / of[2] : 0
    printf "%s: %.1f million instructions, %.4f times those of the file; %.1f million bytes, %.4f times\n", \
      preset, n / 1e6, instructions, bytes / 1e6, traffic
    exit !(instructions > 0.99 && instructions < 1.01 && traffic > 0.98 && traffic < 1.02)
  }' || { echo "FAILED: $preset"; status=1; }
done < <(count_instructions "$program")
[ "$status" = 0 ] || echo "tools/renew-instruction-counts WHY accepts the change"
exit $status
