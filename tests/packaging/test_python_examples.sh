#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python examples run and draw, and mypy finds them, and the package, well typed.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"

python=$(find_python cffi,numpy,matplotlib) || skip "needs python3 python3-cffi python3-numpy python3-matplotlib"
examples=$SOURCE/examples/python

import_package "$python"
quietly "$python" "$examples/tension_sweep.py" --preset frame-drum --steps 3 -o sweep.png
[ "$(head -c 4 sweep.png | tail -c 3)" = PNG ] || complain "the sweep draws nothing"
quietly "$python" -W error "$examples/tutorial.py" -o tutorial
[ "$(find tutorial -name '[1-8]-*.png' -size +8k | wc -l)" = 8 ] || complain "lessons without a picture: $(ls -l tutorial)"
quietly "$python" -W error "$examples/variations.py" --count 2 --duration 0.1 --preset tom-12 -o sounds.npy
if grep -q $'\r' log; then complain "a file has the progress that is for terminals"; fi
quietly "$python" -c "import numpy; assert numpy.load('sounds.npy').shape == (2, 1, 1, 4800)"

cat >run_notebook.py <<'END'
import json, sys
import matplotlib
matplotlib.use("Agg")
cells = [cell for cell in json.load(open(sys.argv[1]))["cells"] if cell["cell_type"] == "code"]
assert all(not cell["outputs"] for cell in cells), "outputs are made where it is read"
names = {}
for cell in cells:
    exec("".join(cell["source"]), names)
names["figure"].savefig("figure-4.png")
END
quietly "$python" -W error run_notebook.py "$examples/figure-4.ipynb"
[ "$(find . -maxdepth 1 -name figure-4.png -size +20k)" ] || complain "the notebook draws nothing"
grep -q '^D string, under tension *9 bounces' log || complain "the notebook counts otherwise than docs/validation.md: $(cat log)"

has_python_tools || { skip_part "types of the Python package: $no_python_tools"; exit 0; }
checked() { "$python_tools/environment/bin/mypy" --config-file "$SOURCE/pyproject.toml" --strict --cache-dir "$python_tools/types" "$@"; }
echo 'import tabor; tabor.strike(velocity="loud")' >wrong.py
checked "$examples"/{tutorial,variations,tension_sweep}.py package/tabor wrong.py >log || true
[ "$(grep -c error log)" = 2 ] && grep -q 'wrong.py:1: error: Argument "velocity"' log || complain "$(cat log)"
