# SPDX-License-Identifier: MIT
"""Opens the library and turns its errors into exceptions."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any, Callable, Dict, Optional, Sequence

from ._header import ffi as _ffi  # made from tabor.h when the package is built

ffi: Any = _ffi


class Error(ValueError):
    """What the library refused.

    Attributes
    ----------
    key : str
        The first offending key, as ``"batter.tension"``; ``""`` if there is none.
    value : str
        Its value as text.
    minimum, maximum : float
        The allowed range; NaN where no range applies.
    status : str
        ``"argument"``, ``"key"``, ``"name"``, ``"value"``, ``"range"``, ``"full"``, ``"numerics"``, ``"state"``,
        ``"limit"`` or ``"cancelled"``.
    line, column : int or None
        Of a text that was read: the line, and the byte of it where the error begins, from 1.
    index : int or None
        In `render_takes`, the place of the drum among those asked for.
    """

    line: Optional[int] = None
    column: Optional[int] = None
    index: Optional[int] = None

    def __init__(self, message: str, status: str = "", key: str = "", value: str = "",
                 minimum: float = float("nan"), maximum: float = float("nan")) -> None:
        super().__init__(message)
        self.status = status
        self.key = key
        self.value = value
        self.minimum = minimum
        self.maximum = maximum

    def __str__(self) -> str:
        return str(self.args[0])


class UnknownNameError(Error, KeyError):
    """No parameter, preset, striker or microphone is called so; also a `KeyError`."""


def text(characters: Any) -> str:
    """A C string as a Python one."""
    return str(ffi.string(characters).decode("utf-8"))


def encoded(string: str, what: str) -> bytes:
    """A Python string for C, which must not have a NUL in it."""
    if not isinstance(string, str):
        raise TypeError(f"a {what} is a string, not {string!r}")
    if "\0" in string:
        raise Error(f"a {what} has a NUL character in it: {string!r}", "value")
    return string.encode("utf-8")


def _beside(library: str) -> str:
    """A library of the package."""
    ending = {"darwin": ".dylib", "win32": ".dll"}.get(sys.platform, ".so")
    return str(Path(__file__).with_name(library + ending))


def _path() -> str:
    """The library: that of the package, unless the environment names another one."""
    return os.environ.get("TABOR_LIBRARY") or _beside("libtabor")


def _open(path: str) -> Any:
    try:
        return ffi.dlopen(path)
    except OSError as error:
        raise ImportError(f"the library of the package tabor cannot be opened: {error}", name="tabor",
                          path=path) from error


lib: Any = _open(_path())
#: What MIDI files do: host/kit/song_events.h.
midi_lib: Any = _open(_beside("libtabor-midi"))


def version() -> str:
    """The version of the library.

    Returns
    -------
    str
        As ``"0.2.0"``, or ``"0.2.0-dev"`` before its release.
    """
    return text(lib.tabor_version())


def _check_layout() -> None:
    definition = ffi.new("TaborDrumDef *")
    lib.tabor_drum_def_default(definition)
    if definition.struct_size != ffi.sizeof("TaborDrumDef"):
        raise ImportError(f"the library {_path()}, version {version()}, is not of the header that this package "
                          "was made from", name="tabor", path=_path())


_check_layout()


def check(function: Callable[..., int], *arguments: Any) -> None:
    """Calls a set-up function, whose last parameter is the error; raises what it refuses."""
    error = ffi.new("TaborError *")
    status = function(*arguments, error)
    if status == lib.TABOR_OK:
        return
    message = text(error.message)
    if status == lib.TABOR_ERROR_MEMORY:
        raise MemoryError(message)
    is_unknown = status in (lib.TABOR_ERROR_KEY, lib.TABOR_ERROR_NAME)
    name = str(ffi.string(ffi.cast("TaborStatus", status))).rpartition("_")[2].lower()
    refused = (UnknownNameError if is_unknown else Error)(message, name, text(error.key), text(error.value),
                                                          error.minimum, error.maximum)
    if error.line:
        refused.line, refused.column = error.line, error.column
    raise refused


def read_ini(function: Callable[..., int], thing: Any, ini: bytes, name: str) -> None:
    """Reads the text of a preset or kit file into a struct; an Error begins with the file's name, unless it is "", and the line."""
    try:
        check(function, thing, ini, len(ini))
    except Error as error:
        where = [f"{name}:{error.line}" if name else f"line {error.line}"] if error.line else [name] * bool(name)
        error.args = (": ".join([*where, str(error)]),)
        raise


def written_ini(function: Callable[..., int], thing: Any) -> str:
    """The text of a preset or kit file, as people edit it."""
    length = ffi.new("size_t *")
    check(function, thing, lib.TABOR_TEXT_EDIT, ffi.NULL, 0, length)
    written = ffi.new("char[]", length[0] + 1)
    check(function, thing, lib.TABOR_TEXT_EDIT, written, length[0] + 1, ffi.NULL)
    return text(written)


def saved_state(thing: Any, size: Callable[..., int], save: Callable[..., None]) -> bytes:
    """The bytes that a function of the library writes of a drum's, a kit's or a room's state."""
    state = ffi.new("char[]", size(thing))
    save(thing, state)
    return bytes(ffi.buffer(state))


def index_of(names: Sequence[str], name: str, what: str) -> int:
    """The place of a name in a list of strikers or microphones."""
    try:
        return list(names).index(name)
    except ValueError:
        raise UnknownNameError(f"no {what} is called {name!r}; there are {', '.join(names)}", "name", what,
                               str(name)) from None


def choice_of(choices: Sequence[str], name: str, what: str) -> int:
    """The place of a word in a list of allowed ones."""
    if name not in choices:
        raise Error(f"unknown {what} {name!r}; there are {', '.join(choices)}", "value", what, str(name))
    return list(choices).index(name)


def fields(struct: str, names: Sequence[str], read: Callable[..., None], thing: Any) -> Dict[str, Any]:
    """The members of these names in a struct, which a function of the library fills."""
    filled = ffi.new(struct + " *")
    read(thing, filled)
    return {name: getattr(filled, name) for name in names}
