# SPDX-License-Identifier: MIT
"""What a drum is: presets, parameters, definitions."""

from __future__ import annotations

import math
from numbers import Integral
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple, Union

from ._library import check, ffi, lib, text

Value = Union[float, int, str]


class Preset(NamedTuple):
    """A built-in preset."""

    name: str
    comment: str


class Parameter(NamedTuple):
    """A row of the table of parameters."""

    id: int
    section: str  #: "batter", or "mic." where a name follows
    key: str
    unit: str  #: "" for a pure number
    minimum: float  #: NaN where the value is not a number
    maximum: float
    default: float  #: of a choice its index in choices; NaN for text
    choices: Tuple[str, ...]  #: empty unless it is a choice
    logarithmic: bool  #: better moved in ratios
    live: bool  #: can change while the drum rings
    text: str  #: what it is


def presets() -> List[Preset]:
    """The built-in presets."""
    rows = (lib.tabor_preset(i) for i in range(lib.tabor_preset_count()))
    return [Preset(text(row.name), text(row.comment)) for row in rows]


def _parameter(row: Any) -> Parameter:
    choices = tuple(text(row.choices).split("|")) if row.choices else ()
    return Parameter(row.id, text(row.section), text(row.key), text(row.unit), row.minimum, row.maximum,
                     row.fallback, choices, row.logarithmic, row.live, text(row.text))


def parameters() -> List[Parameter]:
    """All parameters of drums."""
    return [_parameter(lib.tabor_parameter(i)) for i in range(lib.tabor_parameter_count())]


class Definition:
    """The parameters of one drum, by the keys of its preset file.

    drum = Definition("snare-14x5.5", {"batter.tension": 4000})
    drum["wires.strainer"] = 0.5

    Without a preset everything has its default. Wrong keys and values raise Error.
    """

    def __init__(self, preset: Optional[str] = None,
                 changes: Optional[Mapping[str, Value]] = None) -> None:
        self.c = ffi.new("TaborDrumDef *")  #: the C struct
        if preset is None:
            lib.tabor_drum_def_default(self.c)
        else:
            check(lib.tabor_drum_def_preset, self.c, preset.encode())
        self.update(changes or {})

    def __setitem__(self, key: str, value: Value) -> None:
        written = value if isinstance(value, str) else _written(value)
        check(lib.tabor_drum_def_set, self.c, key.encode(), written.encode())

    def __getitem__(self, key: str) -> Value:
        size = lib.TABOR_TEXT_SIZE
        written = ffi.new("char[]", size)
        check(lib.tabor_drum_def_get, self.c, key.encode(), written, size)
        return _read(key, text(written))

    def __iter__(self) -> Iterator[str]:
        size = 2 * lib.TABOR_NAME_SIZE
        key = ffi.new("char[]", size)
        index = 0
        while lib.tabor_drum_def_key(self.c, index, key, size):
            yield text(key)
            index += 1

    def update(self, changes: Mapping[str, Value]) -> None:
        """Sets several parameters, all or, if one is refused, none."""
        before = self.copy().c
        try:
            for key, value in changes.items():
                self[key] = value
        except Exception:
            self.c[0] = before[0]
            raise

    def copy(self) -> Definition:
        """Another drum of the same parameters."""
        other = Definition.__new__(Definition)
        other.c = ffi.new("TaborDrumDef *", self.c[0])
        return other

    def as_dict(self) -> Dict[str, Value]:
        """Every key with its value."""
        return {key: self[key] for key in self}

    def validate(self) -> None:
        """Raises Error for the first parameter that does not fit the others."""
        check(lib.tabor_drum_def_validate, self.c)

    def tune(self) -> None:
        """Validates, and gives each head with a pitch the tension that it takes. Models do this, too."""
        check(lib.tabor_drum_def_tune, self.c)

    @property
    def mics(self) -> List[str]:
        """Names of the microphones, the usual one first."""
        return [text(self.c.mic[i].name) for i in range(self.c.mic_count)]

    @property
    def strikers(self) -> List[str]:
        """Names of the strikers, the usual one first."""
        return [text(self.c.striker[i].name) for i in range(self.c.striker_count)]


def _written(value: Union[float, int]) -> str:
    return str(int(value)) if isinstance(value, Integral) else repr(float(value))


def _read(key: str, written: str) -> Value:
    """What the text of a parameter says; NaN for a wire's value that follows [wires]."""
    row = lib.tabor_parameter_find(key.encode())
    if row.type == lib.TABOR_TYPE_WHOLE:
        return int(written)
    if row.type != lib.TABOR_TYPE_NUMBER:
        return written
    return float(written) if written else math.nan
