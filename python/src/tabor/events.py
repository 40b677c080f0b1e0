# SPDX-License-Identifier: MIT
"""What can happen to a drum, and when."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Sequence, Tuple

from ._library import choice_of, encoded, lib, UnknownNameError
from .model import Model

#: How a stroke can be made.
TECHNIQUES: Tuple[str, ...] = ("normal", "buzz", "rimshot", "cross-stick", "rim", "sweep")


@dataclass(frozen=True)
class Event:
    """Something that happens to a drum; made by `strike` and the other functions of events.

    Use `dataclasses.replace` to have it at another time.
    """

    time: float  #: [s] from the start of the call that plays it; it acts at the nearest sample
    kind: str  #: the name of the function that made it
    fields: Dict[str, Any] = field(default_factory=dict)  #: what else describes it; None: as the definition says


def _event(time: float, kind: str, **values: Any) -> Event:
    if not (math.isfinite(time) and time >= 0):
        raise ValueError(f"{kind}: time {time!r}: allowed: 0 or more")
    for name, value in values.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise ValueError(f"{kind}: {name} {value!r}: allowed: a finite number")
    return Event(float(time), kind, values)


def _with_model(time: float, kind: str, model: Model) -> Event:
    if not isinstance(model, Model):
        raise TypeError(f"{kind}: a Model is needed, not {model!r}")
    return _event(time, kind, model=model)


def strike(time: float = 0.0, velocity: Optional[float] = None, *, radius: Optional[float] = None,
           angle: Optional[float] = None, striker: Optional[str] = None, technique: Optional[str] = None,
           pressure: float = 0.5, id: int = 0) -> Event:
    """A stroke. What is None is as ``[strike]`` of the definition says.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    velocity : float, optional
        Of the tip as it touches [m/s], clamped to 0.01 to 30.
    radius : float, optional
        Distance from the centre [m], clamped to the head.
    angle : float, optional
        Direction [degrees], counter-clockwise from +x seen from above.
    striker : str, optional
        Name of a striker of the definition.
    technique : str, optional
        One of `TECHNIQUES`. A buzz, and a brush's sweep, go on until `release`.
    pressure : float
        Of a buzz or a sweep, 0 to 1.
    id : int
        A number for `press`, `move` and `release`; 0: anonymous.

    Returns
    -------
    Event
    """
    if technique is not None:
        choice_of(TECHNIQUES, technique, "technique")
    return _event(time, "strike", velocity=velocity, radius=radius, angle=angle, striker=striker,
                  technique=technique, value=pressure, id=id)


def press(time: float, pressure: float, *, id: int = 0) -> Event:
    """Presses strikers in play onto the head, which then bounce, or changes their pressure.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    pressure : float
        0 to 1 for 0.3 to 8 N, in equal ratios.
    id : int
        Which striker; 0: all.

    Returns
    -------
    Event
    """
    return _event(time, "press", value=pressure, id=id)


def move(time: float, radius: float, angle: float = 0.0, *, seconds: float = 0.0, id: int = 0) -> Event:
    """Sends sweeping brushes to a place, the shorter way round.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    radius : float
        Distance from the centre [m].
    angle : float
        Direction [degrees].
    seconds : float
        How long it takes [s], 0 to 60; 0: as long as since the last move, 5 to 100 ms.
    id : int
        Which brush; 0: all.

    Returns
    -------
    Event
    """
    return _event(time, "move", radius=radius, angle=angle, value=seconds, id=id)


def damp(time: float, strength: float = 5.0, *, radius: float = 0.0, angle: float = 0.0, id: int = 0) -> Event:
    """Lays a damping hand on the head, until `release`.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    strength : float
        [N s/m], 0 to 100.
    radius : float
        Distance from the centre [m].
    angle : float
        Direction [degrees].
    id : int
        A number for `release`; 0: anonymous.

    Returns
    -------
    Event
    """
    return _event(time, "damp", value=strength, radius=radius, angle=angle, id=id)


def release(time: float, *, id: int = 0) -> Event:
    """Lifts damping hands and brushes, and takes pressed strikers away.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    id : int
        Which; 0: all.

    Returns
    -------
    Event
    """
    return _event(time, "release", id=id)


def change(time: float, key: str, value: float) -> Event:
    """Changes a parameter while the drum rings, smoothly; one whose `Parameter.live` is true.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    key : str
        As ``"wires.strainer"`` or ``"mic.top.gain"``.
    value : float
        In the parameter's unit, clamped to its range.

    Returns
    -------
    Event

    Raises
    ------
    UnknownNameError
        No parameter has this key.
    ValueError
        The parameter is not live: `swap` to another model instead.
    """
    row = lib.tabor_parameter_find(encoded(key, "key"))
    if not row:
        raise UnknownNameError(f"no parameter is called {key!r}", "key", key)
    if not row.live:
        raise ValueError(f"{key} cannot change while the drum rings: swap to another model")
    mic = key.split(".")[1] if key.startswith("mic.") else None
    return _event(time, "change", parameter=row.id, value=float(value), mic=mic)


def swap(time: float, model: Model) -> Event:
    """Changes the drum's model. A drum of the same size, boundary and set of wires rings on.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    model : Model
        Of the same sample rate.

    Returns
    -------
    Event
    """
    return _with_model(time, "swap", model)


def replace(time: float, model: Model) -> Event:
    """Puts another drum, at rest, in the place of this one, which rings out within 30 ms.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    model : Model
        Of the same sample rate.

    Returns
    -------
    Event
    """
    return _with_model(time, "replace", model)


def silence(time: float) -> Event:
    """Fades out what sounds, over 15 ms; changed parameters, ledger and counters go on.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.

    Returns
    -------
    Event
    """
    return _event(time, "silence")


def gain(time: float, factor: float) -> Event:
    """Sets the gain of all outputs.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    factor : float
        0 to 1e6, reached over 5 ms; 1 at first.

    Returns
    -------
    Event
    """
    return _event(time, "gain", value=float(factor))


def reset(time: float) -> Event:
    """Brings the drum to rest at once; changed parameters, ledger and counters start again.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.

    Returns
    -------
    Event
    """
    return _event(time, "reset")


#: The library's type of each kind of event.
TYPES: Dict[str, int] = {
    "strike": lib.TABOR_EVENT_STRIKE, "press": lib.TABOR_EVENT_PRESS, "damp": lib.TABOR_EVENT_DAMP,
    "release": lib.TABOR_EVENT_RELEASE, "change": lib.TABOR_EVENT_PARAMETER, "swap": lib.TABOR_EVENT_SWAP,
    "reset": lib.TABOR_EVENT_RESET, "move": lib.TABOR_EVENT_MOVE, "silence": lib.TABOR_EVENT_SILENCE,
    "gain": lib.TABOR_EVENT_GAIN, "replace": lib.TABOR_EVENT_REPLACE}

#: An event and the frame at which it acts.
Placed = Tuple[int, Event]


def place(events: Sequence[Event], rate: float, frames: int) -> List[Placed]:
    """The events with their frames, in order; ValueError for one that is not among so many frames."""
    placed = [(math.floor(event.time * rate + 0.5), event) for event in events]
    for frame, event in placed:
        if frame >= max(frames, 1):
            raise ValueError(f"{event.kind}: {event.time:g} s is outside of {frames / rate:g} s")
    return sorted(placed, key=lambda pair: pair[0])
