#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Completion in bash: commands, options, choices, presets, kits, keys, their values, microphones and outputs, as the program has them.
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
completes "frame-drums" play --kit fr
completes "frame-drums jazz marching standard" library --kit ""
completes "buzz cross-stick normal rim rimshot" library --techniques ""
completes "normal,buzz" library --techniques normal,b
completes "booth hall none studio" render --set room.kind =
completes "studio" render --set room.kind = st
completes "studio" render --set = room.kind = st
completes "" render --set wires.count = 2

# A machine with sound outputs: their names have blanks and colons.
cat >with-outputs <<END
#!/bin/sh
if [ "\$1" != devices ]; then exec "$TABOR" "\$@"; fi
echo "ALSA: Card One: Analog (hw:0,0) (default): 2 channels, 48000 Hz, 8.7 ms"
echo "JACK Audio Connection Kit: system: 2 channels, 48000 Hz, 5.3 ms"
END
chmod +x with-outputs
TABOR=./with-outputs completes "Card\\ One:\\ Analog\\ \\(hw:0\\,0\\)" play --device 'Card\ O'
TABOR=./with-outputs completes "system" play --device s
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
