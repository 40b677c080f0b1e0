#compdef tabor
# SPDX-License-Identifier: MIT
# Completion of the command line of tabor in zsh. What there is to complete, the program says itself.

local program=$words[1] command=$words[2] line
local -a found

# Lines of the help as "WORD:what it does".
_tabor_commands() { $program --help 2>/dev/null | sed -nE 's/^  ([a-z][a-z-]*) +(.*)/\1:\2/p'; }
_tabor_options() {
  $program $1 --help 2>/dev/null | sed -nE 's/^ +((-[a-zA-Z]), )?(--[a-z0-9-]+)( [A-Z=]+)? +(.*)/\3:\5/p'
}
# What the help says of the value of an option: "LEVEL draft, live, studio or reference (default live)".
_tabor_value() { $program $1 --help 2>/dev/null | sed -nE "s/^ +((-[a-zA-Z]), )?$2 ([A-Z=]+ .*)/\3/p"; }
_tabor_choices() { sed -nE 's/^[A-Z]+ +(of )?((([a-z0-9-]+), )*([a-z0-9-]+) (or|and) ([a-z0-9-]+))([ ,].*|$)/\2/p' | sed -E 's/,| or | and / /g'; }
_tabor_names() { $program presets $1 2>/dev/null | sed -E 's/ .*//'; }

if (( CURRENT == 2 )); then
  found=("${(@f)$(_tabor_commands)}")
  _describe command found
elif [[ $words[CURRENT] == -* ]]; then
  found=("${(@f)$(_tabor_options $command)}")
  _describe option found
elif line=$(_tabor_value $command $words[CURRENT-1]) && [[ -n $line ]]; then
  found=(${=$(print -r -- $line | _tabor_choices)})
  if [[ $line == KIT* ]]; then found=("${(@f)$(_tabor_names --kits)}"); fi
  if (( $#found )); then compadd -- $found; else _files; fi
else
  found=("${(@f)$(_tabor_names)}")
  compadd -- $found
  _files
fi
