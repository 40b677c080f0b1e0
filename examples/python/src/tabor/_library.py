# SPDX-License-Identifier: MIT
"""Finds and opens the shared library, and turns its errors into exceptions."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Callable, Iterator

from ._header import ffi  # made when the package is built


class Error(ValueError):
    """What the library refused: the first offending key, its value and what is allowed."""

    def __init__(self, error: Any) -> None:
        super().__init__(text(error.message))
        self.key = text(error.key)
        self.value = text(error.value)
        self.minimum = error.minimum
        self.maximum = error.maximum


def text(characters: Any) -> str:
    """A C string as a Python one."""
    return ffi.string(characters).decode("utf-8")


def _file_name() -> str:
    number = ffi.integer_const("TABOR_VERSION_MAJOR") or ffi.integer_const("TABOR_VERSION_MINOR")
    if sys.platform == "darwin":
        return f"libtabor.{number}.dylib"
    return "tabor.dll" if sys.platform == "win32" else f"libtabor.so.{number}"


def _candidates() -> Iterator[str]:
    """Where the library may be, likeliest first."""
    named = os.environ.get("TABOR_LIBRARY")
    if named:
        yield named
        return
    yield str(Path(sys.prefix) / "lib" / _file_name())
    yield _file_name()
    try:
        said = subprocess.run(["pkg-config", "--variable=libdir", "tabor"],
                              capture_output=True, text=True, check=True)
        yield str(Path(said.stdout.strip()) / _file_name())
    except (OSError, subprocess.CalledProcessError):
        pass


def _open() -> Any:
    refused = []
    for candidate in _candidates():
        try:
            return ffi.dlopen(candidate)
        except OSError as error:
            refused.append(str(error))
    raise ImportError("the shared library of tabor was not found: build it with "
                      "-DBUILD_SHARED_LIBS=ON and install it, or set TABOR_LIBRARY to the file; "
                      + "; ".join(refused))


lib = _open()


def version() -> str:
    """The version of the library."""
    return text(lib.tabor_version())


def _check_layout() -> None:
    definition = ffi.new("TaborDrumDef *")
    lib.tabor_drum_def_default(definition)
    if definition.struct_size != ffi.sizeof("TaborDrumDef"):
        raise ImportError(f"the library, version {version()}, is not of the header that this package "
                          "was made from: install the package again")


_check_layout()


def check(function: Callable[..., int], *arguments: Any) -> None:
    """Calls a set-up function, whose last parameter is the error; raises Error if it refuses."""
    error = ffi.new("TaborError *")
    if function(*arguments, error) != lib.TABOR_OK:
        raise Error(error)
