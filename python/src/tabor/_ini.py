# SPDX-License-Identifier: MIT
"""Lines of preset and kit files."""

from __future__ import annotations

from typing import Callable, Optional, Set

from ._library import Error


def read_pairs(ini: str, name: str, take: Callable[[str, Optional[str], str], None]) -> None:
    """Gives section, key and value of each line that has one to `take`; without a key where a section begins.

    An Error, of a line or of `take`, begins with the file's name, unless it is empty, and the line's number.
    """
    section = ""
    sections: Set[str] = set()
    for number, line in enumerate(ini.splitlines(), 1):
        words = line.strip().lstrip("\ufeff")
        if words.startswith(";"):
            continue
        words = words.split(" ;", 1)[0].split("\t;", 1)[0].strip()
        key, equals, value = words.partition("=")
        try:
            if words.startswith("[") and words.endswith("]"):
                section = words[1:-1].strip()
                if section in sections:
                    raise Error(f"section [{section}] occurs twice", "value", section)
                sections.add(section)
                take(section, None, "")
            elif equals and section:
                take(section, key.strip(), value.strip())
            elif words:
                raise Error(f"{line!r} is neither [section] nor key = value", "value", "", words)
        except Error as error:
            error.args = (f"{name}:{number}: {error}" if name else f"line {number}: {error}",)
            raise
