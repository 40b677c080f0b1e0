#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The code of docs/embedding.md compiles without a warning and does what the page says: the first piece is
# a whole program, of some 30 lines; the others are run by embedding_pieces.c.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"

install_tree "$STATIC_BUILD" "$scratch/tree"
use_pkg_config "$scratch/tree"
read -ra flags <<<"$(pkg-config --cflags --libs tabor)"
strict=(-std=c11 -O2 -Wall -Wextra -Werror -I"$scratch" -I"$SOURCE/examples")

awk '/^```c$/ { piece++; inside = 1; next } /^```$/ { inside = 0 } inside { print > (piece == 1 ? "whole.c" : "pieces.c") }' \
  "$SOURCE/docs/embedding.md"

quietly "$CC" "${strict[@]}" whole.c "${flags[@]}" -o whole
lines=$(grep -c '[^ ]' whole.c)
((lines >= 25 && lines <= 35)) || complain "the program has $lines lines"
./whole
header=44 # bytes
[ "$(stat -c %s snare.wav)" = $((header + 4 * 96000)) ] || complain "the program does not write two seconds"
"$TABOR" analyze snare.wav >log || complain "the program writes no sound file"
strokes=$(od -An -v -t f4 -w4 -j $header snare.wav | awk '
  { level = $1 < 0 ? -$1 : $1; if (level > peak[int(NR / 24000)]) peak[int(NR / 24000)] = level }
  END { for (i = 0; i < 4; i++) count += peak[i] > 0.05; print count }')
[ "$strokes" = 4 ] || complain "$strokes of its 4 strokes are heard"

quietly "$CC" "${strict[@]}" "$SOURCE/tests/packaging/embedding_pieces.c" "${flags[@]}" -lm -o pieces
./pieces
