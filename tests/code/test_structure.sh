#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Comments of the engine name their subject first, no line of engine and host is over 100 columns, and what one folder
# owns is named by few others: tools/structure counts all of it.
#
# test_structure.sh SOURCE-FOLDER
set -euo pipefail
source=$1
SOURCE=$source
. "$source/tests/support/find_python.sh"

python=$(find_python json)
"$python" - "$source/tools/structure" <<'END'
import importlib.machinery
import importlib.util
import sys

loader = importlib.machinery.SourceFileLoader("structure", sys.argv[1])
structure = importlib.util.module_from_spec(importlib.util.spec_from_loader("structure", loader))
loader.exec_module(structure)

planted = {"engine/a.c": "/* What a drum is.\n * It sounds. Those of wires do not. */\nint a; /* of a, What */\n"
                         + "/* " + "x" * 100 + " */\n"}
assert len(structure.dangling(planted)) == 2, structure.dangling(planted)
assert len(structure.long_lines(planted)) == 1

# No file but those of today may come to know what a folder owns.
MOST = {"files outside a drum's folder that name a type of heads": 4,
        "files that compute a slot's row from the wires' stride": 5,
        "files that decide by the kind of a slot": 6,
        "files that name a brush, beyond its own": 8}
tree = structure.Tree()
failed = False
for text, count in structure.FIGURES:
    if text in MOST and count(tree) > MOST[text]:
        print(f"{text}: {count(tree)}, {MOST[text]} at most")
        failed = True
for name, line, start in structure.dangling(tree.engine):
    print(f"{name}:{line}: begins without its subject: {start}")
    failed = True
for name, number, line in structure.long_lines(tree.engine) + structure.long_lines(tree.host):
    print(f"{name}:{number}: {len(line)} columns")
    failed = True
sys.exit(failed)
END
