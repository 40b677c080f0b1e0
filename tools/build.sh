# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the commands beside it: builds one of CMakePresets.json's presets, and says something
# only while there is something to do.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# What was compiled before, in this tree or in another one, is not compiled again where there is ccache.
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER="${CMAKE_C_COMPILER_LAUNCHER-ccache}" CCACHE_DIR="${CCACHE_DIR-$HOME/.cache/ccache}"
  export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1
fi
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)

# build PRESET TARGET [CMAKE-OPTION...]
build() {
  local preset=$1 target=$2 folder="$root/build/$1"
  shift 2
  mkdir -p "$folder"
  local log="$folder/build.log"
  if [ ! -e "$folder/CMakeCache.txt" ]; then echo "Building build/$preset ..." >&2; fi
  if ! (cd "$root" && cmake --preset "$preset" "$@" &&
    cmake --build "$folder" --target "$target" --parallel "$jobs") >"$log" 2>&1; then
    cat "$log" >&2
    echo "The build of preset $preset failed; the lines above are in $log" >&2
    return 1
  fi
}
