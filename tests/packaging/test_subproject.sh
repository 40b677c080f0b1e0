#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tabor as part of another project, by FetchContent and by add_subdirectory: only the library is built,
# nothing of it is tested or installed, and it computes the same however the other project optimises.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"

# ccache knows again what was compiled in the same folder, not in a new one.
builds=$STATIC_BUILD/subproject
rm -rf "$builds"

mkdir game
cat >game/CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.22)
project(Game LANGUAGES C)
enable_testing()
if(BY_FETCHING)
  include(FetchContent)
  FetchContent_Declare(Tabor URL https://example.invalid/tabor.tar.gz)
  FetchContent_MakeAvailable(Tabor)
else()
  add_subdirectory("$SOURCE" tabor)
endif()
add_executable(game "$SOURCE/examples/sequencer.c")
target_link_libraries(game PRIVATE Tabor::tabor)
install(TARGETS game)
END

for fetching in OFF ON; do
  quietly "$CMAKE" -S game -B "$builds/$fetching" -DCMAKE_C_COMPILER="$CC" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_C_FLAGS_DEBUG=-O1 -DBY_FETCHING=$fetching -DFETCHCONTENT_SOURCE_DIR_TABOR="$SOURCE"
  targets=$("$CMAKE" --build "$builds/$fetching" --target help)
  grep -qw game <<<"$targets" || complain "no targets: $targets"
  if grep -E 'test_|tabor-program|man-page' <<<"$targets"; then complain "more than the library is built"; fi
done
quietly "$CMAKE" --build "$builds/ON" --target game --parallel 2
quietly "$CMAKE" --install "$builds/ON" --prefix "$scratch/prefix"
[ "$(cd prefix && find . -type f)" = ./bin/game ] || complain "more than the game is installed"

prefix/bin/game rhythm.wav tabor >rhythm.csv
"$TABOR" render tabor --quality live --events rhythm.csv --duration 4.5 --format float -q -o reference.wav
"$INSPECT" equal rhythm.wav reference.wav || complain "it renders something else than tabor render"
