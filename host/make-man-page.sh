#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes the program's man page: a template whose line @COMMANDS@ becomes the commands with their
# options, made from what the program's --help says.
#
# make-man-page.sh PROGRAM TEMPLATE OUTPUT
set -eu
program=$1 template=$2 output=$3

# Help of one command, from standard input, as mdoc: its usage, its summary, a line an option, and
# notes, which keep their lines.
describe_command() {
  awk '
    function line(text) {
      gsub(/\\/, "\\e", text)
      gsub(/-/, "\\-", text)
      print (text ~ /^[.\047]/ ? "\\&" : "") text
    }
    function option(text,   flags, rest, words, count, i, item) {
      flags = text
      sub(/^ +/, "", flags)
      rest = flags
      sub(/^(-[a-zA-Z], )?--[a-z0-9-]+( [^ ]+)? */, "", rest)
      flags = substr(flags, 1, length(flags) - length(rest))
      count = split(flags, words, /[ ,]+/)
      item = ".It"
      for (i = 1; i <= count; i++) {
        if (words[i] ~ /^-/) item = item (i > 1 ? " ," : "") " Fl " substr(words[i], 2)
        else if (words[i] != "") item = item " Ar " words[i]
      }
      print item
      line(rest)
    }
    function begin(kind) {
      if (part == kind) return
      if (part == "options") print ".El"
      if (kind == "options") print ".Bl -tag -width Ds"
      if (kind == "notes") print ".Bd -literal -offset 2n"
      part = kind
    }
    NR == 1 { sub(/^Usage: tabor /, ""); sub(/ \[OPTION\]\.\.\.$/, ""); print ".Ss " $0; next }
    part == "notes" { line($0); next }
    /^ +(-[a-zA-Z], )?--[a-z0-9-]+/ { begin("options"); option($0); next }
    /^$/ { next }
    part == "options" { begin("notes"); line($0); next }
    { line($0) }
    END { if (part == "options") print ".El"; if (part == "notes") print ".Ed" }'
}

commands=$("$program" --help | sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p')
if [ -z "$commands" ]; then echo "make-man-page.sh: '$program --help' lists no commands" >&2; exit 1; fi
while IFS= read -r text; do
  case $text in
    @COMMANDS@) for command in $commands; do "$program" "$command" --help | describe_command; done ;;
    *) printf '%s\n' "$text" ;;
  esac
done <"$template" >"$output.new"
mv "$output.new" "$output"
