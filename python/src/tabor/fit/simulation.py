# SPDX-License-Identifier: MIT
"""Recordings described, and the same description of simulated ones.

A description is a vector: frequencies and decays of the partials that belong to modes (logarithms), then the features of
a few strokes at each microphone (dB). NaN stands for what is missing.
"""

from __future__ import annotations

from typing import List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .._library import Error
from ..definition import Definition
from ..events import strike
from ..model import Model
from ..rendering import render
from .features import features, make_noise
from .modal_fit import Modes, modes_of
from .parameters import SPEED, SPEED_RANGE, Space
from .partials import Partials, find_partials
from .recordings import DURATION, Recording, Stroke, from_stroke

Array = NDArray[np.float64]

_TOP = 700.0  # of the modes that partials may belong to [Hz]
_WIDTH = 0.02  # of frequencies that may belong together
_DECAY_WIDTH = 0.7
_FARTHEST = 4.0  # squared distance of a partial from its mode


class Plan(NamedTuple):
    """What is simulated for a description."""

    space: Space
    rate: float  #: [Hz]
    mics: Tuple[str, ...]
    loudness: Tuple[float, ...]  #: of the strokes: parts of the hardest one's speed; or places among the strokes, 0 to 1
    are_levels_known: bool  #: which of the two
    noise: Tuple[Array, ...]  #: of each microphone, as by `noise_of`
    labels: Tuple[Tuple[int, int], ...]  #: of the modes whose partials are described
    quality: str

    def speeds(self, point: Array) -> List[float]:
        """Of the strokes [m/s]."""
        values = self.space.values(point)
        if self.are_levels_known:
            return [values[SPEED] * part for part in self.loudness]
        return [values[SPEED] * values[SPEED_RANGE] ** (place - 1) for place in self.loudness]


def play(drum: Definition, speeds: Sequence[float], mics: Sequence[str], rate: float, quality: str,
         duration: float = DURATION) -> Tuple[Model, List[Array]]:
    """Strokes on a fresh drum each.

    Parameters
    ----------
    drum : Definition
        The drum, and its room.
    speeds : sequence of float
        Of the usual stroke [m/s].
    mics : sequence of str
        Names of the microphones.
    rate : float
        [Hz].
    quality : str
        As of `Model`.
    duration : float
        [s].

    Returns
    -------
    model : Model
        Of the drum.
    sounds : list of ndarray of float64, shape (microphones, frames)
        One for each speed.
    """
    model = Model(drum, rate, quality)
    return model, [np.asarray(render(model, [strike(0.0, velocity=speed)], duration, mics=mics), np.float64) for speed in speeds]


def _described(partials: Optional[Partials], modes: Modes, labels: Sequence[Tuple[int, int]]) -> List[float]:
    """Frequencies, then decays, of the partials that are nearest to the labelled modes."""
    frequency, decay = np.full(len(labels), np.nan), np.full(len(labels), np.nan)
    if partials is None:
        return [*frequency, *decay]
    rows = {label: row for row, label in enumerate(modes.labels)}
    found_frequency, found_decay = np.log(partials.frequency), np.log(partials.decay_rate)
    for place, label in enumerate(labels):
        if label not in rows:
            continue
        row = rows[label]
        distance = ((found_frequency - modes.frequency[row]) / _WIDTH) ** 2 + ((found_decay - modes.decay[row]) / _DECAY_WIDTH) ** 2
        nearest = int(distance.argmin())
        if distance[nearest] < _FARTHEST:
            frequency[place], decay[place] = found_frequency[nearest], found_decay[nearest]
    return [*frequency, *decay]


def _partials(recordings: Sequence[Recording]) -> Optional[Partials]:
    try:
        return find_partials(recordings)
    except Error:
        return None


def describe(plan: Plan, strokes: Sequence[Stroke], modes: Modes) -> Array:
    """Describes strokes.

    Parameters
    ----------
    plan : Plan
        Whose microphones, in this order, each stroke has.
    strokes : sequence of Stroke
        From the softest to the hardest.
    modes : Modes
        Of the drum that is thought to sound.

    Returns
    -------
    ndarray of float64, shape (elements,)
        The same elements for each set of as many strokes.
    """
    partials = _partials([stroke.recordings[0] for stroke in strokes]) if plan.labels else None
    parts = [np.array(_described(partials, modes, plan.labels))]
    for stroke in strokes:
        parts += [features(one.channels, one.rate) for one in stroke.recordings]
    return np.concatenate(parts)


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
        As by `describe`.
    """
    random = np.random.default_rng(seed)
    drum = plan.space.definition(point)
    model, sounds = play(drum, plan.speeds(point), plan.mics, plan.rate, plan.quality)
    strokes = []
    for sound in sounds:
        heard = []
        for mic, noise, row in zip(plan.mics, plan.noise, sound):
            noisy = row / np.abs(row).max() + make_noise(noise, len(row), plan.rate, random)
            struck = from_stroke(noisy)
            heard.append(Recording(mic, struck, struck[None], plan.rate))
        strokes.append(Stroke(tuple(heard)))
    return describe(plan, strokes, modes_of(model, float(drum["strike.radius"]), _TOP))
