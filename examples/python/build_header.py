# SPDX-License-Identifier: MIT
"""Makes the module tabor._header from the C header, so that both always say the same.

The header is $TABOR_HEADER, or that of the source tree which this folder is part of, or the one that
pkg-config knows.
"""

import os
import re
import subprocess
from pathlib import Path

from cffi import FFI


def find_header() -> Path:
    """The path of tabor.h."""
    named = os.environ.get("TABOR_HEADER")
    in_tree = Path(__file__).resolve().parents[2] / "engine/include/tabor/tabor.h"
    if named:
        return Path(named)
    if in_tree.exists():
        return in_tree
    try:
        said = subprocess.run(["pkg-config", "--variable=includedir", "tabor"],
                              capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        raise SystemExit("tabor.h was not found: install libtabor, or set TABOR_HEADER") from None
    return Path(said.stdout.strip()) / "tabor/tabor.h"


def declarations(header: str) -> str:
    """The part of a header that cffi reads: constants, types and functions."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = text.replace("\\\n", " ")
    constants = re.findall(r"^#define (TABOR_\w+) +(\d+)\s*$", text, flags=re.MULTILINE)
    text = re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE)
    text = re.sub(r'extern "C" \{(.*)\}', r"\1", text, flags=re.DOTALL)
    text = re.sub(r"\bTABOR_API\b", "", text)
    return "".join(f"#define {name} {value}\n" for name, value in constants) + text


builder = FFI()
builder.set_source("tabor._header", None)
builder.cdef(declarations(find_header().read_text(encoding="utf-8")))

if __name__ == "__main__":
    builder.compile(verbose=True)
