# SPDX-License-Identifier: MIT
"""What can happen to a drum at a frame of a block."""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, Union

from ._library import lib


class Event(NamedTuple):
    """An event; made by the functions below."""

    frame: int  #: offset into the block
    type: int
    fields: Dict[str, Any]  #: further fields of the C struct; "striker" and a microphone by name


#: How a stroke can be made.
TECHNIQUES = {"normal": lib.TABOR_TECHNIQUE_NORMAL, "buzz": lib.TABOR_TECHNIQUE_BUZZ,
              "rimshot": lib.TABOR_TECHNIQUE_RIMSHOT, "cross-stick": lib.TABOR_TECHNIQUE_CROSS_STICK,
              "rim": lib.TABOR_TECHNIQUE_RIM, "sweep": lib.TABOR_TECHNIQUE_SWEEP}


def strike(frame: int = 0, velocity: float = 2.5, radius: float = 0.05, angle: float = 0.0,
           striker: Union[str, int] = 0, id: int = 0, technique: str = "normal",
           pressure: float = 0.5) -> Event:
    """A stroke: velocity [m/s], radius from the centre [m]; id is a name for later events. A "buzz" and a
    brush's "sweep" stay under pressure, 0 to 1, until they are released."""
    if technique not in TECHNIQUES:
        raise ValueError(f"unknown technique {technique!r}; there are {', '.join(TECHNIQUES)}")
    return Event(frame, lib.TABOR_EVENT_STRIKE,
                 {"velocity": velocity, "radius": radius, "angle": angle, "striker": striker, "id": id,
                  "technique": TECHNIQUES[technique], "value": pressure})


def move(frame: int = 0, radius: float = 0.05, angle: float = 0.0, seconds: float = 0.0,
         id: int = 0) -> Event:
    """Sends the sweeping brush called id, or all, to a place, the shorter way round, in so many seconds; 0: in as
    long as since its last move, as a stream of moves wants it."""
    return Event(frame, lib.TABOR_EVENT_MOVE,
                 {"radius": radius, "angle": angle, "value": seconds, "id": id})


def press(frame: int = 0, value: float = 0.5, id: int = 0) -> Event:
    """Presses strikers in play, or the one called id, onto the head: 0 to 1 for 0.3 to 8 N."""
    return Event(frame, lib.TABOR_EVENT_PRESS, {"value": value, "id": id})


def damp(frame: int = 0, value: float = 5.0, radius: float = 0.0, angle: float = 0.0,
         id: int = 0) -> Event:
    """A hand of strength value [N s/m] on the head."""
    return Event(frame, lib.TABOR_EVENT_DAMP,
                 {"value": value, "radius": radius, "angle": angle, "id": id})


def release(frame: int = 0, id: int = 0) -> Event:
    """Takes strikers and hands away: the one called id, or all."""
    return Event(frame, lib.TABOR_EVENT_RELEASE, {"id": id})


def parameter(key: str, value: float, frame: int = 0) -> Event:
    """Moves a live parameter, as "wires.strainer" or "mic.top.gain"."""
    row = lib.tabor_parameter_find(key.encode())
    if not row:
        raise KeyError(f"no parameter is called {key!r}")
    if not row.live:
        raise ValueError(f"{key} cannot change while the drum rings: swap to another model")
    fields: Dict[str, Any] = {"parameter": row.id, "value": value}
    if key.startswith("mic."):
        fields["index"] = key.split(".")[1]
    return Event(frame, lib.TABOR_EVENT_PARAMETER, fields)


def reset(frame: int = 0) -> Event:
    """Back to rest."""
    return Event(frame, lib.TABOR_EVENT_RESET, {})


def silence(frame: int = 0) -> Event:
    """Fades out what sounds, over 15 ms; live parameters stay."""
    return Event(frame, lib.TABOR_EVENT_SILENCE, {})


def gain(value: float, frame: int = 0) -> Event:
    """Sets the gain of all outputs, a factor, reached over 5 ms."""
    return Event(frame, lib.TABOR_EVENT_GAIN, {"value": value})
