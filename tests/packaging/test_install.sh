#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installed trees work for a stranger: programs in C and C++ are built against the static and against the
# shared library, by find_package and by pkg-config, and all of them render what `tabor render` does.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
examples=$SOURCE/examples

# same_sound WHAT FILE REFERENCE
same_sound() { "$INSPECT" equal "$2" "$3" || complain "$1 renders something else than tabor render"; }

# try_programs WHAT SEQUENCER [STRIKE]: runs the two programs, C and C++.
try_programs() {
  "$2" rhythm.wav tabor >rhythm.csv
  if [ ! -e reference.wav ]; then
    "$TABOR" render tabor --quality live --events rhythm.csv --duration 4.5 --format float -q -o reference.wav
    "$TABOR" render tabor --quality live --duration 1 --format float -q -o strike-reference.wav
  fi
  same_sound "$1, C" rhythm.wav reference.wav
  if [ -z "${3-}" ]; then return; fi
  "$3" strike.wav tabor >strike.txt
  same_sound "$1, C++" strike.wav strike-reference.wav
}

# What the README shows, compiled with no more than it says.
sed -n '/^```c$/,/^```$/p' "$SOURCE/README.md" | sed '/^```/d' >readme.c
grep -q tabor_drum_process readme.c

# A project without a word of C.
mkdir cpp_only
cat >cpp_only/CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.22)
project(Strike CXX)
find_package(Tabor 0.2 REQUIRED)
add_executable(strike $examples/cpp/strike.cpp)
target_compile_features(strike PRIVATE cxx_std_17)
target_link_libraries(strike PRIVATE Tabor::tabor)
END

for kind in static shared; do
  build=STATIC_BUILD
  if [ "$kind" = shared ]; then build=SHARED_BUILD; fi
  install_tree "${!build}" "$scratch/$kind"
  tree=$scratch/$kind

  quietly "$CMAKE" -S "$examples" -B "$kind-examples" -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_CXX_COMPILER="${CXX:-}" -DCMAKE_PREFIX_PATH="$tree" -DCMAKE_INCLUDE_PATH="$SOURCE/build/python/miniaudio"
  quietly "$CMAKE" --build "$kind-examples"
  "$kind-examples/minimal" | grep -q 'peak -[0-9.]* dBFS'
  if [ -x "$kind-examples/game" ]; then
    # 42 collisions in two seconds: balls from 0.4, 0.8 and 1.2 m, which keep 0.7 of their speed.
    "$kind-examples/game" null >game.txt && grep -q '^42 collisions, peak 0\.[0-9]*[1-9]' game.txt || complain "the game, $kind: $(cat game.txt)"
  else
    skip_part "the game: needs miniaudio.h, which tools/setup --python brings"
  fi
  try_programs "find_package, $kind" "$kind-examples/sequencer" "${CXX:+$kind-examples/strike}"

  use_pkg_config "$tree"
  LD_LIBRARY_PATH=$(library_folder "$tree")
  export LD_LIBRARY_PATH
  read -ra flags <<<"$(pkg-config --cflags --libs tabor)"
  strict=(-Wall -Wextra -Wpedantic -Werror)
  quietly "$CC" -std=c11 "${strict[@]}" "$examples/sequencer.c" "${flags[@]}" -o sequencer
  if [ -n "${CXX:-}" ]; then
    quietly "$CXX" -std=c++17 "${strict[@]}" "$examples/cpp/strike.cpp" "${flags[@]}" -o strike
    quietly "$CMAKE" -S cpp_only -B cpp_only/build -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_PREFIX_PATH="$tree"
    quietly "$CMAKE" --build cpp_only/build
    "cpp_only/build/strike" strike.wav tabor >strike.txt
    same_sound "find_package in C++ alone, $kind" strike.wav strike-reference.wav
    rm -r cpp_only/build
  fi
  try_programs "pkg-config, $kind" ./sequencer "${CXX:+./strike}"
  quietly "$CC" -std=c11 "${strict[@]}" readme.c "${flags[@]}" -o readme
  ./readme
  mv stroke.wav "readme-$kind.wav"

  [ "$(pkg-config --modversion tabor)" = "$("$TABOR" --version | cut -d ' ' -f 2)" ] ||
    complain "tabor.pc and the program say different versions"
  unset LD_LIBRARY_PATH
  "$tree/bin/tabor" --version >/dev/null || complain "the installed program, $kind, does not run"
done
cmp readme-static.wav readme-shared.wav
test -s readme-static.wav

# Linking a static library of a shared installation's kind is what Libs.private is for.
read -ra flags <<<"$(pkg-config --static --cflags --libs tabor)"
quietly "$CC" -std=c11 "$examples/sequencer.c" "${flags[@]/#-ltabor/$STATIC_BUILD/engine/libtabor.a}" -o sequencer
try_programs "pkg-config --static" ./sequencer

# Everything that a user looks for is there.
for file in share/man/man1/tabor.1 share/bash-completion/completions/tabor share/tabor/presets/tabor.ini share/tabor/kits/standard.ini \
  share/doc/tabor/README.md share/doc/tabor/docs/presets.md share/doc/tabor/docs/embedding.md \
  share/doc/tabor/examples/minimal.c share/doc/tabor/LICENSE include/tabor/tabor.h; do
  [ -s "static/$file" ] || complain "not installed: $file"
done

# What installed pages show and link to is installed with them.
docs=$(dirname "$(find static -name performance.md)")
for page in "$docs"/*.md; do
  grep -oE '\]\([^):#]+\.(png|svg|json|md)' "$page" | cut -c 3- >links || continue
  while read -r link; do
    [ -e "$docs/$link" ] || complain "${page##*/} links to $link, which is not installed"
  done <links
done

if [ -z "${CXX:-}" ]; then skip_part "programs in C++: needs g++"; fi
