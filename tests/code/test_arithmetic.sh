#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A model has the same bits on every machine only if the compiler must not reorder or fuse arithmetic. This test
# checks that every engine source is compiled with -ffp-contract=off, that no source or flag relaxes arithmetic,
# and that the engine calls no function of libm whose rounding depends on the machine.
#
# test_arithmetic.sh SOURCE-FOLDER BUILD-FOLDER [LIBTABOR.A]
set -euo pipefail
source_dir=$1 build_dir=$2 library=${3-}

# Written with brackets so that this file does not find itself.
freedom='(fast|unsafe|associative|reciprocal|finite)[-](math|only)|-O[f]ast|[-]mfma|FP[_]CONTRACT +(ON|DEFAULT)'
status=0

cd "$source_dir"
if grep -rnE --include='*.c' --include='*.h' --include='*.cmake' --include='*.in' \
  --include=CMakeLists.txt --include=CMakePresets.json --exclude-dir=build --exclude-dir=.git -e "$freedom" .; then
  echo "the lines above loosen the rules of arithmetic" >&2
  status=1
fi

# Of math.h all but what is exact or correctly rounded: sqrt, fabs, fmin, fmax, floor, ceil, fmod and the like.
# Compilers put sincos() and the __*_finite() of old ones in the place of others.
inexact='a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log10|log1p|log2|cbrt|hypot|pow|erfc?|[lt]gamma|j[01n]|y[01n]'
if [ -n "$library" ]; then
  called=$(nm -A -u "$library")
  if ! grep -qE ' memcpy$' <<<"$called"; then # something that it calls for certain
    echo "nm finds no calls in $library" >&2
    status=1
  fi
  if grep -E " U (__)?($inexact)[fl]?(_finite)?$" <<<"$called"; then
    echo "the calls above go to libm, whose last bits differ from machine to machine: see portable_math.h" >&2
    status=1
  fi
fi

commands=$build_dir/compile_commands.json
if [ ! -f "$commands" ]; then
  echo "no $commands: configure with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON" >&2
  exit $((status ? status : 77))
fi
# Of sources compiled more than once, every command counts.
# A path with a blank in it stands in quotes, which JSON writes as \".
engine_commands=$(grep '"command":' "$commands" | grep -E -- ' -c .*/engine/src/[^/]*/[^/]*\.c(\\")?",?$' || true)
if [ -z "$engine_commands" ]; then
  echo "$commands compiles no engine source" >&2
  exit 1
fi
if grep -vF -- ' -ffp-contract=off ' <<<"$engine_commands"; then
  echo "the engine sources above are compiled without -ffp-contract=off" >&2
  status=1
fi
if grep -E -e "$freedom" <<<"$(grep '"command":' "$commands")"; then
  echo "the commands above loosen the rules of arithmetic" >&2
  status=1
fi
exit "$status"
