#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the shared library and the program on it in $SHARED_BUILD, as a system's packages have them,
# for the tests that look at these.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"

quietly "$CMAKE" -S "$SOURCE" -B "$SHARED_BUILD" -DCMAKE_C_COMPILER="$CC" -DBUILD_SHARED_LIBS=ON \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_INSTALL_PREFIX=/usr -DTABOR_BUILD_TESTS=OFF
quietly "$CMAKE" --build "$SHARED_BUILD" --parallel 2
