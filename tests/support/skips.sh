# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the test scripts: how a test says that it, or a part of it, is skipped, and why. tools/check reads
# the reasons. A reason that ends with "needs PACKAGE..." names the packages of Debian that are missing.

# skip_part REASON: a part of the test is skipped.
skip_part() { echo "SKIPPED: $1"; }

# skip REASON: the whole test is skipped.
skip() {
  skip_part "$1"
  exit 77
}

# needs PACKAGE TOOL...: skips the whole test unless all of these tools are there, which the package has.
needs() {
  local package=$1 tool
  shift
  for tool in "$@"; do
    command -v "$tool" >/dev/null || skip "there is no ${tool##*/}: needs $package"
  done
}
