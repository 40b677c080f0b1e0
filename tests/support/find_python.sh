# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the tests that run Python.

# find_python MODULE,...: prints the name of the first Python that has all of these modules.
find_python() {
  local candidate
  for candidate in python3 /usr/bin/python3 "${SOURCE-}/build/python/environment/bin/python3"; do
    if "$candidate" -c "import $1" 2>/dev/null; then
      echo "$candidate"
      return
    fi
  done
  return 1
}
