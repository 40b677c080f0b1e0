#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python package's own tests (python/tests), out of the source tree and on the shared library. They compare it with
# the program.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"

python=$(find_python cffi,numpy,pytest) || skip "needs python3 python3-cffi python3-numpy python3-pytest"

import_package "$python"
quietly "$python" -W error -m pytest -q -c "$SOURCE/pyproject.toml" --rootdir "$SOURCE" "$SOURCE/python/tests"
grep -E '^[0-9]+ passed' log
if grep -q skipped log; then complain "$(cat log)"; fi
