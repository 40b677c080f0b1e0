# SPDX-License-Identifier: MIT
"""Makes the module tabor._kit_maps from the program's maps by name, so that both always say the same.

    python build_kit_maps.py KIT_MAP.C _KIT_MAPS.PY
"""

import re
import sys
from pathlib import Path

#: Numbers of TaborKitStroke; 0: as the kit plays the note.
STROKES = {"AS_IN_KIT": 0, "RIMSHOT": 2, "CROSS_STICK": 3, "RIM": 4}


def maps(source: str) -> "dict[str, dict[int, tuple[int, int]]]":
    """Of each map the General MIDI note and the stroke that its notes stand for."""
    found = {}
    for name, rows in re.findall(r"static const KitMapNote (\w+)\[\] = \{\n(.*?)\n\};", source, flags=re.DOTALL):
        notes = re.findall(r"^  \{(\d+), (\d+), (\w+)\},", rows, flags=re.MULTILINE)
        if len(notes) != rows.count("{"):
            raise ValueError(f"{name}: a row is not understood")
        found[name] = {int(note): (int(general), STROKES[stroke]) for note, general, stroke in notes}
    return found


def main() -> None:
    """Reads the source and writes the module."""
    source, module = map(Path, sys.argv[1:])
    found = maps(source.read_text(encoding="utf-8"))
    lines = [f"    {name!r}: {notes!r},\n" for name, notes in found.items()]
    module.write_text("from typing import Dict, Tuple\n\nMAPS: Dict[str, Dict[int, Tuple[int, int]]] = {\n" +
                      "".join(lines) + "}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
