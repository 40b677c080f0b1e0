#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks the order of the folders of engine and host. A file may include files of its own folder and of earlier
# folders. Includes must not form a cycle, and in the libraries references between sources must not form a cycle.
# Include paths start at engine/src and host.
#
# test_include_order.sh SOURCE-FOLDER [ARCHIVE]...
set -euo pipefail
source=$1
shift

engine="math definition air_model bodies bodies/drum bodies/plate high_band kernels model saved_model contact state air wires heads strikers step drum room kit"
host="platform base drums midi strokes files sound kit plugin window lv2 clap render library ui play inspect"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# includes: "FILE INCLUDED" for every include in quotes below this folder, but those of the public header.
includes() {
  grep -rE --include='*.[ch]' '^[ \t]*#[ \t]*include[ \t]+"' . | sed -E 's|^\./([^:]*):[^"]*"([^"]*)".*|\1 \2|' |
    grep -vE ' tabor/(tabor|kit)\.h$' || true
}

# wrong_folders ORDER: files that stand in none of these folders. Only main.c stands on top.
wrong_folders() {
  find . -name '*.[ch]' -printf '%P\n' | sort | awk -v order="$1" '
    BEGIN { split(order, list, " "); for (i in list) known[list[i]] = 1 }
    { folder = $0; sub(/\/[^\/]*$/, "", folder) }
    $0 != "main.c" && !(folder in known) { print $0 ": in no folder of the order" }'
}

# upward ORDER: includes of folders that come later, and of what is not there.
upward() {
  includes | awk -v order="$1" '
    function folder(file) { return sub(/\/[^\/]*$/, "", file) ? file : "" }
    BEGIN { count = split(order, list, " "); for (i in list) rank[list[i]] = +i; rank[""] = count + 1 }
    system("test -f " $2) != 0 { print $1 ": there is no " $2; next }
    folder($1) in rank && rank[folder($2)] > rank[folder($1)] { print $1 ": includes " $2 ", whose folder comes later" }'
}

# circles WHAT: of pairs "FILE USED-FILE".
circles() {
  awk '$1 != $2' | tsort 2>&1 >/dev/null | sed -E "s/^tsort: -: .*/$1:/; s/^tsort: /  /" || true # as tsort fails
}

# uses: "OBJECT USED-OBJECT" for what `nm -A` says of archives.
uses() {
  awk '
    NF < 2 { next }
    { object = $1; sub(/:[0-9a-f]*$/, "", object); sub(/.*\//, "", object) }
    $(NF - 1) ~ /^[A-TV-Z]$/ { home[$NF] = object }
    $(NF - 1) == "U" { user[++count] = object; used[count] = $NF }
    END { for (i = 1; i <= count; i++) if (used[i] in home) print user[i], home[used[i]] }'
}

# complaints FOLDER ORDER
complaints() (
  cd "$1"
  wrong_folders "$2"
  upward "$2"
  includes | circles "a circle of includes"
)

# check FOLDER ORDER: says what is wrong there.
check() {
  local said
  said=$(complaints "$1" "$2")
  if [ -z "$said" ]; then return; fi
  printf '%s:\n%s\n' "${1#"$source/"}" "$said"
  failures=$((failures + 1))
}

# ---- the check itself, on a tree that is right and on ones that are not ----

# made NAME FILE=INCLUDED...: a folder of these files, each with one include or none.
made() {
  local tree=$work/$1 file
  shift
  for file in "$@"; do
    mkdir -p "$(dirname "$tree/${file%=*}")"
    { if [ -n "${file#*=}" ]; then echo "#include \"${file#*=}\""; fi; } >"$tree/${file%=*}"
  done
  complaints "$tree" "low high"
}

# finds PATTERN NAME FILE=INCLUDED...: in such a folder this is found; an empty pattern: nothing.
finds() {
  local pattern=$1 said
  shift
  said=$(made "$@")
  if [ -z "$pattern" ] && [ -z "$said" ]; then return; fi
  if [ -n "$pattern" ] && grep -qE "$pattern" <<<"$said"; then return; fi
  echo "of a tree with the fault '$1' this is said: '$said'"
  failures=$((failures + 1))
}

right="low/a.h= low/a.c=low/a.h low/b.h=low/a.h high/c.c=low/a.h main.c=high/d.h high/d.h="
# shellcheck disable=SC2086 # a list of files
{
  finds '' none $right
  finds 'low/e.c: includes high/d.h' upward $right low/e.c=high/d.h
  finds 'low/e.c: there is no d.h' 'not written from the top' $right low/e.c=d.h
  finds 'other/e.c: in no folder' 'unknown folder' $right other/e.c=
  finds '^e.c: in no folder' 'on top' $right e.c=
  finds 'low/deep/e.c: in no folder' 'folder in a folder' $right low/deep/e.c=
  finds 'circle' 'a circle of headers' $right low/e.h=low/f.h low/f.h=low/e.h
}

# objects USER...: what nm says of objects a, b and c, of which each uses the one named.
objects() {
  local object
  for object in a b c; do
    printf 'some/lib.a:%s.o:0000000000000010 T f_%s\nsome/lib.a:%s.o:                 U f_%s\n' $object $object $object "$1"
    shift
  done
}
said=$(objects b c malloc | uses | circles "a circle of calls")
if [ -n "$said" ]; then
  echo "of calls in one direction this is said: '$said'"
  failures=$((failures + 1))
fi
said=$(objects b c a | uses | circles "a circle of calls")
if ! grep -qx '  lib.a:b.o' <<<"$said"; then
  echo "of a circle of calls this is said: '$said'"
  failures=$((failures + 1))
fi

# ---- the trees, and what was compiled from them ----

if [ -d "$source/engine/src/${engine%% *}" ]; then check "$source/engine/src" "$engine"; fi
check "$source/host" "$host"
if [ $# -gt 0 ]; then
  said=$(nm -A "$@" | uses | circles "a circle of calls")
  if [ -n "$said" ]; then
    echo "$said"
    failures=$((failures + 1))
  fi
fi

[ $failures = 0 ]
