#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What the audio thread may call, read off the objects themselves: the objects listed here are all
# that runs on it. They may call each other and the allow-list, and nothing else, whatever branch a
# test happens to take.
#
# test_realtime_symbols.sh LIBTABOR.A
set -euo pipefail
library=$1

# Sources of which every function is safe on the audio thread.
realtime_sources="kernels law power solve state live energy"

# Functions from outside: they allocate nothing, lock nothing and make no system call. The
# compiler itself puts in calls of the first four.
allowed="memcpy memmove memset memcmp sqrt _GLOBAL_OFFSET_TABLE_ __stack_chk_fail"

# Lines of "source kind name" for every symbol: U is needed, T, D, R and their like are given.
symbols=$(nm -A "$library" | sed -nE 's/^.*:([^:]+)\.c\.o: *[0-9a-f]* ([A-Za-z]) (.*)$/\1 \2 \3/p')

awk -v sources="$realtime_sources" -v allowed="$allowed" '
  BEGIN {
    split(sources, list, " ")
    for (i in list) realtime[list[i]] = 1
    split(allowed, list, " ")
    for (i in list) given[list[i]] = 1
  }
  $1 in realtime { seen[$1] = 1 }
  $1 in realtime && $2 ~ /[A-TV-Z]/ { given[$3] = 1 }
  $1 in realtime && $2 == "U" { needed[$3] = needed[$3] " " $1 ".c" }
  END {
    for (name in realtime) if (!(name in seen)) { print name ".c: not in the library"; bad = 1 }
    for (name in needed) if (!(name in given)) { print name ": called from" needed[name]; bad = 1 }
    exit bad
  }' <<<"$symbols" >&2
