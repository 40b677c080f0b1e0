#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python package installs from the tree into an environment of its own, without a network, and gives
# what the program gives; its sweep draws a picture.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$SOURCE/tests/support/find_python.sh"

python=$(find_python cffi,numpy,setuptools,wheel,venv,ensurepip) ||
  skip "needs python3 python3-cffi python3-numpy python3-setuptools python3-wheel python3-venv"

# pip leaves things where it builds, so it gets a copy.
mkdir -p tree/examples tree/engine
cp -r "$SOURCE/examples/python" tree/examples
cp -r "$SOURCE/engine/include" tree/engine
quietly "$python" -m venv --system-site-packages environment
quietly environment/bin/pip install --no-index --no-build-isolation --no-deps tree/examples/python
rm -r tree

if environment/bin/python -c 'import tabor' 2>message; then
  echo "a libtabor of the system is there: the message for none is not tested"
else
  grep -q 'ImportError: the shared library of tabor was not found.*TABOR_LIBRARY' message ||
    complain "$(cat message)"
fi
TABOR_LIBRARY=$(find "$SHARED_BUILD/engine" -name 'libtabor.so.?')
export TABOR_LIBRARY
quietly environment/bin/python -W error "$SOURCE/tests/packaging/python_checks.py"

if environment/bin/python -c 'import matplotlib' 2>/dev/null; then
  quietly environment/bin/python "$SOURCE/examples/python/tension_sweep.py" --preset frame-drum --steps 3 -o sweep.png
  [ "$(head -c 4 sweep.png | tail -c 3)" = PNG ] || complain "the sweep draws nothing"
else
  skip_part "the sweep's picture: needs python3-matplotlib"
fi
