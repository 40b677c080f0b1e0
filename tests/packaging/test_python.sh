#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python package, out of the source tree and on the shared library: its own tests (python/tests), compared with the
# program, and its examples.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$SOURCE/tests/support/find_python.sh"

python=$(find_python cffi,numpy,pytest) || skip "needs python3 python3-cffi python3-numpy python3-pytest"

cp -r "$SOURCE/python/src" package
quietly "$python" "$SOURCE/python/build_header.py" "$SOURCE/engine/include/tabor/tabor.h" package/tabor/_header.py
cp -L "$SHARED_BUILD/engine/libtabor.so" package/tabor/
export PYTHONPATH=$PWD/package PYTHONDONTWRITEBYTECODE=1
quietly "$python" -W error -m pytest -q -c "$SOURCE/pyproject.toml" --rootdir "$SOURCE" "$SOURCE/python/tests"
grep -E '^[0-9]+ passed' log
if grep -q skipped log; then complain "$(cat log)"; fi

if "$python" -c 'import matplotlib' 2>/dev/null; then
  quietly "$python" "$SOURCE/examples/python/tension_sweep.py" --preset frame-drum --steps 3 -o sweep.png
  [ "$(head -c 4 sweep.png | tail -c 3)" = PNG ] || complain "the sweep draws nothing"
else
  skip_part "the examples' pictures: needs python3-matplotlib"
fi
