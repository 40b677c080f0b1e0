# SPDX-License-Identifier: MIT
"""Recordings described, and the same description of simulated ones.

A description is a vector: frequencies and decays of the partials that belong to modes (logarithms), then, where levels
are known, those of the strokes relative to the hardest one's, then the features of a few strokes at each microphone (dB).
NaN stands for what is missing.
"""

from __future__ import annotations

from typing import Callable, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .._library import Error
from ..events import strike
from ..model import Model
from ..rendering import render
from .features import LABELS, described, make_noise
from .modal_fit import DECAY_WIDTH, TOP, Modes, modes_of
from .parameters import ROOM_SIZES, SPEED, SPEED_POWER, SPEED_RANGE, Space
from .partials import Partials, find_partials
from .recordings import DURATION, Recording, Stroke, from_stroke

Array = NDArray[np.float64]

#: Describes simulated recordings of points; the second argument counts all simulations before them.
Describe = Callable[[Sequence[Array], int], List[Array]]

_WIDTH = 0.02  # of frequencies that may belong together
DIGITS = 6  # of a description: the last bits of linear algebra differ from run to run, and would draw other points
FREQUENCY, DECAY, LEVEL = -4, -3, -2  # groups of elements, beside windows
_FARTHEST = 4.0  # squared distance of a partial from its mode


class Plan(NamedTuple):
    """What is simulated for a description."""

    space: Space
    rate: float  #: [Hz]
    mics: Tuple[str, ...]
    loudness: Tuple[float, ...]  #: of the strokes: parts of the hardest one's peak; or places among the strokes, 0 to 1
    are_levels_known: bool  #: which of the two
    noise: Tuple[Tuple[Array, ...], ...]  #: of each stroke at each microphone, as by `noise_of`
    labels: Tuple[Tuple[int, int], ...]  #: of the modes whose partials are described
    quality: str

    def speeds(self, point: Array) -> List[float]:
        """Of the strokes [m/s]."""
        values = self.space.values(point)
        if self.are_levels_known:
            return [values[SPEED] * part ** values.get(SPEED_POWER, 1.0) for part in self.loudness]
        return [values[SPEED] * values.get(SPEED_RANGE, 1.0) ** (place - 1) for place in self.loudness]

    def groups(self) -> NDArray[np.int64]:
        """Of a description's elements: FREQUENCY, DECAY, LEVEL, or the window of a feature."""
        count, strokes = len(self.labels), len(self.loudness)
        levels = (strokes - 1) * len(self.mics) if self.are_levels_known else 0
        return np.concatenate([np.repeat([FREQUENCY, DECAY, LEVEL], [count, count, levels]),
                               np.tile([label.window for label in LABELS], strokes * len(self.mics))])


def play(model: Model, speed: float, mics: Sequence[str]) -> Array:
    """A stroke on a fresh drum, in its room.

    Parameters
    ----------
    model : Model
        The drum.
    speed : float
        Of the usual stroke [m/s].
    mics : sequence of str
        Names of the microphones.

    Returns
    -------
    ndarray of float64, shape (microphones, frames)
        DURATION seconds.
    """
    return np.asarray(render(model, [strike(0.0, velocity=speed)], DURATION, mics=mics), np.float64)


def stroke_of(sound: Array, mics: Sequence[str], rate: float) -> Stroke:
    """A simulated sound of shape (microphones, frames), as if it were recorded."""
    rows = [from_stroke(row, rate) for row in sound]
    return Stroke(tuple(Recording(mic, row, row[None], rate) for mic, row in zip(mics, rows)))


def levels_of(peaks: Array, are_known: bool) -> Array:
    """Levels of strokes relative to the last, the hardest one, of peaks of shape (strokes, microphones) [dB]."""
    return np.asarray(20 * np.log10(peaks[:-1] / peaks[-1])).ravel() if are_known else np.empty(0)


def with_noise(sound: Array, noise: Sequence[Array], rate: float, random: np.random.Generator) -> Array:
    """A simulated sound of shape (microphones, frames), at its peaks 1, with each microphone's noise."""
    return np.array([row / np.abs(row).max() + make_noise(one, len(row), rate, random) for row, one in zip(sound, noise)])


def describe_partials(partials: Optional[Partials], modes: Modes, labels: Sequence[Tuple[int, int]]) -> Array:
    """Describes partials, with which a description begins.

    Parameters
    ----------
    partials : Partials, optional
        Of strokes on one drum; none that can be told.
    modes : Modes
        Of the drum that is thought to sound.
    labels : sequence of (int, int)
        Of the modes whose partials are described.

    Returns
    -------
    ndarray of float64, shape (2 * len(labels),)
        Logarithms of frequencies, then of decay rates, of the partials that are nearest to these modes.
    """
    frequency, decay = np.full(len(labels), np.nan), np.full(len(labels), np.nan)
    if partials is None:
        return np.concatenate([frequency, decay])
    rows = {label: row for row, label in enumerate(modes.labels)}
    found_frequency, found_decay = np.log(partials.frequency), np.log(partials.decay_rate)
    for place, label in enumerate(labels):
        if label not in rows:
            continue
        row = rows[label]
        distance = ((found_frequency - modes.frequency[row]) / _WIDTH) ** 2 + ((found_decay - modes.decay[row]) / DECAY_WIDTH) ** 2
        nearest = int(distance.argmin())
        if distance[nearest] < _FARTHEST:
            frequency[place], decay[place] = found_frequency[nearest], found_decay[nearest]
    return np.concatenate([frequency, decay])


def _partials(recordings: Sequence[Recording]) -> Optional[Partials]:
    try:
        return find_partials(recordings)
    except Error:
        return None


def simulate(plan: Plan, point: Array, seed: int) -> Array:
    """Describes a simulated recording, with noise.

    Parameters
    ----------
    plan : Plan
        What is simulated.
    point : ndarray of float64
        Of the plan's space.
    seed : int
        Of the noise.

    Returns
    -------
    ndarray of float64, shape (elements,)
        Of partials, as by `describe_partials`, of levels, as by `levels_of`, and of each stroke, as by `described`.
    """
    random = np.random.default_rng(seed)
    drum = plan.space.definition(point)
    if drum.has_room and not drum["room.size"]:
        drum["room.size"] = random.uniform(*ROOM_SIZES)
    model = Model(drum, plan.rate, plan.quality)
    strokes, peaks = [], []
    for speed, noise in zip(plan.speeds(point), plan.noise):
        sound = play(model, speed, plan.mics)
        peaks.append(np.abs(sound).max(axis=1))
        strokes.append(stroke_of(with_noise(sound, noise, plan.rate, random), plan.mics, plan.rate))
    modes = modes_of(model, float(drum["strike.radius"]), TOP)
    partials = _partials([stroke.recordings[0] for stroke in strokes]) if plan.labels else None
    description = np.concatenate([describe_partials(partials, modes, plan.labels), levels_of(np.array(peaks), plan.are_levels_known),
                                  *[described(stroke) for stroke in strokes]])
    return np.round(description, DIGITS)
