# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Completion of the command line of tabor in bash. What there is to complete, the program says itself,
# so nothing here has to follow it.

# Words of the help: _tabor_help COMMAND; commands of the program: _tabor_help "".
_tabor_help() {
  if [ -n "$1" ]; then
    "$_tabor_program" "$1" --help 2>/dev/null |
      sed -nE 's/^ +((-[a-zA-Z]), )?(--[a-z0-9-]+).*/\2 \3/p'
  else
    "$_tabor_program" --help 2>/dev/null | sed -nE 's/^  ([a-z][a-z-]*) .*/\1/p'
    echo "help --help --version"
  fi
}

# What the help says of option $2, "--output" or "-o", of command $1: its value's name, then its text.
_tabor_option() {
  "$_tabor_program" "$1" --help 2>/dev/null | awk -v wanted="$2" '
    /^ +(-[a-zA-Z], )?--/ {
      name = $1 ~ /^--/ ? 1 : 2
      if ($name != wanted && substr($1, 1, 2) != wanted) next
      for (i = 1; i <= name; i++) $i = ""
      print
      exit
    }' | sed 's/^ *//'
}

# The words that the text of an option lists: "draft, live, studio or reference (default ...", "of normal and buzz, ...".
_tabor_choices() {
  sed -nE 's/^[A-Z]+ +(of )?((([a-z0-9-]+), )*([a-z0-9-]+) (or|and) ([a-z0-9-]+))([ ,].*|$)/\2/p' <<<"$1" |
    sed -E 's/,| or | and / /g'
}

# The preset that the line so far names, to ask the program about its keys and microphones.
_tabor_preset() {
  local word
  for word in "${COMP_WORDS[@]:2}"; do
    case $word in
      -* | "" | =) ;;
      *) if "$_tabor_program" show "$word" >/dev/null 2>&1; then echo "$word"; return; fi ;;
    esac
  done
}

_tabor_presets() { "$_tabor_program" presets 2>/dev/null | sed -E 's/ .*//'; }

_tabor_kits() { "$_tabor_program" presets --kits 2>/dev/null | sed -E 's/ .*//'; }

# Sound outputs, by the part of their names behind the colon, as words of the command line.
_tabor_devices() {
  local name
  "$_tabor_program" devices 2>/dev/null | sed -nE 's/^[^:]*: *(.*): [0-9]+ channels, .*/\1/p' | sed 's/ (default)$//' |
    while IFS= read -r name; do printf '%q\n' "$name"; done
}

# Values of key $1 of the preset, if it takes words: the program lists them when it refuses another one.
_tabor_values() {
  # shellcheck disable=SC2046
  "$_tabor_program" show $(_tabor_preset) --set "$1=?" 2>&1 >/dev/null | sed -nE '/ is none of: / { s/.* is none of: //; s/,//g; p; }'
}

# Keys of the preset, as "batter.tension=".
_tabor_keys() {
  # shellcheck disable=SC2046 # without a preset the program takes its own
  "$_tabor_program" show $(_tabor_preset) 2>/dev/null | awk -F '[][ ]' '
    /^\[/ { section = $2 }
    /^[a-z]/ { print section "." $1 "=" }'
}

_tabor_mics() {
  # shellcheck disable=SC2046
  "$_tabor_program" show $(_tabor_preset) 2>/dev/null | sed -nE 's/^\[mic\.(.*)\]/\1/p'
}

# Completes the value of option $2 of command $1 from $3; fails if the option takes none.
_tabor_complete_value() {
  local text
  text=$(_tabor_option "$1" "$2")
  case ${text%% *} in
    "" | *[!A-Z=]*) return 1 ;;
    KEY=VALUE)
      compopt -o nospace
      mapfile -t COMPREPLY < <(compgen -W "$(_tabor_keys)" -- "$3") ;;
    NAME)
      case $2 in
        --mic) mapfile -t COMPREPLY < <(compgen -W "$(_tabor_mics)" -- "$3") ;;
        --device) mapfile -t COMPREPLY < <(_tabor_devices | awk -v start="${3//\\/\\\\}" 'index($0, start) == 1') ;;
      esac ;;
    KIT) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -W "$(_tabor_kits)" -- "$3"; compgen -f -- "$3") ;;
    LIST)
      local listed= # what stands before the last comma
      if [[ $3 == *,* ]]; then listed=${3%,*},; fi
      mapfile -t COMPREPLY < <(compgen -P "$listed" -W "$(_tabor_choices "$text")" -- "${3##*,}") ;;
    FILE | FOLDER | DIRECTORY | DIR) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- "$3") ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$(_tabor_choices "$text")" -- "$3") ;;
  esac
}

_tabor() {
  local _tabor_program=$1 command=${COMP_WORDS[1]-} word=$2 before=$3
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ] || [ "$command" = help ]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_tabor_help "")" -- "$word")
    return
  fi
  # bash takes '=' for a word of its own: --quality=live is three, and --set wires.count=4 four.
  local key=
  if [ "$word" = "=" ]; then
    word="" key=$before
  elif [ "$before" = "=" ]; then
    key=${COMP_WORDS[COMP_CWORD - 2]} before=$key
  fi
  if [[ $key == [a-z]*.* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_tabor_values "$key")" -- "$word")
    return
  fi
  if [[ $before == -* ]] && _tabor_complete_value "$command" "$before" "$word"; then return; fi
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_tabor_help "$command")" -- "$word")
    return
  fi
  compopt -o filenames -o default
  mapfile -t COMPREPLY < <(compgen -W "$(_tabor_presets)" -- "$word"; compgen -f -- "$word")
}

complete -F _tabor tabor
