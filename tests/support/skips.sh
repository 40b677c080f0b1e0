# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the test scripts: reports that a test, or a part of it, is skipped, and why. tools/check reads the
# reasons. A reason that ends with "needs PACKAGE..." names the missing packages of Debian.

# excuse: skips the test if a failure is not its program's fault. jack_server.sh has reasons.
excuse() { :; }

# skip_part REASON: reports that a part of the test is skipped.
skip_part() { echo "SKIPPED: $1"; }

# skip REASON: skips the whole test.
skip() {
  skip_part "$1"
  exit 77
}

# needs PACKAGE TOOL...: skips the whole test unless all of these tools, which the package contains, are installed.
needs() {
  local package=$1 tool
  shift
  for tool in "$@"; do
    command -v "$tool" >/dev/null || skip "there is no ${tool##*/}: needs $package"
  done
}
