# SPDX-License-Identifier: MIT
"""Events into an array, as the program's render does it into a file."""

from __future__ import annotations

from typing import Callable, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .drum import Drum, chosen
from .events import Event, Placed, place, strike
from .model import Model, Playable, model_of
from .room import Room

_BLOCK = 4800  # frames between two looks at whether to stop


def _block(placed: Sequence[Placed], start: int, end: int) -> List[Placed]:
    return [(frame - start, event) for frame, event in placed if start <= frame < end]


def heard_mics(model: Model, mics: Optional[Sequence[str]]) -> Tuple[str, ...]:
    """The microphones asked for, or the usual one."""
    return chosen(model.mics, model.mics[:1] if mics is None else mics)


class Setting:
    """A model with the microphones that are heard, and the room if the definition has one."""

    def __init__(self, model: Model, mics: Sequence[str]) -> None:
        self.model = model
        self.heard = len(mics)
        self.rows = tuple(mics)
        self._definition = model.definition
        if self._definition.has_room:
            self.rows += tuple(name for name in self._feeds() if name not in mics)

    def _feeds(self) -> Tuple[str, ...]:
        return tuple(dict.fromkeys(Room(self._definition, self.model.sample_rate).feeds))

    def play(self, events: Sequence[Event], out: NDArray[np.float32],
             stopped: Callable[[], bool] = lambda: False) -> None:
        """Plays events on a fresh drum, into an array of shape (heard, frames)."""
        frames = out.shape[1]
        placed = place(events, self.model.sample_rate, frames)
        drum = Drum(self.model, self.rows)
        room = Room(self._definition, self.model.sample_rate, self.rows) if self._definition.has_room else None
        sound = out if len(self.rows) == self.heard else np.empty((len(self.rows), frames), np.float32)
        for start in range(0, frames, _BLOCK):
            if stopped():
                return
            block = sound[:, start:start + _BLOCK]
            drum._play(_block(placed, start, start + _BLOCK), block)
            if room:
                room._add(block)
        if sound is not out:
            out[:] = sound[:self.heard]


def render(drum: Playable, events: Optional[Sequence[Event]] = None, duration: float = 1.0, *,
           mics: Optional[Sequence[str]] = None, sample_rate: Optional[float] = None,
           quality: Optional[str] = None) -> NDArray[np.float32]:
    """Plays events on a fresh drum, in its room if it has one.

    Parameters
    ----------
    drum : Model, Definition or str
        What is played; a definition or a preset's name is computed first.
    events : sequence of Event, optional
        What happens, in any order; one stroke at once unless given.
    duration : float
        [s].
    mics : sequence of str, optional
        Names of the microphones; the usual one unless given.
    sample_rate : float, optional
        [Hz]; 48,000 unless given. A model has its own.
    quality : {"live", "draft", "studio", "reference", "definition"}, optional
        Accuracy against cost; ``"live"`` unless given. A model has its own.

    Returns
    -------
    ndarray of float32, shape (len(mics), frames)
        Sound pressure; 1.0 is ``output.full_scale`` pascals.

    Raises
    ------
    Error
        The definition is not allowed; `Error.key` says why.
    ValueError
        An event is not within the duration.

    Examples
    --------
    >>> sound = tabor.render("frame-drum", [tabor.strike(0, 3.0), tabor.strike(0.25, 1.0)], duration=0.5)
    >>> sound.shape
    (1, 24000)
    """
    model = model_of(drum, sample_rate, quality)
    names = heard_mics(model, mics)
    out = np.empty((len(names), frames_of(duration, model.sample_rate)), np.float32)
    Setting(model, names).play([strike()] if events is None else events, out)
    return out


def trace(drum: Playable, events: Optional[Sequence[Event]] = None, duration: float = 0.05, *,
          sample_rate: Optional[float] = None, quality: Optional[str] = None) -> NDArray[np.void]:
    """Plays events on a fresh drum and returns what moves, instead of the sound.

    Parameters
    ----------
    drum : Model, Definition or str
        What is played; a definition or a preset's name is computed first.
    events : sequence of Event, optional
        What happens; one stroke at once unless given.
    duration : float
        [s].
    sample_rate : float, optional
        [Hz]; 48,000 unless given. A model has its own.
    quality : {"live", "draft", "studio", "reference", "definition"}, optional
        Accuracy against cost; ``"live"`` unless given. A model has its own.

    Returns
    -------
    ndarray of TRACE, shape (frames,)
        A row after each sample.
    """
    model = model_of(drum, sample_rate, quality)
    frames = frames_of(duration, model.sample_rate)
    return Drum(model, model.mics[:1]).trace(frames, [strike()] if events is None else events)


def frames_of(duration: float, rate: float) -> int:
    """How many samples this is."""
    frames = duration * rate
    if not 0 <= frames < 2**31:
        raise ValueError(f"duration {duration!r}: allowed: 0 to {2**31 / rate:.0f} s")
    return round(frames)
