#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A sample library in a sampler: sfizz plays every velocity as loud as the model is. Debian has no sfizz;
# the Python package pysfizz brings it along (PYTHON may name the Python that has it).

tests=$(cd "$(dirname "$0")/.." && pwd)
. "$tests/support/host_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$tests/support/find_python.sh"

python=${PYTHON:-$(find_python numpy,pysfizz)} || skip "there is no pysfizz, which is no package of Debian's"
# Short: what is longer than 8192 frames sfizz loads beside playing, and may miss.
"$TABOR" library tabor -o library --velocities 5 --positions 2 --takes 2 --humanize 1 --quality draft \
  --duration 0.1 --json >"$out" || complain "the library"
check "in sfizz" "$python" "$tests/program/library_sampler.py" library tabor <"$out"
finish
