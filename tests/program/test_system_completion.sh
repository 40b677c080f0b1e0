#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Completion in bash: commands, options, choices, presets, keys and microphones, as the program has them.
completion=$(cd "$(dirname "$0")/../../host" && pwd)/completion.bash
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"

compopt() { :; } # works within a real completion only
# shellcheck source=host/completion.bash
. "$completion"

# completions WORD...: what the last word is completed to, a line each.
completions() {
  COMP_WORDS=(tabor "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _tabor "$TABOR" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  printf '%s\n' "${COMPREPLY[@]}"
}

# completes EXPECTED WORD...: to these words, in any order.
completes() {
  local expected=$1
  shift
  same "completion of: $*" "$expected" "$(completions "$@" | sort | tr '\n' ' ' | sed 's/ $//')"
}

completes render ren
completes "presets" pre
completes "render" help rend
completes "--quality --quiet" render --qu
completes "live" render --quality li
completes "draft live reference studio" render --quality ""
completes "live" render --quality = l
completes "pcm16 pcm24" render --format pcm
completes "hard linear soft" play --velocity-curve ""
completes "addictive alesis roland superior yamaha" render --map ""
completes "full normal" library --velocity-range ""
completes "bodhran-d-string bodhran-d-string-tensioned" show bodhran-d
completes "wires.strainer= wires.strainer_travel=" render snare-14x5.5 --set wires.strainer
completes "" render frame-drum --mic near
completes "near" render snare-14x5.5 -o x.wav --mic ne
completes "" play --device to
touch own.ini other.wav
completes "own.ini" render ow
completes "other.wav" render -o ot

# Every command is offered, and every option of every command.
for command in $("$TABOR" --help | sed -nE 's/^  ([a-z][a-z-]*) .*/\1/p'); do
  check "$command is offered" grep -qx "$command" <(completions "")
  for option in $("$TABOR" "$command" --help | grep -oE '^ +(-[a-zA-Z], )?--[a-z0-9-]+' | grep -oE '[-]+[a-zA-Z0-9-]+'); do
    check "$command $option is offered" grep -qx -- "$option" <(completions "$command" "$option")
  done
done
finish
