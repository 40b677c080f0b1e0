#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Doxygen makes the manual of tabor.h, kit.h and docs/embedding.md without a warning: everything that is public
# is described, and every reference leads somewhere.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
needs doxygen doxygen

quietly "$CMAKE" -S "$SOURCE" -B build -DCMAKE_C_COMPILER="$CC" -DTABOR_BUILD_TESTS=OFF -DTABOR_BUILD_PROGRAM=OFF
quietly "$CMAKE" --build build --target manual
warnings=build/docs/manual-warnings.txt
if [ -s "$warnings" ]; then complain "Doxygen warns: $(cat "$warnings")"; fi

pages=build/docs/manual/html
[ -s $pages/index.html ] || complain "there is no manual"
for header in "$SOURCE"/engine/include/tabor/*.h; do
  page=$pages/$(basename "$header" .h)_8h.html
  [ -s "$page" ] || complain "the manual lacks ${header##*/}"
  tr '\n' ' ' <"$header" | grep -oE 'TABOR_API [^;(]*\(' | grep -oE 'tabor_[a-z0-9_]+' >functions
  while IFS= read -r function; do
    grep -q "memname.*>$function \|memname.* $function<\|$function &\#160;\|>$function<" "$page" ||
      complain "the manual lacks $function()"
  done <functions
done
