#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# From a source archive comes a wheel, the same bytes each time, that auditwheel accepts as manylinux. It installs into an empty virtual environment
# without a compiler and without a network, and passes its tests there. mypy takes its types from there.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"

has_python_tools || skip "$no_python_tools"
bin=$python_tools/environment/bin
unset PYTHONPATH TABOR_LIBRARY
export CC PIP_CONFIG_FILE=/dev/null CMAKE_BUILD_PARALLEL_LEVEL=2 PYTHONDONTWRITEBYTECODE=1 SOURCE_DATE_EPOCH=1000000000

make_sdist "$scratch"
for folder in built again; do # pip unpacks the archive into another folder each time
  quietly "$bin/pip" wheel --no-index --no-build-isolation --no-deps -w $folder tabor-*.tar.gz
done
cmp built/*.whl again/*.whl || complain "two builds of the wheel differ"
[[ $(ls built) == tabor-*-py3-none-linux_*.whl ]] || complain "the wheel is called $(ls built)"
PATH=$bin:$PATH quietly "$bin/auditwheel" repair -w repaired built/*.whl
[[ $(ls repaired) == tabor-*-py3-none-manylinux*.whl ]] || complain "the repaired wheel is called $(ls repaired)"
quietly "$bin/twine" check --strict tabor-*.tar.gz repaired/*.whl
echo "$(ls repaired): $(stat -c %s repaired/*.whl) bytes"

# alone COMMAND...: without any program in the path, and with nothing in the environment but the tests' program.
alone() {
  quietly env -i HOME="$scratch" LC_ALL=C PATH=/nonexistent TABOR="$TABOR" PIP_CONFIG_FILE=/dev/null \
    PYTHONDONTWRITEBYTECODE=1 "$@"
}
quietly "$bin/python" -m venv empty
alone empty/bin/pip install --no-index --find-links "$python_tools/wheels" repaired/*.whl
alone empty/bin/python "$SOURCE/examples/python/variations.py" --count 3 --duration 0.1 -o sounds.npy
alone empty/bin/python -c "import numpy; assert numpy.load('sounds.npy').shape == (3, 1, 1, 4800)"
alone empty/bin/pip install --no-index --find-links "$python_tools/wheels" pytest cmaes matplotlib scipy soundfile threadpoolctl
alone empty/bin/python -W error -W ignore:::pyparsing -m pytest -q -c "$SOURCE/pyproject.toml" --rootdir "$SOURCE" "$SOURCE/python/tests"
grep -E '^[0-9]+ passed' log

quietly "$bin/mypy" --strict --cache-dir "$python_tools/types" --python-executable empty/bin/python \
  "$SOURCE"/examples/python/{tutorial,variations,tension_sweep}.py
