#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Completion in zsh and fish: commands, options, values that the help lists, presets and kits.
source=${1:?folder of the sources}
. "$(dirname "$0")/../support/host_checks.sh"
needs zsh zsh
needs fish fish
PATH=$(dirname "$TABOR"):$PATH
export HOME=$private PATH

# fish LINE: what completes it, a word a line.
in_fish() { fish -c "source '$source/host/completion.fish'; complete -C '$1'" 2>&1 | cut -f 1; }
same "fish: a command" render "$(in_fish 'tabor rend')"
check "fish: commands with what they do" grep -q '^render.Play drums' <(fish -c "source '$source/host/completion.fish'; complete -C 'tabor rend'")
same "fish: an option" "--quality" "$(in_fish 'tabor render --qual')"
check "fish: values" grep -qx draft <(in_fish 'tabor render --quality dr')
check "fish: presets" grep -qx tom-12 <(in_fish 'tabor show tom')
check "fish: kits" grep -qx standard <(in_fish 'tabor render --kit stan')

# zsh on a terminal of its own: each tab completes a word; waits until the line is whole.
mkdir completions
cp "$source/host/completion.zsh" completions/_tabor
cat >type.zsh <<'END'
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PS1=; fpath=($PWD/completions \$fpath); autoload -Uz compinit; compinit -u -D; setopt no_beep; print R-E-A-D-Y"
said=
more() { local piece; while zpty -r -t shell piece; do said+=$piece; done }
for i in {1..600}; do more; [[ $said == *R-E-A-D-Y*R-E-A-D-Y* ]] && break; sleep 0.1; done
said=
zpty -w -n shell $1
for i in {1..600}; do more; plain=${said//$'\e'\[[0-9;?]#[a-zA-Z]/}; plain=${plain//?$'\b'/}; [[ $plain == *$2* ]] && exit 0; sleep 0.1; done
print -r -- $plain | cat -v
exit 1
END
in_zsh() { check "zsh: $2" zsh -f -o extendedglob type.zsh "$1" "$2"; }
in_zsh $'tabor rend\t --qual\t dra\t' draft
in_zsh $'tabor render --kit stan\t' standard
in_zsh $'tabor show timp\t' timpani-26
finish
