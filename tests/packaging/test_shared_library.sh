#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The shared library gives exactly the functions of its headers, needs nothing but the C library and
# libm, and before 1.0 is called after the minor version.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"

library=$SHARED_BUILD/engine/libtabor.so
header=$SOURCE/engine/include/tabor/tabor.h
needed=$(readelf -d "$library" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p')
strange=$(grep -vE '^(libc|libm|ld-linux-[a-z0-9-]+)\.so' <<<"$needed" || true)
if [ -n "$strange" ]; then complain "libtabor needs: $strange"; fi

nm -D --defined-only "$library" | awk '{ print $3 }' | sort >given
cat "$(dirname "$header")"/*.h | tr '\n' ' ' | grep -oE 'TABOR_API [^;(]*\(' | grep -oE 'tabor_[a-z0-9_]+' | sort >promised
grep -qx tabor_drum_process promised
diff promised given || complain "the headers (<) and the library (>) differ"

version() { sed -nE "s/^#define TABOR_VERSION_$1 ([0-9]+).*/\1/p" "$header"; }
number=$(version MAJOR)
if [ "$number" = 0 ]; then number=$(version MINOR); fi
soname=$(readelf -d "$library" | sed -nE 's/.*\(SONAME\).*\[(.*)\]/\1/p')
[ "$soname" = "libtabor.so.$number" ] || complain "the library is called $soname"
