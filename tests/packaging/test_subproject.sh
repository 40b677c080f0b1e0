#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tabor as part of another project, by FetchContent and by add_subdirectory: only the library is built,
# nothing of it is tested or installed, it computes the same however the other project optimises, and the engine is
# optimised where the other project is not.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/count_instructions.sh
. "$SOURCE/tests/support/count_instructions.sh"

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
add_executable(instruction_counts EXCLUDE_FROM_ALL "$SOURCE/tests/support/instruction_counts.c")
target_link_libraries(instruction_counts PRIVATE Tabor::tabor)
install(TARGETS game)
END

# configure BY-FETCHING OPTION...
configure() {
  local fetching=$1
  shift
  quietly "$CMAKE" -S game -B "$builds/$fetching" -DCMAKE_C_COMPILER="$CC" -DBY_FETCHING="$fetching" \
    -DFETCHCONTENT_SOURCE_DIR_TABOR="$SOURCE" "$@"
}

configure OFF
configure ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS_DEBUG=-O1 -DTABOR_DEBUG_ENGINE=ON
for fetching in OFF ON; do
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

# Where the other project has no build type a stroke takes as many instructions as in an optimised build, within 5 %:
# assertions and the flags of a package may differ. Without optimisation it takes many times as many.
released=$STATIC_BUILD/tests/instruction_counts
if [ ! -e "$released" ]; then
  skip_part "the speed of a subproject's engine: needs valgrind"
  exit
fi
watched_presets=snare-14x5.5
quietly "$CMAKE" --build "$builds/OFF" --target instruction_counts --parallel 2
read -r _ counted _ < <(count_instructions "$builds/OFF/instruction_counts")
read -r _ expected _ < <(count_instructions "$released")
echo "Instructions as a subproject: $counted; released: $expected"
awk -v counted="$counted" -v expected="$expected" \
  'BEGIN { exit !(counted > 0.95 * expected && counted < 1.05 * expected) }' || complain "the engine is not optimised"
