#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Does what the README's first page says, command by command, in the folder of a fresh clone, and looks for what each
# promises. It needs what the page needs, and nothing else. Everything in HOME may change.
#
# Not run: what the page mentions within its sentences, tools/check (it runs this), a build by hand (other tests' is
# one), the manual (test_manual) and an installation for everybody. `tabor play` is played without a sound card.
#
# first_page.sh CLONE
set -euo pipefail
export LC_ALL=C
cd "$1"
private=$(mktemp -d)
trap 'rm -rf "$private"' EXIT
log=$private/log

complain() {
  cat "$log" >&2
  echo "FAILED: README: $1" >&2
  exit 1
}

# The lines of the page's indented blocks; what stands between fences is C.
commands() {
  awk '/^```/ { fenced = !fenced }
    /^    / && !fenced { print substr($0, 5) }' README.md
}

# have FILE...: they are there, and not empty.
have() {
  local file
  for file in "$@"; do [ -s "$file" ] || complain "$command: there is no $file"; done
}

# play FILE...: they are sounds in which something rings.
play() {
  local file
  for file in "$@"; do
    [[ $(build/release/tabor analyze "$file") == *[1-9]* ]] || complain "$command: nothing rings in $file"
  done
}

said() { grep -qE -- "$1" "$log" || complain "$command: does not say '$1'"; }

# In this shell, as some commands change its environment.
perform() {
  rm -f ./*.wav # so that those found afterwards are new
  case $1 in
    "tabor play") set -- "$1 --backend null --duration 0.2 --no-ui" ;; # there may be no sound card
    # A dozen strokes: hundreds take minutes.
    "tabor library "*) set -- "$1 --quality draft --velocities 2 --takes 2" ;;
    "tools/plot-trace "*) can_draw || return 0 ;;
  esac
  eval "$1" >"$log" 2>&1 </dev/null || complain "$1: status $?"
}

# What was promised. A command that has no line here is new on the page: say what it promises.
look_for_result() {
  case $1 in
    ./tools/demo) play strike.wav; check_program_in_folder ;;
    "cmake --install "*) check_installed ;;
    "export PATH="*) [ "$(command -v tabor)" = ~/.local/bin/tabor ] || complain "$1: tabor is not found" ;;
    "tabor presets") said '^snare-14x5.5 ' ;;
    "tabor render --help") said '^Usage: tabor render' ;;
    "tabor render"*" -o toms/") play toms/tom-12.wav toms/floor-tom-16.wav ;;
    "tabor render --trace "*) play strike.wav; have strike.csv ;;
    "tabor render"*" -o "*) play "$(sed 's/.* -o \([^ ]*\).*/\1/' <<<"$1")" ;;
    "tabor render") play strike.wav ;;
    "tabor library "*) have snare/snare-14x5.5.sfz; play "$(find snare -name '*.wav' | head -n 1)" ;;
    "tabor modes --json") said '"frequency"' ;;
    "tabor play") ;; # perform has seen that it ends well
    "tabor devices") said . ;;
    "mkdir -p ~/.lv2 "*) check_plugin ;;
    "tabor show "*) have mine.ini ;;
    "tools/plot-trace "*) if can_draw; then have trace.png; fi ;;
    "cc stroke.c "*) have stroke ;;
    ./stroke) play stroke.wav; check_stroke ;;
    *) complain "'$1' is on the page, but tests/packaging/first_page.sh does not know what it promises" ;;
  esac
}

can_draw() { python3 -c 'import numpy, matplotlib' 2>/dev/null; }

check_program_in_folder() {
  local inline
  inline=$(grep -o '`export PATH=[^`]*`' README.md | tr -d '`')
  (eval "$inline" && [ "$(command -v tabor)" = "$PWD/build/release/tabor" ]) || complain "'$inline' does not find tabor"
}

# The program in C plays this stroke at `live`, as `tabor render` does.
check_stroke() {
  local settings="--set room.kind=none --set strike.velocity=3 --set strike.radius=0.05 --set strike.angle=0"
  # shellcheck disable=SC2086 # a list of words
  tabor render snare-14x5.5 --quality live $settings --duration 1 --format float -q -o "$private/stroke.wav"
  cmp <(tail -c 192000 stroke.wav) <(tail -c 192000 "$private/stroke.wav") >"$log" 2>&1 ||
    complain "$command: another sound than that of tabor render"
}

check_installed() {
  ~/.local/bin/tabor --version >"$log" 2>&1 || complain "$command: the program does not run"
  have ~/.local/share/man/man1/tabor.1 ~/.local/share/bash-completion/completions/tabor \
    ~/.local/include/tabor/tabor.h ~/.local/lib/lv2/tabor.lv2/manifest.ttl ~/.local/share/doc/tabor/README.md
}

# Hosts find the copy in the home folder; it can be opened and plays.
check_plugin() {
  local bundle=~/.lv2/tabor.lv2
  have "$bundle"/{tabor.so,manifest.ttl,tabor.ttl,presets.ttl}
  if ! command -v lv2info >/dev/null || ! command -v lv2bench >/dev/null; then
    echo "SKIPPED: opening the plugins of the first page: needs lilv-utils"
    return
  fi
  lv2info urn:tabor:drum >"$log" 2>&1 || complain "$command: hosts do not find the plugin"
  said "$bundle"
  lv2bench -n 4800 urn:tabor:drum >"$log" 2>&1 || complain "$command: the plugin cannot be opened"
  said '^[0-9.]+ '
}

check_links() {
  local link
  grep -oE '\]\([^):#]+\)' README.md | sed 's/^](//; s/)$//' >"$private/links"
  while IFS= read -r link; do
    [ -e "$link" ] || complain "links to $link, which is not there"
  done <"$private/links"
}

awk '/^```$/ { inside = 0 } inside { print } /^```c$/ { inside = 1 }' README.md >stroke.c
grep -qx 'Thirty lines of C:' README.md && [ "$(wc -l <stroke.c)" = 30 ] || complain "the program in C has another length than it says"
commands >"$private/commands"
count=0
while IFS= read -r line; do
  command=$(sed 's/  *# .*//' <<<"$line")
  if [ -z "$command" ]; then continue; fi
  perform "$command"
  look_for_result "$command"
  count=$((count + 1))
done <"$private/commands"
[ "$count" -gt 15 ] || complain "only $count commands were found"
can_draw || echo "SKIPPED: drawing the trace of the first page: needs python3-numpy python3-matplotlib"
check_links
echo "$count commands of the first page do what it says"
