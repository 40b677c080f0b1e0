# SPDX-License-Identifier: MIT
"""Strokes into an array, as the program's render does it into a file."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Optional, Sequence, Union

import numpy as np

from ._library import text
from .definition import Definition
from .drum import Drum
from .events import Event, strike
from .model import Model


class Stroke(NamedTuple):
    """A normal stroke; what is None is as the definition's [strike] says. For a buzz there is Drum, with
    strike() and release()."""

    time: float = 0.0  #: [s]
    velocity: Optional[float] = None  #: [m/s]
    radius: Optional[float] = None  #: from the centre [m]
    angle: Optional[float] = None  #: [degrees]
    striker: Optional[str] = None


Playable = Union[Model, Definition, str]


def _frame(model: Model, stroke: Stroke) -> int:
    return int(np.floor(stroke.time * model.rate + 0.5))


def _events(model: Model, strokes: Sequence[Stroke], frames: int) -> List[Event]:
    for stroke in strokes:
        if not 0 <= _frame(model, stroke) < frames:
            raise ValueError(f"a stroke at {stroke.time:g} s is outside of {frames / model.rate:g} s")
    usual = model.definition.c.strike
    first = text(usual.striker) or model.definition.strikers[0]
    return [strike(_frame(model, stroke),
                   usual.velocity if stroke.velocity is None else stroke.velocity,
                   usual.radius if stroke.radius is None else stroke.radius,
                   usual.angle if stroke.angle is None else stroke.angle,
                   first if stroke.striker is None else stroke.striker)
            for stroke in sorted(strokes, key=lambda stroke: stroke.time)]


def _prepare(playable: Playable, rate: float, quality: str) -> Model:
    return playable if isinstance(playable, Model) else Model(playable, rate, quality)


def render(playable: Playable, strokes: Sequence[Stroke] = (Stroke(),), duration: float = 1.0,
           mics: Optional[Sequence[str]] = None, rate: float = 48000,
           quality: str = "default") -> "np.ndarray[Any, np.dtype[np.float32]]":
    """Plays strokes on a fresh drum for duration [s].

    playable: a preset's name or a Definition, computed for rate and quality, or a Model, which has them.
    Returns an array [microphone, frame], 1.0 = full scale, of the first microphone unless mics says
    which.
    """
    model = _prepare(playable, rate, quality)
    heard = model.definition.mics[:1] if mics is None else mics
    frames = round(duration * model.rate)
    return Drum(model).process(frames, _events(model, strokes, frames), heard)


def trace(playable: Playable, strokes: Sequence[Stroke] = (Stroke(),), duration: float = 0.05,
          rate: float = 48000, quality: str = "default") -> "np.ndarray[Any, np.dtype[np.void]]":
    """The same, but what moved instead of the sound: rows of TRACE."""
    model = _prepare(playable, rate, quality)
    frames = round(duration * model.rate)
    return Drum(model).trace(frames, _events(model, strokes, frames))
