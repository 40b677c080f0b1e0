# SPDX-License-Identifier: MIT
"""Events into an array, as the program's render does it into a file."""

from __future__ import annotations

import math
import os
from typing import Callable, Iterator, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._numbers import number
from ._pieces import PIECE
from .drum import Drum, chosen
from .events import Event, Placed, frame_of, place, strike
from .midi import Path, midi_events
from .model import Model, Playable, model_of
from .room import Room, RoomFade

#: What happens to a drum: events, or the name of a MIDI file.
Happening = Union[Sequence[Event], Path]

# When a sound has died away, as the program has it (host/sound/ring_out.h).
RING_OUT_BLOCK = 256  # frames between two looks at the energy; the length of the sound depends on it
_ENERGY_FALL = 1e-9  # 90 dB
_LEAST_TIME = 0.5  # after the last event [s]
_MOST_TIME = 20.0  # after the last event [s]
LATEST_EVENT = 3600.0  # [s]


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

    def _place(self, events: Happening, frames: int) -> List[Placed]:
        rate = self.model.sample_rate
        if isinstance(events, (str, os.PathLike)):
            events = [event for event in midi_events(events, self.model) if frame_of(event, rate) < frames]
        return place(events, rate, frames)

    def play(self, events: Happening, out: NDArray[np.float32],
             stopped: Callable[[], bool] = lambda: False) -> None:
        """Plays events on a fresh drum, into an array of shape (heard, frames)."""
        frames = out.shape[1]
        playing = _Playing(self, self._place(events, frames))
        for start in range(0, frames, PIECE):
            if stopped():
                return
            out[:, start:start + PIECE] = playing.play(min(PIECE, frames - start))[:self.heard]

    def ring_out(self, events: Happening, stopped: Callable[[], bool] = lambda: False) -> NDArray[np.float32]:
        """Plays events on a fresh drum until it has died away; an array of shape (heard, frames)."""
        playing = _Playing(self, self._place(events, math.ceil(LATEST_EVENT * self.model.sample_rate) + 1))
        return np.concatenate([block[:self.heard] for block in playing.ring_out(stopped)], axis=1)


class RingOut:
    """When a sound is over whose last event is at a frame: its stored energy is 90 dB below its largest since then."""

    def __init__(self, last: int, rate: float) -> None:
        self._last = last
        self._least = last + math.ceil(_LEAST_TIME * rate)
        self.most = last + math.ceil(_MOST_TIME * rate)
        self._loudest = 0.0  # stored energy since the last event [J]

    def is_over(self, position: int, stored: Callable[[], float], is_silent: bool, is_alone: bool) -> bool:
        """Whether it is after these frames, from what drums store [J]; with `is_alone` nothing sounds but them."""
        if position <= self._last:
            return False
        energy = stored()
        self._loudest = max(self._loudest, energy)
        if position < self._least:
            return False
        return position >= self.most or (is_alone and (is_silent or energy <= _ENERGY_FALL * self._loudest))


class _Playing:
    """A fresh drum, in its room if it has one, and what is yet to happen to it."""

    def __init__(self, setting: Setting, placed: Sequence[Placed]) -> None:
        model, definition = setting.model, setting._definition
        self._rate = model.sample_rate
        self._drum = Drum(model, setting.rows)
        self._room = RoomFade(definition, self._rate, setting.rows) if definition.has_room else None
        self._placed = placed
        self._next = 0  # of the events
        self._position = 0  # frames played
        self._loudest_room = 0.0

    def _due(self, frames: int) -> List[Placed]:
        """The events within as many frames, each with its frame among them."""
        first, end = self._next, self._position + frames
        while self._next < len(self._placed) and self._placed[self._next][0] < end:
            self._next += 1
        return [(frame - self._position, event) for frame, event in self._placed[first:self._next]]

    def play(self, frames: int) -> NDArray[np.float32]:
        """Plays on; an array of shape (rows, frames)."""
        block = np.empty((len(self._drum.mics), frames), np.float32)
        due = self._due(frames)
        self._drum._play(due, block)
        if self._room:
            self._room.add(block, [frame for frame, event in due if event.kind == "silence"])
        self._position += frames
        return block

    def ring_out(self, stopped: Callable[[], bool]) -> Iterator[NDArray[np.float32]]:
        """Plays on until the sound has died away."""
        sound = RingOut(self._placed[-1][0] if self._placed else 0, self._rate)
        over = False
        while not over:
            yield self.play(min(RING_OUT_BLOCK, sound.most - self._position))
            over = stopped() or sound.is_over(self._position, lambda: self._drum.ledger().stored, self._drum.is_silent,
                                              self._is_room_over())

    def _is_room_over(self) -> bool:
        """Whether the room is 90 dB below its loudest."""
        room = self._room.energy if self._room else 0.0
        self._loudest_room = max(self._loudest_room, room)
        return room <= _ENERGY_FALL * self._loudest_room


def render(drum: Playable, events: Optional[Happening] = None, duration: Optional[float] = None, *,
           mics: Optional[Sequence[str]] = None, sample_rate: Optional[float] = None,
           quality: Optional[str] = None) -> NDArray[np.float32]:
    """Plays events on a fresh drum, in its room if it has one.

    Parameters
    ----------
    drum : Model, Definition or str
        What is played; a definition or a preset's name is computed first.
    events : sequence of Event, str or path, optional
        What happens, in any order, or the name of a MIDI file (see `midi_events`), whose events after the end are left out; one
        stroke at once unless given.
    duration : float, optional
        [s]; until the sound has died away unless given, as `tabor render` has it: until the energies of drum and room
        are 90 dB below their largest since the last event, 0.5 to 20 s after that event.
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
        An event is not within the duration, or comes later than an hour.

    Examples
    --------
    >>> sound = tabor.render("frame-drum", [tabor.strike(0, 3.0), tabor.strike(0.25, 1.0)], duration=0.5)
    >>> sound.shape
    (1, 24000)
    """
    model = model_of(drum, sample_rate, quality)
    setting = Setting(model, heard_mics(model, mics))
    events = [strike()] if events is None else events
    if duration is None:
        return setting.ring_out(events)
    out = np.empty((setting.heard, frames_of(duration, model.sample_rate)), np.float32)
    setting.play(events, out)
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
    return round(number("duration", duration, 0, math.floor((2**31 - 1) / rate)) * rate)
