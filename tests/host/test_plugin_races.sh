#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Two instances of the plugins of each format in two threads, while another thread saves and restores them, under
# ThreadSanitizer.
#
# test_plugin_races.sh SOURCE CMAKE CLAP-HEADERS TEST...
set -eu
source=$1 cmake=$2 clap=$3
shift 3
# shellcheck source=tests/support/find_clang.sh
. "$source/tests/support/find_clang.sh"
# shellcheck source=tests/support/skips.sh
. "$source/tests/support/skips.sh"
compiler=$(find_clang) || skip "needs clang-22"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$cmake" -S "$source" -B "$work/build" -DCMAKE_C_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_C_FLAGS="-O1 -g -fsanitize=thread" -DTABOR_BUILD_PROGRAM=OFF -DTABOR_INSTALL=OFF \
  -DTABOR_CLAP_INCLUDE_DIR="$clap" >"$work/log" 2>&1 &&
  "$cmake" --build "$work/build" --target "$@" >>"$work/log" 2>&1 || {
  tail -20 "$work/log"
  echo "FAILED: building with -fsanitize=thread"
  exit 1
}

# A sanitizer that finds nothing anywhere would be worth nothing.
cat >"$work/race.c" <<'END'
#include <pthread.h>
static int shared;
static void *add(void *unused) { for (int i = 0; i < 100000; i++) shared++; return unused; }
int main(void) {
  pthread_t other;
  pthread_create(&other, 0, add, 0);
  add(0);
  pthread_join(other, 0);
  return 0;
}
END
"$compiler" -O0 -g -fsanitize=thread "$work/race.c" -o "$work/race"
if "$work/race" >"$work/log" 2>&1; then
  echo "FAILED: ThreadSanitizer does not see a race"
  exit 1
fi

for test in "$@"; do
  TSAN_OPTIONS=halt_on_error=1 "$work/build/tests/$test" 100 >"$work/log" 2>&1 || {
    tail -60 "$work/log"
    echo "FAILED: ThreadSanitizer, $test"
    exit 1
  }
  grep -q 'PASSED.* 3 test' "$work/log"
done
