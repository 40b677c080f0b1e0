#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks in the compiled library which functions the audio thread can call, independent of the branches that other
# tests take. Every function has its own section. From the functions that the headers mark AUDIO or ANY, this test
# follows every reference to other sections, tables of functions included, and checks the symbols reached
# outside the library. It cannot see the user's function pointers, the allocator; test_realtime counts its calls.
#
# With archives of the program, this test checks the program's audio thread in the same way and also allows the
# clock, which is read in user space.
#
# test_realtime_symbols.sh LIBTABOR.A TABOR.H [ARCHIVE]...
set -euo pipefail
library=$1 header=$2
shift 2

# They allocate nothing, lock nothing and make no system call. The compiler itself puts in calls of
# the first four; sqrt is exact everywhere.
allowed="memcmp memcpy memmove memset sqrt _GLOBAL_OFFSET_TABLE_ __stack_chk_fail"

audio=$(awk '/^ \* [A-Z-]+: / { audio = $2 == "AUDIO:" || $2 == "ANY:" } /^\/\*\* @} \*\/$/ { audio = 0 } audio' \
  "$(dirname "$header")"/*.h | grep -oE '^TABOR_API [^;(]*\(' | grep -oE 'tabor_[a-z0-9_]+')

if [ $# -gt 0 ]; then
  audio="player_process player_send ask_client $audio"
  allowed+=" clock_gettime pthread_self fmax fmin"
fi

# Follows what `objdump -t -r` prints; says what is wrong, and fails then.
walk() {
  awk -v roots="$audio" -v allowed="$allowed" '
  # A node is a section of a member of the archive.
  / file format / { member++; name[member] = $1; next }
  /^RELOCATION RECORDS FOR/ { section = substr($4, 2, length($4) - 3); next }
  /^[0-9a-f]+ [gl!uw ][w ]/ {                     # a symbol: value flags section size [.hidden] name
    rest = substr($0, index($0, " ") + 9)
    split(rest, field, /[ \t]+/)
    if (field[1] == "*UND*") next
    flag = substr($0, index($0, " ") + 1, 1)
    if (flag == "l") {
      local[member, $NF] = field[1]
      if ($NF !~ /^\./) own[$NF] = member SUBSEP field[1]
    }
    else { given[$NF] = given[$NF] member SUBSEP field[1] " " }
    next
  }
  /^[0-9a-f]+ R_/ {
    symbol = $3
    sub(/[-+]0x[0-9a-f]+$/, "", symbol)
    refers[member, section] = refers[member, section] symbol " "
  }
  function visit(node, path) {
    if (node in seen) return
    seen[node] = path
    todo[++last] = node
  }
  END {
    count = split(roots, root, /[ \n]+/)
    for (i = 1; i <= count; i++) {
      if (!(root[i] in given) && !(root[i] in own)) { print root[i] ": not in the library"; bad = 1; continue }
      if (root[i] in own) visit(own[root[i]], root[i])
      n = split(given[root[i]], place, " ")
      for (j = 1; j <= n; j++) visit(place[j], root[i])
    }
    for (symbol in given) {                        # chosen when a model is made, called by pointer
      if (symbol !~ /^tb_kernels_/) continue
      n = split(given[symbol], place, " ")
      for (j = 1; j <= n; j++) visit(place[j], symbol)
      kernels[symbol ~ /f$/]++                     # f: of single precision
    }
    if (!kernels[0] || !kernels[1]) { print "no table of kernels was found for one of both precisions"; bad = 1 }
    n = split(allowed, list, " ")
    for (i in list) fine[list[i]] = 1
    for (at = 1; at <= last; at++) {
      node = todo[at]
      split(node, part, SUBSEP)
      n = split(refers[node], target, " ")
      for (i = 1; i <= n; i++) {
        t = target[i]
        if (t ~ /^\./) visit(part[1] SUBSEP t, seen[node])
        else if ((part[1], t) in local) visit(part[1] SUBSEP local[part[1], t], seen[node] " > " t)
        else if (t in given) {
          m = split(given[t], place, " ")
          for (j = 1; j <= m; j++) visit(place[j], seen[node] " > " t)
        }
        else if (!(t in fine)) { print t ": called by " seen[node]; fine[t] = 1; bad = 1 }
      }
    }
    if (last < 20) { print "only " last + 0 " functions were reached: this test sees nothing"; bad = 1 }
    exit bad
  }'
}

symbols=$(objdump -t -r "$library" "$@")
walk <<< "$symbols" >&2

# It would find a call of malloc in each precision of what tables choose: these functions have none of their own.
plant() { awk -v member="$1" -v line="RELOCATION RECORDS FOR [.text.$2]:" '
  { print }
  / file format / && $1 == member ":" { print line; print "0000000000000000 R_X86_64_PLT32 malloc-0x4"; found = 1 }
  END { exit !found }' <<< "$symbols"; }

for place in kernels.c.o:cg_apply kernelsf.c.o:cg_apply kernelsf.c.o:newton_diagonal contact_solve.c.o:solve_contacts \
  contact_solvef.c.o:solve_contacts wire_motion.c.o:penetrate wire_motionf.c.o:penetrate high_band_step.c.o:strike \
  high_band_stepf.c.o:strike projection.c.o:project_rounded; do
  planted=$(plant "${place%:*}" "${place#*:}") || { echo "$place: not in the library" >&2; exit 1; }
  if found=$(walk <<< "$planted") || [[ $found != "malloc: called by "* ]]; then
    echo "a call of malloc in $place was not found: ${found:-nothing was}" >&2
    exit 1
  fi
done
