#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The installed tree works for a stranger: the README's program is compiled against it by
# find_package(Tabor) and by pkg-config, and both run and print the same.
#
# test_install.sh SOURCE-FOLDER BUILD-FOLDER CMAKE COMPILER
set -euo pipefail
source_dir=$1 build_dir=$2 cmake=$3 compiler=$4

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix

quietly() {
  "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; echo "failed: $*" >&2; exit 1; }
}

quietly "$cmake" --install "$build_dir" --prefix "$prefix"
mkdir "$scratch/strike"
cd "$scratch/strike"
sed -n '/^```c$/,/^```$/p' "$source_dir/README.md" | sed '/^```/d' >strike.c
grep -q tabor_drum_process strike.c

cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.22)
project(Strike C)
find_package(Tabor 0.1 REQUIRED)
add_executable(strike strike.c)
target_link_libraries(strike PRIVATE Tabor::tabor)
END
quietly "$cmake" -S . -B build -DCMAKE_C_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix"
quietly "$cmake" --build build
build/strike >by-cmake

pc=$(find "$prefix" -name tabor.pc)
PKG_CONFIG_PATH=$(dirname "$pc")
export PKG_CONFIG_PATH
read -ra flags <<<"$(pkg-config --cflags --libs tabor)"
quietly "$compiler" -std=c11 -Wall -Wextra -Werror strike.c "${flags[@]}" -o strike
LD_LIBRARY_PATH=$(dirname "$(dirname "$pc")") ./strike >by-pkg-config

cmp by-cmake by-pkg-config
test -s by-cmake
program=$prefix/bin/tabor
if [ -e "$build_dir/tabor" ]; then
  "$program" --version >/dev/null
fi
