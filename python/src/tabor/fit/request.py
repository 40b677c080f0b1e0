# SPDX-License-Identifier: MIT
"""The file that says what is recorded and what is known of the drum."""

from __future__ import annotations

import glob
import math
import os
import re
import sys
from typing import Any, Dict, List, Mapping, NamedTuple, Sequence, Tuple, Union

from .._library import Error
from ..definition import Definition
from .parameters import Space, space_of
from .recordings import Stroke, read_recording

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib  # type: ignore[import-not-found,unused-ignore]

_INCH = 0.0254  # [m]
_MIL = 2.54e-5  # thousandth of an inch [m]
# Polyester film [DuPont2003]: density, and Young's modulus over 1 - nu^2, of which the presets' heads are, too.
_FILM_DENSITY, _FILM_MODULUS = 1390.0, 4.17e9  # [kg/m3], [Pa]
_COATING = 0.14  # of a coated head [kg/m2]

_TABLES: Dict[str, Tuple[str, ...]] = {
    "drum": ("name", "comment", "license", "preset", "diameter", "depth", "snares"),
    "batter": ("plies", "mil", "coated"),
    "resonant": ("plies", "mil", "coated"),
    "known": (), "range": (),
    "strokes": (), "predict": (),
    "recording": ("normalized",),
}


class Request(NamedTuple):
    """What is asked for."""

    name: str  #: of the preset that is written
    space: Space  #: what is looked for
    mics: Tuple[str, ...]
    strokes: Tuple[Stroke, ...]  #: to fit, from the softest to the hardest
    kept: Tuple[Stroke, ...]  #: to predict
    are_levels_known: bool  #: whether levels of strokes tell their speeds

    @property
    def rate(self) -> float:
        """Of all recordings [Hz]."""
        return self.strokes[0].recordings[0].rate


def _table(read: Mapping[str, Any], path: str, name: str) -> Dict[str, Any]:
    table = read.get(name, {})
    if not isinstance(table, dict):
        raise Error(f"{path}: {name} is a table: [{name}]")
    allowed = _TABLES[name]
    for key in table:
        if allowed and key not in allowed:
            raise Error(f"{path}: [{name}] has no {key}; allowed: {', '.join(allowed)}")
    return dict(table)


def _positive(path: str, name: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 < value < math.inf:
        raise Error(f"{path}: {name} = {value!r}; allowed: a positive number")
    return float(value)


def _truth(path: str, name: str, value: Any) -> bool:
    if not isinstance(value, bool):
        raise Error(f"{path}: {name} = {value!r}; allowed: true, false")
    return value


def _known(path: str, table: Mapping[str, Any], ranges: Mapping[str, Any]) -> Dict[str, Union[str, float]]:
    for key, value in table.items():
        if isinstance(value, bool) or not isinstance(value, (str, int, float)):
            raise Error(f"{path}: [known] {key} = {value!r}; allowed: a number or a text, the key in quotes: \"room.kind\" = \"studio\"")
        if key in ranges:
            raise Error(f"{path}: {key} is in [known] and in [range]; allowed: one of them")
    return dict(table)


def _head(path: str, name: str, table: Mapping[str, Any]) -> Dict[str, float]:
    """Parameters of a head of so many plies, which slide on each other, each so thick."""
    if "mil" not in table:
        raise Error(f"{path}: [{name}] lacks mil, the thickness of a ply in thousandths of an inch")
    plies = _positive(path, f"{name}.plies", table.get("plies", 1))
    ply = _positive(path, f"{name}.mil", table["mil"]) * _MIL
    coating = _COATING if _truth(path, f"{name}.coated", table.get("coated", False)) else 0.0
    stiff = ply + coating / _FILM_DENSITY  # a coating is as stiff as film of its mass
    return {f"{name}.surface_density": plies * ply * _FILM_DENSITY + coating,
            f"{name}.bending_stiffness": ((plies - 1) * ply**3 + stiff**3) * _FILM_MODULUS / 12,
            f"{name}.stretch_stiffness": ((plies - 1) * ply + stiff) * _FILM_MODULUS}


def _natural(name: str) -> List[Union[int, str]]:
    """Sorts stroke-2 before stroke-10."""
    return [int(part) if part.isdecimal() else part for part in re.split("([0-9]+)", name)]


def _files(path: str, folder: str, table: str, mic: str, given: Union[str, Sequence[str]]) -> List[str]:
    """A list of files, or those that fit a pattern, in order of their names."""
    if isinstance(given, str):
        found = sorted(glob.glob(os.path.join(folder, given)), key=_natural)
        if not found:
            raise Error(f"{path}: [{table}] {mic} = {given!r}: there is no such file")
        return found
    if not isinstance(given, list) or not given or not all(isinstance(one, str) for one in given):
        raise Error(f"{path}: [{table}] {mic} = {given!r}; allowed: names of files in a list, or one with a * for several")
    found = [os.path.join(folder, one) for one in given]
    for one in found:
        if not os.path.exists(one):
            raise Error(f"{path}: [{table}] {mic}: there is no file {one}")
    return found


def _strokes(path: str, folder: str, name: str, table: Mapping[str, Any], mics: Tuple[str, ...]) -> Tuple[Stroke, ...]:
    files = {mic: _files(path, folder, name, mic, table[mic]) for mic in table}
    if files and tuple(files) != mics:
        raise Error(f"{path}: [{name}] has the microphones {', '.join(files)}, [strokes] {', '.join(mics)}")
    counts = {mic: len(some) for mic, some in files.items()}
    if len(set(counts.values())) > 1:
        raise Error(f"{path}: [{name}] has {' and '.join(f'{count} files of {mic}' for mic, count in counts.items())}: "
                    "each stroke has one of each microphone")
    return tuple(Stroke(tuple(read_recording(one) for one in stroke)) for stroke in zip(*files.values()))


def _base(path: str, drum: Mapping[str, Any], heads: Mapping[str, Mapping[str, Any]]) -> Definition:
    base = Definition(str(drum.get("preset", "tom-12")))
    snares = drum.get("snares", "none")
    if snares not in ("on", "off", "none"):
        raise Error(f"{path}: drum.snares = {snares!r}; allowed: on, off, none")
    if (snares == "none") != (not base["wires.count"]):
        raise Error(f"{path}: drum.snares = {snares!r}, but the preset {drum.get('preset', 'tom-12')} has "
                    f"{base['wires.count']} wires; name another drum.preset")
    if snares == "off":
        base["wires.strainer"] = 0
    for key, name, part in (("diameter", "shell.radius", 0.5), ("depth", "shell.depth", 1.0)):
        if key in drum:
            base[name] = part * _INCH * _positive(path, f"drum.{key}", drum[key])
    base["drum.comment"], base["drum.license"] = "Fitted to recordings", ""
    for key in ("name", "comment", "license"):
        if key in drum:
            base[f"drum.{key}"] = str(drum[key])
    if not re.fullmatch(r"[\w.-]+", str(base["drum.name"])) or str(base["drum.name"]).startswith("."):
        raise Error(f"{path}: drum.name = {str(base['drum.name'])!r}, of which a file's name is made; allowed: letters, digits, - and _")
    for head, table in heads.items():
        if table:
            base.update(_head(path, head, table))
    return base


def _ranges(path: str, table: Mapping[str, Any]) -> Dict[str, Tuple[float, float]]:
    ranges = {}
    for key, value in table.items():
        if not isinstance(value, list) or len(value) != 2:
            raise Error(f"{path}: [range] {key} = {value!r}; allowed: the least and the greatest value, [1000, 3000]")
        ranges[key] = (_positive(path, f"[range] {key}", value[0]), _positive(path, f"[range] {key}", value[1]))
    return ranges


def read_request(path: Union[str, os.PathLike[str]]) -> Request:
    """Reads a request and its recordings.

    Parameters
    ----------
    path : str or path
        A TOML file, as docs/fit.md describes it. Names of recordings are relative to its folder.

    Returns
    -------
    Request
        What is asked for.

    Raises
    ------
    Error
        The file or a recording cannot be read, or something in it is not allowed.
    """
    name, folder = os.fspath(path), os.path.dirname(os.fspath(path))
    try:
        with open(path, "rb") as file:
            read = tomllib.load(file)
    except UnicodeDecodeError:
        raise Error(f"{name} is no text in UTF-8") from None
    except (OSError, ValueError) as wrong:
        raise Error(f"{name}: {getattr(wrong, 'strerror', None) or wrong}") from None
    for table in read:
        if table not in _TABLES:
            raise Error(f"{name}: there is no table [{table}]; allowed: {', '.join(_TABLES)}")
    tables = {table: _table(read, name, table) for table in _TABLES}
    base = _base(name, tables["drum"], {head: tables[head] for head in ("batter", "resonant")})
    known = _known(name, tables["known"], tables["range"])
    base.update(known)
    normalized = _truth(name, "recording.normalized", tables["recording"].get("normalized", False))
    mics = tuple(tables["strokes"])
    if not mics:
        raise Error(f"{name}: [strokes] names no recordings; needed: a microphone and its files, top = \"stroke-*.wav\"")
    for mic in mics:
        if mic not in base.mics:
            raise Error(f"{name}: [strokes] {mic}: the drum has no such microphone; it has {', '.join(base.mics)}")
    strokes = _strokes(name, folder, "strokes", tables["strokes"], mics)
    kept = _strokes(name, folder, "predict", tables["predict"], mics)
    if not normalized:
        strokes = tuple(sorted(strokes, key=lambda stroke: float(stroke.peaks()[0])))
    space = space_of(base, known, _ranges(name, tables["range"]), len(strokes), not normalized)
    rates = {one.rate: one.name for stroke in (*strokes, *kept) for one in stroke.recordings}
    if len(rates) > 1:
        raise Error(f"{name}: the files have different sample rates: {', '.join(f'{file} {rate:g} Hz' for rate, file in rates.items())}")
    return Request(str(base["drum.name"]), space, mics, strokes, kept, not normalized)
