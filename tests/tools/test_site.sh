#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/site makes one site of all pages, in which no link leads nowhere, sounds play, and nothing is loaded from elsewhere.
#
# test_site.sh SOURCE-FOLDER
source=$1
. "$(dirname "$0")/../support/host_checks.sh"
. "$(dirname "$0")/../support/find_python.sh"
python=$(find_python sys)
needs python3 "${python:-none}"
needs mkdocs "$source/build/python/environment/bin/mkdocs"

build() { "$python" "$source/tools/site" --program "$TABOR" -o site >"$out" 2>"$err"; }
check "the site is built" build
check "its messages" eval "! grep -q WARNING '$err'"
html=site/html

same "pages that are left out" "" "$(cd "$source" && for page in *.md docs/*.md docs/decisions/*.md; do
  name=${page/README.md/index.md}
  [ -e "$work/$html/${name%.md}.html" ] || echo "$page"
done)"
same "what is loaded from elsewhere" "" "$(grep -rhoE '<(script|link|img|audio|source|iframe)[^>]*(src|href)="?(https?:)?//[^>]*>' $html --include='*.html' |
  grep -v 'rel="canonical"')"
same "a player for each sound" "$(grep -c '^| \[' "$source/docs/listen.md")" "$(grep -o '<audio' $html/docs/listen.html | wc -l)"
for sound in $(grep -oE 'src="sounds/[^"]*' $html/docs/listen.html | cut -d '"' -f 2); do
  same "what $sound is" "fLaC" "$(head -c 4 "$html/docs/$sound")"
done
check "a parameter of a drum" grep -q '<code>pitch</code>' $html/docs/parameters.html
check "a live parameter of a hi-hat" grep -q '<code>opening</code>' $html/docs/parameters.html
check "a command's help" grep -q -- '--midi-file FILE' $html/docs/commands.html

# A link that leads nowhere is found: a copy of the pages, one of them with such a link.
mkdir copy && cp -r "$source"/{docs,examples,engine,presets,kits,tests,tools,web,python,*.md,LICENSE} copy 2>/dev/null
mkdir -p copy/build && ln -s "$source/build/python" copy/build/python
echo '[a heading](kit.md#no-such-heading)' >>copy/docs/faq.md
"$python" copy/tools/site --program "$TABOR" -o other >"$out" 2>"$err"
same "a link to no heading" "1 1" "$? $(grep -c 'no-such-heading' "$err")"

finish
