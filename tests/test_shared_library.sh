#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The shared library gives exactly the functions of tabor.h, and needs nothing but the C library,
# libm and LAPACK with what that stands on.
#
# test_shared_library.sh SOURCE-FOLDER CMAKE COMPILER
set -euo pipefail
source_dir=$1 cmake=$2 compiler=$3

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
{
  "$cmake" -S "$source_dir" -B "$scratch" -DCMAKE_C_COMPILER="$compiler" -DTABOR_SHARED=ON \
    -DTABOR_BUILD_PROGRAM=OFF -DTABOR_BUILD_TESTS=OFF
  "$cmake" --build "$scratch" --target tabor --parallel 2
} >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; exit 1; }
library=$scratch/engine/libtabor.so

status=0
needed=$(readelf -d "$library" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p')
strange=$(grep -vE '^(libc|libm|ld-linux-[a-z0-9-]+|liblapacke?|libblas|libtmglib|libgfortran|libquadmath|libgcc_s)\.so' \
  <<<"$needed" || true)
if [ -n "$strange" ]; then
  printf 'libtabor needs:\n%s\n' "$strange" >&2
  status=1
fi

nm -D --defined-only "$library" | awk '{ print $3 }' | sort >"$scratch/given"
tr '\n' ' ' <"$source_dir/engine/include/tabor/tabor.h" | grep -oE 'TABOR_API [^;(]*\(' |
  grep -oE 'tabor_[a-z0-9_]+' | sort >"$scratch/promised"
if ! diff "$scratch/promised" "$scratch/given" >"$scratch/difference"; then
  echo "tabor.h (<) and the library (>) differ:" >&2
  cat "$scratch/difference" >&2
  status=1
fi
exit "$status"
