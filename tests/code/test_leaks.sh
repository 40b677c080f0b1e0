#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs the cases of test_system_instances under valgrind: creating and destroying drums must not leak memory or
# access invalid memory.
#
# test_leaks.sh TEST_SYSTEM_INSTANCES CYCLES
set -euo pipefail
program=$1 cycles=$2

# shellcheck source=tests/support/skips.sh
. "$(dirname "$0")/../support/skips.sh"
needs valgrind valgrind
said=$(valgrind -q --leak-check=full --show-leak-kinds=all --errors-for-leak-kinds=all --error-exitcode=9 \
  "$program" "$cycles" 'nothing_is_left*' 2>&1) || { echo "$said" >&2; exit 1; }
grep -q 'PASSED.* 1 test' <<<"$said"
