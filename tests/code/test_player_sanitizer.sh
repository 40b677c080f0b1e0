#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks the audio threads of the program and the plugins with clang's RealtimeSanitizer while test_player_realtime,
# test_lv2_realtime and test_clap_realtime play. test_player_effects checks the calls in the sources.
#
# test_player_sanitizer.sh SOURCE CMAKE [CLAP-HEADERS]
set -eu
source=$1 cmake=$2 clap=${3:-}
# shellcheck source=tests/support/find_clang.sh
. "$source/tests/support/find_clang.sh"
# shellcheck source=tests/support/skips.sh
. "$source/tests/support/skips.sh"
compiler=$(find_clang) || skip "needs clang-22"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tests=test_player_realtime
if pkg-config --exists lv2; then tests+=" test_lv2_realtime"; else skip_part "the LV2 plugins: needs lv2-dev"; fi
if [ -n "$clap" ]; then
  tests+=" test_clap_realtime"
else
  skip_part "the CLAP plugins: there are no CLAP headers (tools/setup --plugins brings them)"
fi

# shellcheck disable=SC2086 # words
"$cmake" -S "$source" -B "$work/build" -DCMAKE_C_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_C_FLAGS="-O1 -fsanitize=realtime" -DTABOR_INSTALL=OFF ${clap:+-DTABOR_CLAP_INCLUDE_DIR="$clap"} \
  >"$work/log" 2>&1 &&
  "$cmake" --build "$work/build" --parallel 2 --target $tests >>"$work/log" 2>&1 || {
  tail -20 "$work/log"
  echo "FAILED: building with -fsanitize=realtime"
  exit 1
}

failures=0
fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}
for test in $tests; do # a few seconds each
  "$work/build/tests/$test" 3 >"$work/log" 2>&1 || {
    tail -40 "$work/log"
    fail "RealtimeSanitizer, $test"
  }
  grep -q 'changes of the model' "$work/log" || fail "nothing was played by $test"
done

[ $failures = 0 ]
