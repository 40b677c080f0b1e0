#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# cpack makes three Debian packages, and one of the plugins of each format that is built. Each has its own files and
# says what it needs; together, unpacked into an empty folder, they are a program that renders and a library that can be
# built against.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
needs dpkg dpkg-deb
needs dpkg-dev dpkg-shlibdeps
needs gzip gzip

quietly "$(dirname "$CMAKE")/cpack" --config "$SHARED_BUILD/CPackConfig.cmake" -G DEB -B "$scratch/packages"
field() { dpkg-deb --field packages/"$1"_*.deb "$2"; }
files_of() { dpkg-deb --fsys-tarfile packages/"$1"_*.deb | tar -t | grep -v '/$' | sed 's/^\.//' | sort; }

version=$("$TABOR" --version | cut -d ' ' -f 2)
number=${version%%-*} debian=${version/-/\~} # of 0.2.0-dev 0.2.0 and 0.2.0~dev
soname=$(readelf -d "$SHARED_BUILD/engine/libtabor.so" | sed -nE 's/.*\(SONAME\).*libtabor\.so\.(.*)\]/\1/p')
names=("libtabor$soname" libtabor-dev tabor)
if [ -d "$SHARED_BUILD/lv2" ]; then names+=(tabor-lv2); else skip_part "the LV2 plugins' package: needs lv2-dev"; fi
if [ -d "$SHARED_BUILD/clap" ]; then
  names+=(tabor-clap)
else
  skip_part "the CLAP plugins' package: there are no CLAP headers (tools/setup --plugins brings them)"
fi
if [ -d "$SHARED_BUILD/vst3" ]; then
  names+=(tabor-vst3)
else
  skip_part "the VST3 plugins' package: there are no sources of these (tools/setup --plugins brings them)"
fi
[ "$(find packages -maxdepth 1 -name '*.deb' | wc -l)" = ${#names[@]} ] || complain "not these packages: $(ls packages)"

# has PACKAGE PATTERN...: files that match; the pattern stands for a whole path.
has() {
  local package=$1 pattern
  shift
  files_of "$package" >files
  for pattern in "$@"; do
    grep -qxE "$pattern" files || complain "$package lacks $pattern"
  done
}
library='/usr/lib/[^/]*/'
has "libtabor$soname" "${library}libtabor\.so\.$soname" "${library}libtabor\.so\.$number"
has libtabor-dev "${library}libtabor\.so" /usr/include/tabor/tabor.h "${library}pkgconfig/tabor.pc" \
  "${library}cmake/tabor/tabor-config.cmake" /usr/share/doc/tabor/docs/embedding.md
has tabor /usr/bin/tabor /usr/share/man/man1/tabor.1.gz /usr/share/bash-completion/completions/tabor \
  /usr/share/applications/tabor.desktop /usr/share/metainfo/tabor.metainfo.xml /usr/share/icons/hicolor/scalable/apps/tabor.svg \
  /usr/share/tabor/presets/snare-14x5.5.ini /usr/share/tabor/kits/standard.ini /usr/share/doc/tabor/README.md

bundle=/usr/lib/lv2/tabor.lv2 contents=/usr/lib/vst3/Tabor\\.vst3/Contents
for package in "${names[@]}"; do
  case $package in
    tabor-lv2)
      has tabor-lv2 $bundle/tabor.so $bundle/manifest.ttl $bundle/tabor.ttl $bundle/presets.ttl
      if [ -e "$SHARED_BUILD/lv2/tabor.lv2/tabor_ui.so" ]; then has tabor-lv2 $bundle/tabor_ui.so; fi
      ;;
    tabor-clap) has tabor-clap /usr/lib/clap/tabor.clap ;;
    tabor-vst3)
      has tabor-vst3 "$contents/[^/]*-linux/Tabor\.so" "$contents/Resources/moduleinfo\.json" \
        "$contents/Resources/licenses\.txt"
      dpkg-deb --fsys-tarfile packages/tabor-vst3_*.deb | tar -xO ./usr/share/doc/tabor-vst3/copyright >copyright
      grep -q Steinberg copyright || complain "the copyright of tabor-vst3 does not name the sources of others"
      ;;
    *) continue ;;
  esac
  field "$package" Depends | grep -q libtabor && complain "$package needs the library: $(field "$package" Depends)"
  [ "$(field "$package" Recommends)" = libsndfile1 ] || complain "$package does not recommend libsndfile1"
  field "$package" Depends | grep -q 'libc6' || complain "$package needs nothing: $(field "$package" Depends)"
done

# depends PACKAGE PATTERN...: on each of these.
depends() {
  local package=$1 pattern
  shift
  for pattern in "$@"; do
    field "$package" Depends | tr ',' '\n' | sed 's/^ //' | grep -qxE "$pattern" ||
      complain "$package does not depend on $pattern but: $(field "$package" Depends)"
  done
}
same="libtabor$soname \(= $debian-[0-9]+\)"
depends "libtabor$soname" 'libc6 .*'
depends libtabor-dev "$same"
depends tabor "$same" 'libc6 .*' 'libsndfile1 .*' 'libjansson4 .*'
field "libtabor$soname" Depends | grep -q , && complain "the library needs $(field "libtabor$soname" Depends)"
for name in "${names[@]}"; do
  [ "$(field "$name" Version)" = "$debian-1" ] || complain "$name is of version $(field "$name" Version)"
  has "$name" "/usr/share/doc/$name/copyright" "/usr/share/doc/$name/changelog\.Debian\.gz"
  files_of "$name"
done | sort | uniq -d >twice
if [ -s twice ]; then complain "in two packages: $(cat twice)"; fi

dpkg-deb --ctrl-tarfile packages/"libtabor$soname"_*.deb | tar -xO ./triggers | grep -qx 'activate-noawait ldconfig' ||
  complain "the library does not tell ldconfig"
# With lintian nothing is to be an error.
if command -v lintian >/dev/null; then
  lintian --fail-on error packages/*.deb >"$scratch/lintian" 2>&1 || {
    cat "$scratch/lintian"
    complain "lintian finds errors"
  }
else
  skip_part "what lintian says: needs lintian"
fi

for name in "${names[@]}"; do dpkg-deb --extract packages/"$name"_*.deb root; done
LD_LIBRARY_PATH=$(library_folder root)
export LD_LIBRARY_PATH
root/usr/bin/tabor render tabor --quality draft --duration 0.2 -q -o strike.wav
[ "$("$INSPECT" sound strike.wav)" = "wav pcm24 48000 1 9600" ] || complain "it renders $("$INSPECT" sound strike.wav)"
use_pkg_config root
read -ra flags <<<"$(pkg-config --cflags --libs tabor)"
quietly "$CC" -std=c11 "$SOURCE/examples/minimal.c" "${flags[@]}" -lm -o minimal
./minimal | grep -q 'peak -[0-9.]* dBFS'
