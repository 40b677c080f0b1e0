#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# 41 small MIDI files, right and wrong ones (tests/support/midi_files.py): the program and the Python package, a drum and a
# kit, refuse them in the same words, or play them with the same warnings and the same sound. The page's reader, where it can
# be built, judges them alike.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/python_package.sh
. "$SOURCE/tests/support/python_package.sh"

python=$(find_python cffi,numpy) || skip "needs python3 python3-cffi python3-numpy"

import_package "$python"
mkdir files
quietly "$python" "$SOURCE/tests/support/midi_files.py" files
[ "$(find files -name '*.mid' | wc -l)" -eq 41 ] || complain "there are not 41 files"
quietly "$python" -W error "$SOURCE/tests/support/judge_midi_files.py" files verdicts.json
cat log

# The page's reader, where it can be built.
for tool in emcc em-config node; do
  if ! command -v $tool >/dev/null; then
    skip_part "the page's reader was not compared: there is no $tool: tools/setup --web brings it"
    exit 0
  fi
done
quietly "$SOURCE/tools/web" --build
quietly node "$SOURCE/tests/support/judge_midi_files.mjs" "$SOURCE/build/web/page" files verdicts.json
