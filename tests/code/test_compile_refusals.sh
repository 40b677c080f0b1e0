#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Options and targets whose arithmetic the engine cannot use are refused when it is compiled, by one error each
# (engine/src/math/arithmetic.h).
#
# test_compile_refusals.sh SOURCE-FOLDER COMPILER
set -euo pipefail
source=$1 compiler=$2
# shellcheck source=tests/support/skips.sh
. "$(dirname "$0")/../support/skips.sh"
failures=0

# Sources that recognise NaN, add numbers, read states and have kernels.
files="definition/validate.c math/portable_math.c drum/drum.c kernels/kernels.c"

# compile COMPILER FILE OPTION...
compile() {
  local with=$1 file=$2
  shift 2
  "$with" -x c -std=c11 -fsyntax-only -ffp-contract=off -DTB_KERNELS=kernels -DTB_KERNELS_F=kernelsf \
    -I"$source/engine/include" -I"$source/engine/src" "$@" "$source/engine/src/$file" 2>&1
}

# refuses TEXT COMPILER OPTION...: every file is refused, with an error that contains TEXT and no other error.
refuses() {
  local text=$1 with=$2 file said
  shift 2
  for file in $files; do
    if said=$(compile "$with" "$file" "$@"); then
      echo "FAILED: $with $* compiles $file"
      failures=1
    elif [ "$(grep -c 'error:' <<<"$said")" != 1 ] || ! grep 'error:' <<<"$said" | grep -qF "$text"; then
      echo "FAILED: $with $* says of $file:"
      grep -F 'error:' <<<"$said" | head -n 3
      failures=1
    fi
  done
}

accepts() {
  local with=$1 file said
  shift
  for file in $files; do
    said=$(compile "$with" "$file" "$@") && continue
    printf 'FAILED: %s %s refuses %s:\n%s\n' "$with" "$*" "$file" "$said"
    failures=1
  done
}

# Written so that test_arithmetic.sh does not take these for options of the build.
fast=-ffast-m
fast+=ath
finite=-ffinite-math-o
finite+=nly

compilers=("$compiler")
command -v clang-14 >/dev/null && compilers+=(clang-14)
for with in "${compilers[@]}"; do
  accepts "$with" -O2
  refuses 'fast math' "$with" $fast
  refuses 'fast math' "$with" -O2 $finite
  refuses 'little-endian' "$with" -Wno-builtin-macro-redefined -U__BYTE_ORDER__ '-D__BYTE_ORDER__=__ORDER_BIG_ENDIAN__'
done

# Other targets have their compilers here, but not their C library.
case $("$compiler" -dumpmachine) in
  x86_64*)
    files=math/arithmetic.h
    refuses 'FLT_EVAL_METHOD' "$compiler" -m32 -mno-sse -mfpmath=387
    if command -v clang-14 >/dev/null; then refuses 'SSE2' clang-14 -mno-sse2; fi
    ;;
esac
if command -v aarch64-linux-gnu-gcc >/dev/null; then
  files=kernels/kernels.c
  accepts aarch64-linux-gnu-gcc -O2
  files=math/arithmetic.h
  refuses 'little-endian' aarch64-linux-gnu-gcc -mbig-endian
else
  skip_part "a big-endian target is not tried: needs gcc-aarch64-linux-gnu"
fi
exit "$failures"
