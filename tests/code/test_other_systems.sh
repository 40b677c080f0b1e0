#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Engine, program and tests compile for Windows and for 64-bit ARM, each source by the options of a build there, and engine and
# plugins for macOS. Nothing is linked or run: that is for tools/check-windows and tools/check-arm.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"

arm=aarch64-linux-gnu-gcc
windows=x86_64-w64-mingw32-gcc-posix

# This system's headers of the libraries that all systems have, apart from its others, and what pkg-config says of them.
collect_headers() {
  local module
  mkdir headers modules
  printf '#include <%s.h>\n' stdarg stddef stdint setjmp cmocka jansson sndfile fftw3 portaudio rtmidi_c >all.c
  # shellcheck disable=SC2046 # a list of options
  "$CC" -M $(pkg-config --cflags cmocka jansson sndfile fftw3 portaudio-2.0 rtmidi) all.c 2>log | tr ' \\' '\n\n' |
    grep -E '/(cmocka|jansson|jansson_config|sndfile|fftw3|portaudio|rtmidi_c)\.h$' | sort -u >found ||
    { cat log >&2; complain "the libraries' headers were not found"; }
  xargs cp -t headers <found
  for module in cmocka jansson sndfile fftw3 portaudio-2.0 rtmidi; do
    printf 'Name: %s\nDescription: headers\nVersion: 1\nCflags: -I%s\n' $module "$PWD/headers" >"modules/$module.pc"
  done
}

least=200 # sources there are
only=-fsyntax-only

# compile NAME OPTION...: each source, with the toolchain of NAME.cmake and further options of CMake.
compile() {
  local name=$1 count
  shift
  echo "set(ENV{PKG_CONFIG_LIBDIR} \"$PWD/modules\")" >>"$name.cmake"
  quietly "$CMAKE" -S "$SOURCE" -B "$name" -G "Unix Makefiles" -DCMAKE_TOOLCHAIN_FILE="$PWD/$name.cmake" \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DTABOR_INSTALL=OFF \
    -DTABOR_BUILD_LV2=OFF -DTABOR_BUILD_VST3=OFF "$@"
  quietly "$CMAKE" --build "$name" --target preset-table
  # A command a line, as CMake writes it; -fsyntax-only leaves the object files out, which zig cannot.
  sed -n 's/^ *"directory": "\(.*\)",$/cd "\1" \&\&/p; s/^ *"command": "\(.*\)",$/\1 '$only'/p' "$name/compile_commands.json" |
    paste -d ' ' - - | sed 's/\\"/"/g; s/\\\\/\\/g' >"$name/commands"
  count=$(wc -l <"$name/commands")
  [ "$count" -ge "$least" ] || complain "$name: only $count sources were found"
  tr '\n' '\0' <"$name/commands" | xargs -0 -n 1 -P 2 bash -c >log 2>&1 || { cat log >&2; complain "sources do not compile for $name"; }
  echo "$count sources compile for $name"
}

needs pkg-config pkg-config
collect_headers

missing=()
if command -v $windows >/dev/null; then
  echo "include(\"$SOURCE/cmake/mingw-w64.cmake\")" >windows.cmake
  # Warnings of its C library's own are let pass.
  compile windows -DCMAKE_C_FLAGS=-Werror=implicit-function-declaration
else
  missing+=(gcc-mingw-w64-x86-64-posix)
fi
if command -v $arm >/dev/null; then
  printf 'set(CMAKE_SYSTEM_%s)\n' "NAME Linux" "PROCESSOR aarch64" >arm.cmake
  echo "set(CMAKE_C_COMPILER $arm)" >>arm.cmake
  compile arm -DTABOR_WARNINGS_AS_ERRORS=ON
else
  missing+=(gcc-aarch64-linux-gnu libc6-dev-arm64-cross)
fi
zig=$(find "$SOURCE/build/python/environment/lib" -path '*/site-packages/ziglang/zig' 2>/dev/null || true)
if [ -n "$zig" ]; then
  printf '#!/bin/sh\nexec %s cc -target aarch64-macos "$@"\n' "$zig" >macos-cc
  chmod +x macos-cc
  export ZIG_GLOBAL_CACHE_DIR=$scratch/zig ZIG_LOCAL_CACHE_DIR=$scratch/zig
  printf 'set(CMAKE_SYSTEM_%s)\n' "NAME Darwin" "PROCESSOR arm64" >macos.cmake
  echo "set(CMAKE_C_COMPILER $PWD/macos-cc)" >>macos.cmake
  # Of this compiler's newest warnings none is an error yet.
  only=""
  compile macos -DTABOR_BUILD_PROGRAM=OFF -DTABOR_BUILD_TESTS=OFF -DCMAKE_C_FLAGS="-Wno-enum-conversion -Wno-enum-float-conversion"
else
  skip_part "compiling for macOS: tools/setup --python brings ziglang, where it can be had"
fi
if [ ${#missing[@]} -gt 0 ]; then skip_part "compiling for another system: needs ${missing[*]}"; fi
