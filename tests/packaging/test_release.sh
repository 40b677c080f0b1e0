#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/release: what it refuses, and the same bytes from two clones in different folders; the files that say who, what and
# which licence, as their own tools read them.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"
needs git git
needs universal-ctags ctags
export HOME=$scratch

version=$("$TABOR" --version | cut -d ' ' -f 2)
for clone in one a-folder-with-a-longer-name; do committed_clone $clone; done

# refused PATTERN ARGUMENT...: by the first clone; nothing is made.
refused() {
  local pattern=$1 status=0
  shift
  one/tools/release "$@" made >said 2>&1 || status=$?
  [ $status != 0 ] && grep -q -e "$pattern" said && [ ! -e made ] || complain "release $*: expected a refusal with '$pattern': $(cat said)"
}
refused "version '9.9.9': the sources are of $version" 9.9.9
refused "version '$version': a development version is not released" "$version"
refused 'TABOR_IDENTITY_ADDRESS in cmake/TaborIdentity.cmake is empty' "$version"
refused "only 'everything': no such part" --only everything "$version"
one/tools/release "$version" --only >said 2>&1 && complain "--only without a part was taken"
grep -q "only: names of parts are missing" said || complain "--only without a part: $(cat said)"
mkdir precious && echo thesis >precious/thesis.txt
one/tools/release --trial --only source "$version" precious >said 2>&1 && complain "it emptied a folder that is not its own"
grep -q "folder 'precious': it holds something else" said && [ -e precious/thesis.txt ] || complain "another folder: $(cat said)"
echo >>one/NEWS.md
refused 'changes that are not committed: 1 files' "$version"
git -C one checkout --quiet NEWS.md

# An identity that is filled in: a desktop's own tools find nothing to say about its entry and page.
cp -r one named
sed -i -E 's|(IDENTITY_ADDRESS) ""|\1 "someone@example.org"|; s|(IDENTITY_REPOSITORY) ""|\1 "https://example.org/tabor"|
  s|(IDENTITY_ID) "tabor"|\1 "org.example.Tabor"|' named/cmake/TaborIdentity.cmake
named/tools/release "$version" made >said 2>&1 && complain "a development version was released"
grep -q IDENTITY said && complain "an identity that is filled in: $(cat said)"
quietly "$CMAKE" -S named -B configured -DTABOR_BUILD_TESTS=OFF -DTABOR_INSTALL=ON
if command -v appstreamcli >/dev/null; then
  quietly appstreamcli validate --no-net --explain configured/host/org.example.Tabor.metainfo.xml
  grep -q 'https://example.org/tabor' configured/host/org.example.Tabor.metainfo.xml || complain "the page has no address"
else
  skip_part "what appstreamcli says: needs appstream"
fi
if command -v desktop-file-validate >/dev/null; then
  quietly desktop-file-validate configured/host/org.example.Tabor.desktop
  [ ! -s log ] || complain "the menu's entry: $(cat log)"
else
  skip_part "what desktop-file-validate says: needs desktop-file-utils"
fi

for clone in one a-folder-with-a-longer-name; do
  quietly $clone/tools/release --trial --only source,one-file "$version" "$scratch/of-$clone"
done
diff -r of-one of-a-folder-with-a-longer-name || complain "two clones give other bytes"
[ "$(wc -l <of-one/SHA256SUMS)" = 3 ] || complain "not two archives and a list: $(cat of-one/SHA256SUMS)"
(cd of-one && quietly sha256sum --check SHA256SUMS)
tar -xzf "of-one/tabor-$version.tar.gz"
cmp "tabor-$version/README.md" "$SOURCE/README.md" || complain "the sources are others"
tar -xzf "of-one/tabor-$version-one-file.tar.gz"
[ -s "tabor-$version-one-file/tabor.c" ] || complain "one file is missing"

for file in CITATION.cff codemeta.json; do grep -q "$version" "$SOURCE/$file" || complain "$file is of another version"; done
has_python_tools || { skip_part "what reuse says: $no_python_tools"; exit 0; }
if [ -x "$python_tools/environment/bin/reuse" ]; then
  (cd one && quietly "$python_tools/environment/bin/reuse" lint)
else
  skip_part "what reuse says: this Python has no package of it"
fi
