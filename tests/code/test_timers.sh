#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The library as it is released has none of the timers that TABOR_PROFILE puts into every stage.
#
# test_timers.sh LIBTABOR.A
set -euo pipefail
symbols=$(nm "$1")
grep -q ' T tabor_drum_process$' <<<"$symbols" # nm has read a library
if grep tb_profile <<<"$symbols" >&2; then
  echo "timers in $1" >&2
  exit 1
fi
