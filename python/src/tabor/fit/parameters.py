# SPDX-License-Identifier: MIT
"""What is looked for, and between which values.

A parameter is looked for as its logarithm, equally likely everywhere between its limits. Some belong to the recording, not
to the drum: microphones, room, speeds of strokes.
"""

from __future__ import annotations

from typing import Dict, Mapping, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from .._library import Error
from ..definition import Definition, parameters

Array = NDArray[np.float64]

SPEED = "speed"  # of the hardest stroke [m/s]
SPEED_RANGE = "speed_range"  # of the hardest stroke over that of the softest
SPEED_POWER = "speed_power"  # speeds are levels, relative to the hardest stroke, to this power

# The first zero of J1: the mode with one nodal diameter of a head of radius 1 has this wave number, in vacuum and in air.
_WAVE_NUMBER = 3.8317
#: Of rooms, where it is not known: each simulated recording has its own [m].
ROOM_SIZES = (3.0, 8.0)

# Limits as factors of the base preset's value.
_HEADS: Dict[str, Tuple[float, float]] = {
    "batter.tension": (0.6, 1.6), "resonant.tension": (0.6, 1.6),
    "batter.surface_density": (0.85, 1.15), "resonant.surface_density": (0.85, 1.15),
    "batter.damping_0": (0.5, 2.0), "resonant.damping_0": (0.5, 2.0),
    "batter.damping_k": (0.5, 2.0), "resonant.damping_k": (0.5, 2.0),
    "strike.radius": (0.4, 2.0), "striker.contact_stiffness": (0.1, 10.0), "striker.mass": (0.6, 1.6),
}
_WIRES: Dict[str, Tuple[float, float]] = {
    "wires.tension": (0.4, 2.5), "wires.mass_per_length": (0.8, 1.25), "wires.rest_spread": (0.4, 2.5),
    "wires.contact_loss": (0.3, 3.0),
}
_ROOM: Dict[str, Tuple[float, float]] = {"room.level": (0.2, 2.0)}
_SPEEDS: Dict[str, Tuple[float, float]] = {SPEED: (3.0, 8.0)}
_POWER: Dict[str, Tuple[float, float]] = {SPEED_POWER: (0.7, 1.2)}
_RANGE: Dict[str, Tuple[float, float]] = {SPEED_RANGE: (2.0, 10.0)}


class Space:
    """Parameters together: vectors of their logarithms stand for drums."""

    def __init__(self, base: Definition, limits: Mapping[str, Tuple[float, float]]) -> None:
        self.base = base
        self.keys = tuple(limits)  #: of a definition, or SPEED, or SPEED_RANGE
        self.low, self.high = np.log(list(limits.values())).T

    def values(self, point: Array) -> Dict[str, float]:
        """What the vector stands for, by key."""
        return {key: float(value) for key, value in zip(self.keys, np.exp(point))}

    def definition(self, point: Array) -> Definition:
        """The drum that the vector stands for."""
        drum = self.base.copy()
        for key, value in self.values(point).items():
            if not key.startswith(SPEED):
                drum[key] = value
        return drum


def _key(base: Definition, key: str) -> str:
    """A key of the usual striker by its full name."""
    head, _, rest = key.partition(".")
    if head != "striker":
        return key
    usual = str(base["strike.striker"]) or base.strikers[0]
    return f"striker.{usual}.{rest}"


def space_of(base: Definition, known: Mapping[str, object], ranges: Mapping[str, Tuple[float, float]],
             strokes: int, are_levels_known: bool = True) -> Space:
    """The parameters of a drum that are looked for.

    Parameters
    ----------
    base : Definition
        The drum as far as it is known.
    known : mapping
        Keys that are not looked for.
    ranges : mapping of str to (float, float)
        Limits in place of the usual ones, in the keys' units.
    strokes : int
        How many there are.
    are_levels_known : bool
        Whether the recordings' levels tell the speeds of strokes apart.

    Returns
    -------
    Space
        What is looked for.

    Raises
    ------
    Error
        A range is upside down.
    """
    usual = {**_HEADS, **(_WIRES if base["wires.count"] else {}), **(_ROOM if base.has_room else {})}
    limits: Dict[str, Tuple[float, float]] = {}
    for key, (low, high) in usual.items():
        key = _key(base, key)
        if key not in known and key in base and float(base[key]) > 0:
            limits[key] = (low * float(base[key]), high * float(base[key]))
    limits.update({**_SPEEDS, **({} if strokes == 1 else _POWER if are_levels_known else _RANGE)})
    limits.update(ranges)
    for key, (low, high) in limits.items():
        if not 0 < low < high:
            raise Error(f"range of {key}: {low:g} to {high:g}; allowed: two positive numbers, the smaller first")
        if not key.startswith(SPEED):
            base.copy({key: low}).copy({key: high}).validate()  # says what is not allowed
    return Space(base, limits)


def derived(base: Definition, values: Mapping[str, Union[float, Array]]) -> Dict[str, Union[float, Array]]:
    """What recordings determine better than the parameters that it follows from.

    Parameters
    ----------
    base : Definition
        The drum as far as it is known.
    values : mapping
        Parameters, by key.

    Returns
    -------
    dict
        Of each head that is looked for: tension over density, the square of the speed of its waves [m2/s2], and its loss at
        the wave number of the mode with one nodal diameter, damping_0 + damping_k k + damping_1 k^2 [1/s].
    """
    found: Dict[str, Union[float, Array]] = {}
    for head in ("batter", "resonant"):
        tension, density = f"{head}.tension", f"{head}.surface_density"
        if tension in values and density in values:
            found[f"{tension}/{density}"] = values[tension] / values[density]
        if f"{head}.damping_0" in values:
            number = _WAVE_NUMBER / float(base["shell.radius"])
            found[f"{head}.loss"] = sum(values.get(f"{head}.damping_{name}", float(base[f"{head}.damping_{name}"])) * number**power
                                        for power, name in enumerate("0k1"))
    return found


def unit_of(key: str) -> str:
    """The unit of a key, or of what follows from several; "" of a pure number."""
    units = {f"{row.section}.{row.key}": row.unit for row in parameters()}
    parts = key.split(".")
    section = f"{parts[0]}." if len(parts) > 2 else parts[0]  # striker.NAME.mass is of the section "striker."
    others = {SPEED: "m/s", "batter.loss": "1/s", "resonant.loss": "1/s"}
    if "/" in key:
        return "m2/s2"
    return others.get(key) or units.get(f"{section}.{parts[-1]}", "")
