# SPDX-License-Identifier: MIT
"""What a drum is: presets, parameters, definitions."""

from __future__ import annotations

import math
import os
import secrets
import shutil
from numbers import Integral
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple, Union

from ._library import check, choice_of, encoded, ffi, lib, read_ini, text, written_ini

#: A parameter's value: a number, or the word of a choice, or text.
Value = Union[float, int, str]

_HEADS = ("batter", "resonant")


class Preset(NamedTuple):
    """A built-in preset."""

    name: str  #: for `Definition`
    comment: str  #: one line
    category: str  #: such as ``"snare"``


class Parameter(NamedTuple):
    """A row of the table of parameters."""

    section: str  #: ``"batter"``, or ``"mic."`` where a name follows
    key: str  #: ``"tension"``
    unit: str  #: ``"N/m"``; ``""`` for a pure number
    minimum: float  #: NaN where the value is not a number
    maximum: float  #: NaN where the value is not a number
    default: float  #: of a choice its index in `choices`; NaN for text
    choices: Tuple[str, ...]  #: empty unless it is a choice
    logarithmic: bool  #: better moved in equal ratios
    live: bool  #: `change` can change it while the drum rings
    text: str  #: what it is, one line


def presets() -> List[Preset]:
    """The built-in presets.

    Returns
    -------
    list of Preset
        Name, comment and category of each.
    """
    rows = (lib.tabor_preset(i) for i in range(lib.tabor_preset_count()))
    return [Preset(text(row.name), text(row.comment), text(row.category)) for row in rows]


def _parameter(row: Any) -> Parameter:
    choices = tuple(text(row.choices).split("|")) if row.choices else ()
    return Parameter(text(row.section), text(row.key), text(row.unit), row.minimum, row.maximum,
                     row.fallback, choices, bool(row.logarithmic), bool(row.live), text(row.text))


def parameters() -> List[Parameter]:
    """The parameters that drums have, with units, ranges and defaults.

    Returns
    -------
    list of Parameter
        In the order of preset files.
    """
    return [_parameter(lib.tabor_parameter(i)) for i in range(lib.tabor_parameter_count())]


class Definition(Mapping[str, Value]):
    """The parameters of one drum, in SI units, by the keys of preset files.

    It is a mapping, as a `dict` is, whose keys cannot be taken away. Setting a key of a striker or
    microphone that is not there adds it; setting one of the resonant head adds that head.

    Parameters
    ----------
    preset : str, optional
        Name of a built-in preset (see `presets`). Without one, every parameter has its default.
    changes : mapping of str to float, int or str, optional
        Parameters that differ, set in this order.

    Raises
    ------
    UnknownNameError
        No preset or parameter is called so.
    Error
        A value is not allowed; `Error.key` says whose.

    Examples
    --------
    >>> drum = tabor.Definition("snare-14x5.5", {"batter.tension": 4000})
    >>> drum["batter.pitch"] = "A3"
    >>> drum["batter.pitch"]
    220.0
    """

    def __init__(self, preset: Optional[str] = None,
                 changes: Optional[Mapping[str, Value]] = None) -> None:
        self._c = ffi.new("TaborDrumDef *")
        if preset is None:
            lib.tabor_drum_def_default(self._c)
        else:
            check(lib.tabor_drum_def_preset, self._c, encoded(preset, "preset"))
        self.update(changes or {})

    @classmethod
    def _of(cls, c: Any) -> Definition:
        """A definition with the values of a C struct."""
        made = cls.__new__(cls)
        made._c = ffi.new("TaborDrumDef *", c)
        return made

    @classmethod
    def from_ini(cls, ini: str) -> Definition:
        """Reads the text of a preset file, as `tabor show` and `to_ini` write it.

        Parameters
        ----------
        ini : str
            Lines ``[section]`` and ``key = value``, each with a line end; a comment begins with ``;``.

        Returns
        -------
        Definition
            A drum with these parameters; what is not mentioned has its default.

        Raises
        ------
        Error
            A line is not understood, or a value is not allowed.
        """
        return cls._read(ini.encode("utf-8", "surrogatepass"), "")

    @classmethod
    def _read(cls, ini: bytes, name: str) -> Definition:
        made = cls()
        read_ini(lib.tabor_drum_def_read, made._c, ini, name)
        made.validate()
        return made

    @classmethod
    def load(cls, path: Union[str, os.PathLike[str]]) -> Definition:
        """Reads a preset file, as `save` and `tabor show` write it.

        Parameters
        ----------
        path : str or path
            Name of the file.

        Returns
        -------
        Definition
            A drum with these parameters; what is not mentioned has its default.

        Raises
        ------
        OSError
            The file cannot be read.
        Error
            A line is not understood, or a value is not allowed; `Error.line` says which.
        """
        with open(path, "rb") as file:
            return cls._read(file.read(), os.fspath(path))

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes a preset file, which `load` and the program `tabor` read back to an equal definition.

        The file appears complete or not at all: what was there stays until the new one is written.

        Parameters
        ----------
        path : str or path
            Name of the file; it replaces one that is there.

        Raises
        ------
        OSError
            The file cannot be written.
        Error
            A rule between parameters is broken (see `validate`), or a preset file cannot hold one of the texts:
            `Error.key` says which. Nothing is written then.
        """
        self.validate()
        _write_file(os.fspath(path), self.to_ini())

    def to_ini(self) -> str:
        """Writes the text of a preset file.

        Returns
        -------
        str
            Every parameter, in its section, with its unit and meaning as a comment; the program `tabor` and `from_ini`
            read it.

        Raises
        ------
        Error
            A preset file cannot hold one of the texts: `Error.key` says which.
        """
        return written_ini(lib.tabor_drum_def_write, self._c)

    def __setitem__(self, key: str, value: Value) -> None:
        written = value if isinstance(value, str) else _written(value)
        check(lib.tabor_drum_def_set, self._c, encoded(key, "key"), encoded(written, "value"))

    def _written(self, key: str) -> str:
        size = lib.TABOR_TEXT_SIZE
        written = ffi.new("char[]", size)
        check(lib.tabor_drum_def_get, self._c, encoded(key, "key"), written, size)
        return text(written)

    def __getitem__(self, key: str) -> Value:
        return _read(key, self._written(key))

    def __iter__(self) -> Iterator[str]:
        size = 2 * lib.TABOR_NAME_SIZE
        key = ffi.new("char[]", size)
        index = 0
        while lib.tabor_drum_def_key(self._c, index, key, size):
            yield text(key)
            index += 1

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Definition) and self._fingerprint() == other._fingerprint()

    __hash__ = None  # type: ignore[assignment]  # it can change

    def _fingerprint(self) -> Tuple[Tuple[str, str], ...]:
        """All of it, as text, which equal definitions have in common."""
        return tuple((key, self._written(key)) for key in self)

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restored, (self._fingerprint(),)  # for pickle and copy

    def __repr__(self) -> str:
        c = self._c
        parts = [f"{2000 * c.shell.radius:.0f} mm", "2 heads" if "resonant.tension" in self else "1 head"]
        if c.wires.count:
            parts.append(f"{c.wires.count} wire{'s' if c.wires.count > 1 else ''}")
        parts += [f"strikers {', '.join(self.strikers)}", f"mics {', '.join(self.mics)}"]
        return f"<tabor.Definition {self['drum.name']!r}, {', '.join(parts)}>"

    def update(self, changes: Mapping[str, Value]) -> None:
        """Sets several parameters, all of them or, if one is refused, none.

        Parameters
        ----------
        changes : mapping of str to float, int or str
            Keys and values, set in this order.

        Raises
        ------
        Error
            As by ``drum[key] = value``.
        """
        before = self.copy()._c
        try:
            for key, value in changes.items():
                self[key] = value
        except Exception:
            self._c[0] = before[0]
            raise

    def copy(self, changes: Optional[Mapping[str, Value]] = None) -> Definition:
        """Another drum of the same parameters, or of some that differ.

        Parameters
        ----------
        changes : mapping of str to float, int or str, optional
            Parameters of the copy that differ.

        Returns
        -------
        Definition
            The copy.
        """
        other = Definition._of(self._c[0])
        if changes:
            other.update(changes)
        return other

    def validate(self) -> None:
        """Checks the range of every parameter, and the rules between them.

        Raises
        ------
        Error
            For the first parameter that does not fit; `Error.key` says which. Models check this, too.
        """
        check(lib.tabor_drum_def_validate, self._c)

    def tune(self) -> None:
        """Puts tensions in the place of pitches: each head with a pitch gets the tension that gives it.

        Raises
        ------
        Error
            As by `validate`, or if no tension gives the pitch. Models do this, too.
        """
        check(lib.tabor_drum_def_tune, self._c)

    def pitch(self, head: str = "batter") -> float:
        """What a tuner reads at a lug of a head.

        Parameters
        ----------
        head : {"batter", "resonant"}
            The head.

        Returns
        -------
        float
            Frequency [Hz] of the head's lowest mode with one nodal diameter.
        """
        pitch = ffi.new("double *")
        check(lib.tabor_drum_def_pitch, self._c, choice_of(_HEADS, head, "head"), pitch)
        return float(pitch[0])

    @property
    def mics(self) -> Tuple[str, ...]:
        """Names of the microphones; the first is the usual one."""
        return tuple(text(self._c.mic[i].name) for i in range(self._c.mic_count))

    @property
    def strikers(self) -> Tuple[str, ...]:
        """Names of the strikers; the first is the usual one."""
        return tuple(text(self._c.striker[i].name) for i in range(self._c.striker_count))

    @property
    def has_room(self) -> bool:
        """Whether ``room.kind`` is a room, which `render` then adds."""
        return bool(self._c.room.kind != lib.TABOR_ROOM_NONE)


def _restored(fingerprint: Tuple[Tuple[str, str], ...]) -> Definition:
    made = Definition()
    lib.tabor_drum_def_clear(made._c)
    made.update(dict(fingerprint))
    return made


def _write_file(path: str, content: str) -> None:
    """Writes a file beside its place, then puts it there, with the permissions of the one that was there."""
    place = os.path.realpath(path)
    folder, name = os.path.split(place)
    other = os.path.join(folder, f".{name}.{secrets.token_hex(4)}")
    with open(other, "x", encoding="utf-8", newline="\n") as file:
        try:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
            if os.path.exists(place):
                shutil.copymode(place, other)
            os.replace(other, place)
        except BaseException:
            os.unlink(other)
            raise


def _written(value: Union[float, int]) -> str:
    return str(int(value)) if isinstance(value, Integral) else repr(float(value)).removesuffix(".0")


def _read(key: str, written: str) -> Value:
    """What the text of a parameter says; NaN for a wire's value that follows [wires]."""
    row = lib.tabor_parameter_find(key.encode())
    if row.type == lib.TABOR_TYPE_WHOLE:
        return int(written)
    if row.type != lib.TABOR_TYPE_NUMBER:
        return written
    return float(written) if written else math.nan
