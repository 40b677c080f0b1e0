#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tabor.dll for Windows as programs use it: it needs nothing but Windows; CMake's package gives it to a program that mingw
# builds; the header compiles for Microsoft's target in C and C++, and a program without a C runtime, which lld-link makes,
# plays. Under wine both have this machine's bits.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
needs gcc-mingw-w64-x86-64-posix x86_64-w64-mingw32-gcc-posix
needs wine wine
needs clang-14 clang-14
needs lld-14 lld-link-14
export WINEPREFIX=$scratch/prefix WINEDEBUG=-all

windows=(-DCMAKE_TOOLCHAIN_FILE="$SOURCE/cmake/mingw-w64.cmake" -DCMAKE_BUILD_TYPE=Release)
quietly "$CMAKE" -S "$SOURCE" -B library "${windows[@]}" -DCMAKE_INSTALL_PREFIX="$scratch/sdk" -DBUILD_SHARED_LIBS=ON \
  -DTABOR_INSTALL=ON -DTABOR_BUILD_TESTS=OFF -DTABOR_BUILD_PROGRAM=OFF -DTABOR_BUILD_LV2=OFF -DTABOR_BUILD_CLAP=OFF -DTABOR_BUILD_VST3=OFF
quietly "$CMAKE" --build library --parallel 2
quietly "$CMAKE" --install library
for file in bin/tabor.dll lib/tabor.lib include/tabor/tabor.h lib/cmake/tabor/tabor-config.cmake; do
  [ -s "sdk/$file" ] || complain "there is no $file"
done
imports=$(x86_64-w64-mingw32-objdump -p sdk/bin/tabor.dll | sed -n 's/^\tDLL Name: //p' | sort | tr '\n' ' ')
[ "$imports" = "KERNEL32.dll msvcrt.dll " ] || complain "tabor.dll needs $imports"

# ---- a program of mingw's ----

mkdir program
cp "$SOURCE/examples/minimal.c" program
cat >program/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.22)
project(program LANGUAGES C)
find_package(tabor REQUIRED)
add_executable(program minimal.c)
target_link_libraries(program PRIVATE Tabor::tabor)
END
# The toolchain looks for packages among its own libraries alone.
quietly "$CMAKE" -S program -B built "${windows[@]}" -Dtabor_DIR="$scratch/sdk/lib/cmake/tabor" -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=BOTH
quietly "$CMAKE" --build built
cp sdk/bin/tabor.dll built
quietly "$CC" -std=c11 -I"$SOURCE/engine/include" program/minimal.c "$STATIC_BUILD/engine/libtabor.a" -lm -o minimal
wine built/program.exe </dev/null 2>log | tr -d '\r' >there || complain "mingw's program: $(cat log)"
./minimal >here
cmp here there || complain "mingw's program says $(cat there), not $(cat here)"

# ---- Microsoft's target ----

msvc=(clang-14 --target=x86_64-pc-windows-msvc -ffreestanding -O2 -Wall -Wextra -Werror -DTABOR_SHARED -Isdk/include)
for header in tabor kit; do
  echo "#include <tabor/$header.h>" >$header.c
  quietly "${msvc[@]}" -std=c11 -fsyntax-only $header.c
  quietly "${msvc[@]}" -x c++ -std=c++17 -fsyntax-only $header.c
done
quietly "$CC" -std=c11 -I"$SOURCE/engine/include" "$SOURCE/tests/support/windows_bare.c" "$STATIC_BUILD/engine/libtabor.a" -lm -o hash
quietly "${msvc[@]}" -std=c11 -DHASH="$(./hash)" -c "$SOURCE/tests/support/windows_bare.c" -o bare.obj
quietly lld-link-14 /entry:start /subsystem:console /nodefaultlib /out:built/bare.exe bare.obj sdk/lib/tabor.lib \
  "$(x86_64-w64-mingw32-gcc-posix -print-file-name=libkernel32.a)"
status=0
wine built/bare.exe >log 2>&1 </dev/null || status=$?
[ $status = 0 ] || complain "the program without a C runtime ends with status $status, and not with the bits $(./hash)"
