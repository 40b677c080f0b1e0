# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the tests that need a recent clang with its sanitizers.

# find_clang: prints the name of the newest installed clang.
find_clang() {
  local candidate
  for candidate in clang-22 clang-21 clang-20; do
    if command -v "$candidate"; then return; fi
  done
  return 1
}
