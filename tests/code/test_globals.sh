#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The library must not have mutable global state: the writable sections of its objects must be empty.
# Constants that hold addresses (.data.rel.ro) become read-only at load time and are allowed.
#
# test_globals.sh LIBTABOR.A
set -euo pipefail
library=$1

writable=$(objdump -h "$library" | awk '
  / file format / { member = $1 }
  $2 ~ /^\.(data|bss|tdata|tbss)(\.|$)/ && $2 !~ /^\.data\.rel\.ro/ && $3 !~ /^0+$/ {
    print member, $2, "0x" $3, "bytes"
  }')
common=$(nm -A "$library" | grep ' C ' || true)

if [ -n "$writable$common" ]; then
  printf '%s\n' "writable data in $library:" "$writable" "$common" >&2
  exit 1
fi
