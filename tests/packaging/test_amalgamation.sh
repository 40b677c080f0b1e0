#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The engine as one source: it compiles alone without a warning by each compiler that is here, and gives the library's
# bits in hundreds of renderings. SOUND_HASHES is the tests' program of that name, linked to the library.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$SOURCE/tests/support/find_python.sh"
: "${SOUND_HASHES:?sound_hashes}"
needs universal-ctags ctags

python=$(find_python re) || skip "needs python3"
quietly "$python" "$SOURCE/tools/amalgamate" amalgamation
[ "$(find amalgamation -type f | wc -l)" = 2 ] || complain "not two files: $(ls amalgamation)"

strict=(-std=c11 -Wall -Wextra -Wpedantic -Werror)
quietly "$CC" "${strict[@]}" -O1 -c amalgamation/tabor.c -o tabor.o
for compiler in clang musl-gcc; do
  if command -v $compiler >/dev/null; then
    quietly $compiler "${strict[@]}" -fsyntax-only amalgamation/tabor.c
  else
    skip_part "$compiler: it is not here"
  fi
done
if "$CC" -std=c11 -ffast-math -fsyntax-only amalgamation/tabor.c 2>fast.log; then complain "it compiles with -ffast-math"; fi
grep -q 'without -ffast-math' fast.log || complain "it does not say why"

# Programs find its header in the place of the library's two.
mkdir -p include/tabor
for header in tabor.h kit.h; do echo '#include "../../amalgamation/tabor.h"' >include/tabor/$header; done
support=$SOURCE/tests/support
quietly "$CC" -std=c11 -O2 -Iinclude -I"$support" "$support/sound_hashes.c" "$support/kit_hashes.c" tabor.o -lm -o hashes

# Drums, in single precision and in double, with every technique and event that sound_hashes has.
for case in "tabor draft" "tabor live" "frame-drum draft" "bodhran-d-string draft" "tom-12 draft" "snare-14x5.5 draft"; do
  read -ra words <<<"$case"
  ./hashes hash "${words[@]}" >>one.txt
  "$SOUND_HASHES" hash "${words[@]}" >>library.txt
done
# A column has the instructions; the library also has those that this file was not compiled for.
cmp -s one.txt library.txt || complain "other bits: $(diff one.txt library.txt | head -n 4)"
echo "$(wc -l <one.txt) renderings are the same to the bit"
[ "$(wc -l <one.txt)" -ge 200 ] || complain "fewer than 200 renderings"
