#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Presets sound as they did when the hashes in FILE were written: a change of sound is made on purpose, or noticed.
# Usage: test_system_sound_hashes.sh SOUND_HASHES FILE
set -euo pipefail
program=$1 file=$2
# shellcheck source=tests/support/skips.sh
. "$(dirname "$0")/../support/skips.sh"
[ -e "$file" ] || skip "there is no ${file##*/} yet: tools/renew-sound-hashes writes it"

failed=0
for quality in draft live studio reference; do
  expected=$(grep -E "^$quality(-cymbals)? " "$file") || expected="no line"
  got=$("$program" summary "$quality")
  [ "$got" = "$expected" ] && continue
  echo "FAILED: $quality: expected '$expected', got '$got'"
  failed=1
done
if [ "$failed" = 1 ]; then
  echo "tools/same-sound names the cases that differ from a commit's;" \
    "tools/renew-sound-hashes WHY accepts the change"
fi
exit "$failed"
