# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the tests that need a clang with the sanitizers of today.

# find_clang: names the newest that is here.
find_clang() {
  local candidate
  for candidate in clang-22 clang-21 clang-20; do
    if command -v "$candidate"; then return; fi
  done
  return 1
}
