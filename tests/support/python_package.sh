# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the tests of the Python package, after embed_checks.sh.
# shellcheck source=tests/support/find_python.sh
. "$(dirname "${BASH_SOURCE[0]}")/find_python.sh"

# What tools/setup --python installs.
python_tools=$SOURCE/build/python

has_python_tools() { cmp -s "$SOURCE/python/requirements.txt" "$python_tools/installed.txt"; }
# shellcheck disable=SC2034 # of the tests
no_python_tools="the packages of python/requirements.txt are not in build/python: run tools/setup --python"

# make_sdist FOLDER: the archive of the package's sources, from a clean clone: it would look through all build folders.
make_sdist() {
  fresh_clone clean
  (cd clean && quietly "$python_tools/environment/bin/python" -c 'import sys; from scikit_build_core.build import build_sdist; build_sdist(sys.argv[1])' "$1")
}

# import_package PYTHON: puts the package, as a wheel has it, where this Python finds it.
import_package() {
  cp -r "$SOURCE/python/src" package
  quietly "$1" "$SOURCE/python/build_header.py" "$SOURCE/engine/include/tabor/"{tabor,kit}.h "$SOURCE/host/kit/song_events.h" \
    package/tabor/_header.py
  cp -L "$SHARED_BUILD/engine/libtabor.so" "$SHARED_BUILD/host/libtabor-midi.so" package/tabor/
  export PYTHONPATH=$PWD/package PYTHONDONTWRITEBYTECODE=1
}
