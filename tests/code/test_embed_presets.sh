#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# engine/embed-presets.cmake must accept valid preset files and refuse others with the line number. test_preset_file
# checks that the table has the same contents as the program reads from the files.
#
# test_embed_presets.sh SOURCE-FOLDER CMAKE
set -euo pipefail
script=$1/engine/embed-presets.cmake cmake=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
status=0

embed() { "$cmake" -D OUTPUT=table.c -D "PRESETS=$scratch/p.ini" -P "$script" 2>&1; }

# take TEXT LINE...: the text's table has these lines, in order, and no other pairs.
take() {
  local text=$1
  shift
  rm -f table.c
  printf '%b' "$text" >p.ini
  embed || { echo "refused: $text" >&2; status=1; return; }
  if ! diff <(printf '  %s\n' "$@") <(grep '^  {' table.c); then
    echo "not what stands in: $text" >&2
    status=1
  fi
}

# refuse TEXT PLACE-AND-REASON
refuse() {
  local said
  rm -f table.c
  printf '%b' "$1" >p.ini
  said=$(embed | tr -s '\n ' ' ') && { echo "taken: $1" >&2; status=1; }
  if [[ "$said" != *"p.ini:$2"* ]] || [ -e table.c ]; then
    echo "'$1' is refused by: $said" >&2
    status=1
  fi
}

take '; c\n# d\n\n[drum]\nx = 1 ; one\ncomment=A b;c\n\n[b.c]  ; section\nx =\t3\t;three\n \t; comment\n \t\n' \
  '{"drum", NULL},' '{"drum.x", "1"},' '{"drum.comment", "A b;c"},' '{"b.c", NULL},' '{"b.c.x", "3"},' \
  '{{"p", "A b;c", "p.ini"}, pairs_0, 5},'
take '[a]\r\nx = 1\r\n' '{"a", NULL},' '{"a.x", "1"},' '{{"p", "", "p.ini"}, pairs_0, 2},'
take '[off]\ny = ; nothing\nz = p=q:r;s [t] "u\\v" ${CMAKE_COMMAND} @w@ ??\n' '{"off", NULL},' '{"off.y", ""},' \
  '{"off.z", "p=q:r;s [t] \042u\134v\042 ${CMAKE_COMMAND} @w@ \077\077"},' '{{"p", "", "p.ini"}, pairs_0, 3},'

refuse '' ' the file holds no section'
refuse '; nothing\n' ' the file holds no section'
refuse '[a]\nx = 30' ' the last line has no line end'
refuse '[a]\nx = 1\0\n' ' the file has characters other'
refuse '[a]\nx = 1\n\0\ny = 1\n' ' the file has characters other'
refuse '[a]\nx = \0303\0251\n' ' the file has characters other'
refuse '[a]\rx = 1\r' ' the file has characters other'
refuse 'x = 1\n[a]\n' "1: 'x' stands before the first section"
refuse '[a]\n\n\nx\n' '4: the line is neither'
refuse '[a]\nx: y = 1\n' '2: the line is neither'
refuse '[a]\nx 1 ; y = 2\n' '2: the line is neither'
refuse '[a]\n= 1\n' '2: a key without a name'
refuse '[]\n' '1: a section without a name'
refuse '[a\n' "1: a '[' without a ']'"
refuse '[a ;]\n' "1: a '[' without a ']'"
refuse '[a] x = 1\n' "1: text after the section's ']'"
refuse '[a]\nx = 1\n\ty = 2\n' '3: the line is indented'
refuse '[a]\nx = 1\nx=2\n' "3: 'x' occurs twice"
refuse '[a]\n[b]\n[a]\n' '3: section [a] occurs twice'
word=$(printf '%050d' 0)
refuse "[a]\n$word = 1\n" '2: the key is longer than 49 bytes'
refuse "[$word]\n" '1: the section is longer than 49 bytes'
refuse "[a]\nx = $word$word$word$word\n" '2: the line is longer than 198 bytes'
refuse "[a]\n;$(printf '%065536d' 0 | fold -w 100)\n" ' the file is larger than 65536 bytes'
exit "$status"
