# SPDX-License-Identifier: MIT
"""What can happen to a drum, and when."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from ._library import Error, UnknownNameError, choice_of, encoded, lib
from ._numbers import number, whole
from .model import Model

#: How a stroke can be made.
TECHNIQUES: Tuple[str, ...] = ("normal", "buzz", "rimshot", "cross-stick", "rim", "sweep", "pedal")

_LARGEST_ID = 2**32 - 1


@dataclass(frozen=True, repr=False)
class Event:
    """Something that happens to a drum; made by `strike` and the other functions of events.

    Use `dataclasses.replace` to have it at another time. Its values are checked when it is made.
    """

    time: float  #: [s] from the start of the call that plays it; it acts at the nearest sample
    kind: str  #: the name of the function that made it
    fields: Dict[str, Any] = field(default_factory=dict)  #: its other parameters; None: as the definition says

    def __post_init__(self) -> None:
        choice_of(tuple(_FIELDS), self.kind, "event")
        object.__setattr__(self, "time", number(f"{self.kind}: time", self.time, 0))
        object.__setattr__(self, "fields", _checked(self.kind, self.fields))

    def __repr__(self) -> str:
        usual = {"pressure": 0.5, "seconds": 0.0, "id": 0} if self.kind in ("strike", "move") else {"id": 0}
        told = [_short(self.time)] + [f"{key}={_short(value)}" for key, value in self.fields.items()
                                     if value is not None and value != usual.get(key)]
        return f"tabor.{self.kind}({', '.join(told)})"


def _short(value: Any) -> str:
    return repr(value).removesuffix(".0") if isinstance(value, float) else repr(value)


# ---- what an event's fields may be ------------------------------------------------------------------------------

_Check = Callable[[str, Any], Any]  # what is checked, as "strike: radius", and its value; gives the value


def _within(minimum: float = -math.inf, maximum: float = math.inf) -> _Check:
    return lambda what, value: number(what, value, minimum, maximum)


def _unless_none(check: _Check) -> _Check:
    return lambda what, value: None if value is None else check(what, value)


def _word(what: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{what} {value!r}: a string is needed")
    return value


def _technique(what: str, value: Any) -> str:
    choice_of(TECHNIQUES, _word(what, value), "technique")
    return str(value)


def _id(what: str, value: Any) -> int:
    return whole(what, value, 0, _LARGEST_ID)


def _wire(what: str, value: Any) -> int:
    return whole(what, value, 1, lib.TABOR_MAX_WIRES)


def _model(what: str, value: Any) -> Model:
    if not isinstance(value, Model):
        raise TypeError(f"{what.partition(':')[0]}: a Model is needed, not {value!r}")
    return value


_FIELDS: Dict[str, Dict[str, _Check]] = {
    "strike": {"velocity": _unless_none(_within(0.01, 30)), "radius": _unless_none(_within(0)),
               "angle": _unless_none(_within()), "striker": _unless_none(_word), "technique": _unless_none(_technique),
               "pressure": _within(0, 1), "id": _id},
    "pluck": {"wire": _wire, "place": _within(0, 1), "displacement": _within(1e-6, 0.05), "pull": _within(1e-4, 10)},
    "press": {"pressure": _within(0, 1), "id": _id},
    "move": {"radius": _within(0), "angle": _within(), "seconds": _within(0, 60), "id": _id},
    "damp": {"strength": _within(0, 100), "radius": _within(0), "angle": _within(), "id": _id},
    "release": {"id": _id},
    "change": {"key": _word, "value": _within()},
    "swap": {"model": _model},
    "replace": {"model": _model},
    "silence": {},
    "gain": {"factor": _within(0, 1e6)},
    "reset": {}}


def _checked(kind: str, fields: Dict[str, Any]) -> Dict[str, Any]:
    unknown = sorted(set(fields) - set(_FIELDS[kind]))
    if unknown:
        raise TypeError(f"{kind} has no {unknown[0]}")
    checked = {name: check(f"{kind}: {name}", fields.get(name)) for name, check in _FIELDS[kind].items()}
    if kind == "change":
        row = live_parameter(checked["key"])
        number(f"change: {checked['key']}", checked["value"], row.minimum, row.maximum)
    return checked


def live_parameter(key: str) -> Any:
    """The library's row of a parameter that can change while a drum rings."""
    row = lib.tabor_parameter_find(encoded(key, "key"))
    if not row:
        raise UnknownNameError(f"no parameter is called {key!r}", "key", key)
    if not row.live:
        raise Error(f"{key} cannot change while the drum rings: swap to another model", "key", key)
    return row


# ---- making events ----------------------------------------------------------------------------------------------

def strike(time: float = 0.0, velocity: Optional[float] = None, *, radius: Optional[float] = None,
           angle: Optional[float] = None, striker: Optional[str] = None, technique: Optional[str] = None,
           pressure: float = 0.5, id: int = 0) -> Event:
    """A stroke. What is None is as ``[strike]`` of the definition says.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    velocity : float, optional
        Of the tip as it touches [m/s], 0.01 to 30.
    radius : float, optional
        Distance from the centre [m], 0 or more; clamped to the head.
    angle : float, optional
        Direction [degrees], counter-clockwise from +x seen from above.
    striker : str, optional
        Name of a striker of the definition.
    technique : str, optional
        One of `TECHNIQUES`. A buzz, and a brush's sweep, go on until `release`.
    pressure : float
        Of a buzz or a sweep, 0 to 1.
    id : int
        A number for `press`, `move` and `release`, up to 2**32 - 1; 0: anonymous.

    Returns
    -------
    Event

    Raises
    ------
    TypeError
        A value is not a number, or not a string; True and False are no numbers.
    Error
        A value is not finite or not in its range, or there is no such technique; `Error.key` says which.

    Notes
    -----
    All functions of events check their values so. Numbers may be NumPy scalars.
    """
    return Event(time, "strike", {"velocity": velocity, "radius": radius, "angle": angle, "striker": striker,
                                  "technique": technique, "pressure": pressure, "id": id})


def pluck(time: float = 0.0, wire: int = 1, *, place: float = 0.3, displacement: float = 3e-3,
          pull: float = 0.01) -> Event:
    """A finger pulls a wire away from its head and lets go.

    Parameters
    ----------
    time : float
        When it begins to pull [s], from the start of the call that plays it.
    wire : int
        Number of the wire, from 1.
    place : float
        Where along the wire, as a part of its length, 0 to 1.
    displacement : float
        How far the finger would pull the wire if it touched nothing [m], 1e-6 to 0.05.
    pull : float
        Time until it lets go [s], 1e-4 to 10.

    Returns
    -------
    Event
    """
    return Event(time, "pluck", {"wire": wire, "place": place, "displacement": displacement, "pull": pull})


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
    return Event(time, "press", {"pressure": pressure, "id": id})


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
    return Event(time, "move", {"radius": radius, "angle": angle, "seconds": seconds, "id": id})


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
    return Event(time, "damp", {"strength": strength, "radius": radius, "angle": angle, "id": id})


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
    return Event(time, "release", {"id": id})


def change(time: float, key: str, value: float) -> Event:
    """Changes a parameter while the drum rings, smoothly; one whose `Parameter.live` is true.

    Parameters
    ----------
    time : float
        [s] from the start of the call that plays it.
    key : str
        As ``"wires.strainer"`` or ``"mic.top.gain"``.
    value : float
        In the parameter's unit, within its range.

    Returns
    -------
    Event

    Raises
    ------
    UnknownNameError
        No parameter has this key.
    Error
        The parameter is not live: `swap` to another model instead. Or the value is not in its range.
    """
    return Event(time, "change", {"key": key, "value": value})


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
    return Event(time, "swap", {"model": model})


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
    return Event(time, "replace", {"model": model})


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
    return Event(time, "silence")


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
    return Event(time, "gain", {"factor": factor})


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
    return Event(time, "reset")


#: The library's type of each kind of event.
TYPES: Dict[str, int] = {
    "strike": lib.TABOR_EVENT_STRIKE, "pluck": lib.TABOR_EVENT_STRIKE, "press": lib.TABOR_EVENT_PRESS, "damp": lib.TABOR_EVENT_DAMP,
    "release": lib.TABOR_EVENT_RELEASE, "change": lib.TABOR_EVENT_PARAMETER, "swap": lib.TABOR_EVENT_SWAP,
    "reset": lib.TABOR_EVENT_RESET, "move": lib.TABOR_EVENT_MOVE, "silence": lib.TABOR_EVENT_SILENCE,
    "gain": lib.TABOR_EVENT_GAIN, "replace": lib.TABOR_EVENT_REPLACE}

#: An event and the frame at which it acts.
Placed = Tuple[int, Event]


def frame_of(event: Event, rate: float) -> int:
    """Where it acts."""
    return math.floor(event.time * rate + 0.5)


def place(events: Sequence[Event], rate: float, frames: int) -> List[Placed]:
    """The events with their frames, in order; ValueError for one that is not among so many frames."""
    placed = []
    for event in events:
        if not isinstance(event, Event):
            raise TypeError(f"events: an Event is needed, as tabor.strike() makes one, not {event!r}")
        frame = frame_of(event, rate)
        if frame >= max(frames, 1):
            raise ValueError(f"{event.kind}: {event.time:g} s is outside of {frames / rate:g} s")
        placed.append((frame, event))
    return sorted(placed, key=lambda pair: pair[0])
