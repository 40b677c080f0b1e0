#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python package's own tests (python/tests), out of the source tree and on the shared library. They compare it with
# the program. The archive of its sources has all that they include; test_python_wheel builds it.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"

python=$(find_python cffi,cmaes,matplotlib,numpy,pytest,scipy,soundfile,threadpoolctl) ||
  skip "needs python3 python3-cffi python3-cmaes python3-matplotlib python3-numpy python3-pytest python3-scipy python3-soundfile python3-threadpoolctl"

import_package "$python"
# pyparsing, of matplotlib, warns of itself where warnings are errors.
quietly "$python" -W error -W ignore:::pyparsing -m pytest -q -c "$SOURCE/pyproject.toml" --rootdir "$SOURCE" "$SOURCE/python/tests"
grep -E '^[0-9]+ passed' log
if grep -q skipped log; then complain "$(cat log)"; fi

# A drum that is simulated and fitted; what was found is used again.
recovered() { quietly "$python" "$SOURCE/tools/recover-drums" "$scratch/drums" --toms 1 --snares 0 --rounds 30; }
recovered
grep -q '^batter.tension .* determined$' log || complain "$(cat log)"
stat -c %y drums/tom-0/result.json >before
recovered
stat -c %y drums/tom-0/result.json | cmp -s - before || complain "a drum was fitted again"

has_python_tools || { skip_part "the archive of sources: $no_python_tools"; exit 0; }
make_sdist "$scratch"
mkdir archive && tar -xzf tabor-*.tar.gz --strip-components 1 -C archive
for file in archive/engine/src/*/*.c archive/host/*/*.c; do
  grep -q "${file##*/host/}" "$SOURCE/host/song_events.cmake" || [[ $file == */engine/* ]] || continue
  quietly "$CC" -fsyntax-only -std=c11 -w -Iarchive/host -Iarchive/engine/src -Iarchive/engine/include "$file"
done
