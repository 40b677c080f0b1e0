#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The engine is written once for both precisions. Only the templates (*_tmpl.*, and the headers of kernels/ that they
# include) may branch on the precision. Other code takes values and functions from tables indexed by the precision.
#
# test_precision.sh SOURCE-FOLDER
set -euo pipefail
source=$1

# branches FOLDER: lines that compare a precision, or are compiled for one alone.
branches() {
  (cd "$1" && grep -rnE --include='*.[ch]' \
    -e '[=!]=[[:space:]]*TB_IN_(DOUBLE|FLOAT)|TB_IN_(DOUBLE|FLOAT)[[:space:]]*[=!]=' -e 'case TB_IN_(DOUBLE|FLOAT)' \
    -e '\bif \([^)]*(precision[^.a-z_]|SINGLE|TB_REAL_IS_FLOAT)' -e '#[[:space:]]*if.*TB_(FLOAT|REAL_IS_FLOAT)' .) |
    grep -vE '^\./([a-z_]+/)?[a-z_]+_tmpl\.[ch]:|^\./kernels/(real|simd_[a-z_]+)\.h:' || true
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# The check itself, on lines that it must find and lines that it must not.
mkdir "$work/step"
printf '%s\n' 'if (model->precision == TB_IN_FLOAT) return;' 'if (model->precision) return;' '#ifdef TB_FLOAT' \
  '  case TB_IN_DOUBLE: break;' >"$work/step/bad.c"
printf '%s\n' '[TB_IN_DOUBLE] = keep, [TB_IN_FLOAT] = round' 'TABLES[p->precision].project(group);' >"$work/step/good.c"
printf 'if (SINGLE) return;\n' >"$work/step/solve_tmpl.c"
found=$(branches "$work")
if [ "$(grep -c '^./step/bad.c:' <<<"$found")" != 4 ] || [ "$(wc -l <<<"$found")" != 4 ]; then
  echo "of a made-up tree this is said: $found"
  failures=1
fi

found=$(branches "$source/engine/src")
if [ -n "$found" ]; then
  printf 'These lines ask for the precision outside the templates:\n%s\n' "$found"
  failures=1
fi
exit $failures
