# SPDX-License-Identifier: MIT
"""Makes the module tabor._header from the C headers, so that both always say the same.

    python build_header.py TABOR.H KIT.H SONG_EVENTS.H _HEADER.PY
"""

import re
import sys
from pathlib import Path

from cffi import FFI


def declarations(header: str) -> str:
    """The part of a header that cffi reads: constants, types and functions."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = text.replace("\\\n", " ")
    constants = re.findall(r"^#define (TABOR_\w+) +(\d+|0x[0-9a-f]+)u?\s*$", text, flags=re.MULTILINE)
    text = re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE)
    text = re.sub(r'extern "C" \{(.*)\}', r"\1", text, flags=re.DOTALL)
    text = re.sub(r"\bTABOR_API\b", "", text)
    return "".join(f"#define {name} {value}\n" for name, value in constants) + text


def main() -> None:
    """Reads the headers and writes the module."""
    *headers, module = map(Path, sys.argv[1:])
    builder = FFI()
    builder.set_source("tabor._header", None)
    for header in headers:
        builder.cdef(declarations(header.read_text(encoding="utf-8")))
    builder.emit_python_code(str(module))


if __name__ == "__main__":
    main()
