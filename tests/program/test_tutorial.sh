#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every command of docs/tutorial.md that makes a file does so, without a warning that the page does not announce.
#
# test_tutorial.sh SOURCE-FOLDER
source=$1
. "$(dirname "$0")/../support/host_checks.sh"
page=$source/docs/tutorial.md

ln -s "$source/examples" examples
mkdir bin && ln -s "$TABOR" bin/tabor
sed -n '/^```ini$/,/^```$/p' "$page" | grep -v '^```' >my-kit.ini
check "the page has a kit" grep -q '^\[drum.kick\]' my-kit.ini

commands=0
while IFS= read -r line; do
  commands=$((commands + 1))
  PATH=$PWD/bin:$PATH bash -c "$line" >"$out" 2>"$err"
  same "$line: its status" 0 $?
  same "$line: warnings" "" "$(grep 'warning' "$err")"
done < <(grep -E '^    tabor (render|show)' "$page" | sed 's/^    //')
holds "commands of the page" "$commands >= 15"
for file in $(grep -E '^    tabor render' "$page" | grep -oE '[^ ]+\.wav' | grep -v -e -top -e -bottom -e take.wav); do
  holds "$file is loud enough, and not clipped" "$("$INSPECT" peak "$file") > 0.02 && $("$INSPECT" peak "$file") < 0.999"
done
finish
