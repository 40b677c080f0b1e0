#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What a release gives away, each from its file into an empty folder with an empty environment, up to a first sound in one
# step; says how many seconds each takes. The Debian packages' first start is test_packages_in_root, the sources' is
# test_first_page_in_root, the npm package's test_npm. Takes a quarter of an hour.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"
needs git git
needs universal-ctags ctags
has_python_tools || skip "$no_python_tools"
needs gcc-mingw-w64-x86-64-posix x86_64-w64-mingw32-gcc-posix
needs wine wine
needs unzip unzip
[ -e "$SOURCE/build/windows-libraries/lib/pkgconfig/cairo-win32-font.pc" ] || skip "tools/setup --windows has not built the libraries for Windows"
export WINEPREFIX=$scratch/prefix WINEDEBUG=-all
version=$("$TABOR" --version | cut -d ' ' -f 2)

# Two clones in different folders make the same bytes.
for clone in one a-folder-with-a-longer-name; do
  committed_clone $clone
  mkdir -p $clone/build
  for part in plugins python web-tools windows-libraries; do ln -sfn "$SOURCE/build/$part" "$clone/build/$part"; done
done
for clone in one a-folder-with-a-longer-name; do
  quietly $clone/tools/release --trial --only "one-file,debian,plugins,windows,wheel${SITE:+,site}" "$version" "$scratch/of-$clone"
done
diff -r of-one of-a-folder-with-a-longer-name || complain "two clones give other bytes"
echo "$(grep -c . of-one/SHA256SUMS) files, the same bytes from two clones"

# first_sound NAME COMMAND...: alone in a folder of its own, with nothing in the environment but PATH.
first_sound() {
  local name=$1 began=$SECONDS
  shift
  mkdir -p "start/$name"
  (cd "start/$name" && quietly env -i PATH=/usr/bin:/bin HOME="$scratch/start/$name" WINEPREFIX="$WINEPREFIX" WINEDEBUG=-all "$@")
  echo "$name: $((SECONDS - began)) s"
}
sounds() { [ "$("$INSPECT" peak "$1")" != 0 ] || complain "$1 is silent"; }

first_sound one-file sh -c "tar -xzf '$scratch/of-one/tabor-$version-one-file.tar.gz' --strip-components 1 && $CC -O2 minimal.c tabor.c -lm -o minimal && ./minimal"

tar -xzf "of-one/tabor-$version-plugins-linux-$(uname -m).tar.gz"
plugins=$scratch/tabor-$version-plugins-linux-$(uname -m)
first_sound clap "$STATIC_BUILD/tests/test_clap_render" "$TABOR" "$plugins/tabor.clap" songs 1
first_sound lv2 "$STATIC_BUILD/tests/test_lv2_render" "$TABOR" "$plugins/tabor.lv2/tabor.so" songs 1
first_sound vst3 sh -c "'$STATIC_BUILD/tests/vst3_host' '$plugins/Tabor.vst3' Tabor 100 9600 512 >sound"
[ "$(tr -d '\0' <start/vst3/sound | wc -c)" -gt 0 ] || complain "the VST3 plugin is silent"

unzip -q "of-one/tabor-$version-windows-x86_64.zip"
windows=$scratch/tabor-$version-windows-x86_64
first_sound windows wine "$windows/tabor.exe" render -q -o strike.wav
sounds start/windows/strike.wav
if [ -e "$SOURCE/build/windows/tests/vst3_host.exe" ]; then
  first_sound windows-vst3 sh -c "wine '$SOURCE/build/windows/tests/vst3_host.exe' 'Z:$windows/Tabor.vst3' Tabor 100 9600 512 >sound"
  cmp start/vst3/sound start/windows-vst3/sound || complain "the VST3 plugin for Windows sounds otherwise"
else
  skip_part "the VST3 plugin for Windows: tools/check-windows builds its host"
fi

"$python_tools/environment/bin/python" -m venv empty
first_sound wheel sh -c "'$scratch/empty/bin/pip' install --no-index --find-links '$python_tools/wheels' '$scratch'/of-one/pypi/*.whl &&
  '$scratch/empty/bin/python' -c \"import tabor; sound = tabor.render('snare-14x5.5'); assert sound.any()\""
