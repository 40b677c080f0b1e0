#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The man page has every command and every option with its text, as --help says them, and no mistakes
# of form.
#
# test_system_man_page.sh MAN-PAGE
page=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"

# The page's part on one command, with "\-" as "-".
section() {
  awk -v wanted="$1" '/^\.S[sh] / { inside = $1 == ".Ss" && $2 == wanted } inside' "$page" | sed 's/\\-/-/g'
}

commands=0
for command in $("$TABOR" --help | sed -nE 's/^  ([a-z][a-z-]*) .*/\1/p'); do
  commands=$((commands + 1))
  run "$command" --help
  section "$command" >part
  check "$command: summary" grep -qxF -- "$(sed -n 3p "$out")" part
  while IFS= read -r line; do
    names=$(grep -oE '^ +(-[a-zA-Z], )?--[a-z0-9-]+' <<<"$line")
    for name in ${names//,/}; do
      check "$command $name: in the page" grep -qE -- "^\.It .*Fl ${name#-}( |$)" part
    done
    text=$(sed -E 's/^ +(-[a-zA-Z], )?--[a-z0-9-]+( [A-Z=]+)? +//' <<<"$line")
    check "$command ${name}: its text" grep -qxF -- "$text" part
  done < <(grep -E '^ +(-[a-zA-Z], )?--' "$out")
done
holds "several commands" "$commands > 5"
same "nothing is left of the template" "" "$(grep -o '@[A-Z_]*@' "$page")"

if command -v mandoc >/dev/null; then
  same "form" "" "$(mandoc -T lint -W warning "$page")"
else
  skip_part "the page's form: needs mandoc"
fi
finish
