#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The program and the plugins must not depend on a Fortran runtime, LAPACK or BLAS, also not through other
# libraries. The plugins themselves may depend only on the C library and libm.
#
# test_dependencies.sh PROGRAM [PLUGINS.so]
set -euo pipefail
# shellcheck source=tests/support/skips.sh
. "$(dirname "$0")/../support/skips.sh"
needs libc-bin ldd
status=0

for binary in "$@"; do
  loaded=$(ldd "$binary")
  if ! grep -q 'libc\.so' <<<"$loaded"; then
    echo "ldd does not list what $binary loads: $loaded" >&2
    status=1
  fi
  if grep -iE 'fortran|lapack|blas|atlas|quadmath' <<<"$loaded"; then
    echo "$binary loads the libraries above" >&2
    status=1
  fi
done

if [ $# -gt 1 ]; then
  needed=$(readelf -d "$2" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p')
  if grep -vE '^(libc|libm|ld-linux-[a-z0-9-]+)\.so' <<<"$needed"; then
    echo "$2 needs the libraries above" >&2
    status=1
  fi
fi
exit "$status"
