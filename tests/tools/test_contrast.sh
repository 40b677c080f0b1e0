#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Texts of the window and the page stand out from what is behind them as docs/design.md says, and by 4.5 at least (WCAG 2).
#
# test_contrast.sh SOURCE-FOLDER
source=$1
. "$(dirname "$0")/../support/host_checks.sh"

# contrast R G B R G B, 0 to 1
contrast() {
  awk -v "colours=$*" 'function linear(c) { return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ^ 2.4 }
    BEGIN { split(colours, c, " ")
      for (i = 0; i < 2; i++) l[i] = 0.2126 * linear(c[3*i+1]) + 0.7152 * linear(c[3*i+2]) + 0.0722 * linear(c[3*i+3])
      ratio = (l[0] + 0.05) / (l[1] + 0.05)
      printf "%.1f", (ratio > 1 ? ratio : 1 / ratio) }'
}

# of_window NAME: a colour of painting.c.
of_window() { sed -n "s/^void $1(cairo_t \*cairo) { cairo_set_source_rgb(cairo, \([0-9., ]*\)); }/\1/p" "$source/host/window/painting.c" | tr -d ,; }

# of_page SCHEME NAME: a colour of style.css, of which dark ones stand second.
of_page() {
  local hex
  hex=$(sed -n "s/^ *--$2: #\(......\);/\1/p" "$source/web/page/style.css" | sed -n "$([ "$1" = light ] && echo 1 || echo 2)p")
  awk -v "r=$((16#${hex:0:2}))" -v "g=$((16#${hex:2:2}))" -v "b=$((16#${hex:4:2}))" 'BEGIN { print r / 255, g / 255, b / 255 }'
}

# check_row NAME TEXT GROUND PANEL: a row of the table, of colours.
check_row() {
  local ground panel
  ground=$(contrast "$2" "$3") panel=$(contrast "$2" "$4")
  same "$1" "| $1 | $ground | $panel |" "$(grep -F "| $1 |" "$source/docs/design.md")"
  holds "$1: stands out" "$ground >= 4.5 && $panel >= 4.5"
}

same "black on white" 21.0 "$(contrast 0 0 0 1 1 1)"
while read -r line; do
  name=${line##* } words=${line% *}
  check_row "window: $words" "$(of_window "$name")" "$(of_window paper)" "$(of_window field)"
done <<<"text ink
grey pale
accent accent
what is wrong alarm"
for scheme in light dark; do
  while read -r words name; do
    check_row "page, $scheme: $words" "$(of_page $scheme "$name")" "$(of_page $scheme ground)" "$(of_page $scheme panel)"
  done <<<"text text
grey quiet
accent accent"
done
finish
