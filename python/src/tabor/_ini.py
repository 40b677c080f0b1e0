# SPDX-License-Identifier: MIT
"""Lines of preset and kit files."""

from __future__ import annotations

from typing import Iterator, Optional, Tuple

from ._library import Error


def pairs(ini: str) -> Iterator[Tuple[str, Optional[str], str]]:
    """Section, key and value of each line that has one; without a key where a section begins."""
    section = ""
    for number, line in enumerate(ini.splitlines(), 1):
        words = line.strip().lstrip("\ufeff")
        if words.startswith(";"):
            continue
        words = words.split(" ;", 1)[0].split("\t;", 1)[0].strip()
        key, equals, value = words.partition("=")
        if words.startswith("[") and words.endswith("]"):
            section = words[1:-1].strip()
            yield section, None, ""
        elif equals and section:
            yield section, key.strip(), value.strip()
        elif words:
            raise Error(f"line {number} is neither [section] nor key = value: {line!r}", "value", "", words)
