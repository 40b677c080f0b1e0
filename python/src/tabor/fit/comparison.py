# SPDX-License-Identifier: MIT
"""How far the drum that was found is from the recordings."""

from __future__ import annotations

from typing import List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .._library import Error
from ..model import Model
from .features import BANDS, described, features, noises_of
from .partials import find_partials
from .recordings import Stroke
from .simulation import levels_of, play, stroke_of, with_noise

Array = NDArray[np.float64]

_NEAR = 0.04  # of frequencies of partials that may be the same
_LEAST_LEVEL = -20.0  # of the recording's partials that are compared, below the strongest [dB]
_COMPARED = [index for index, band in enumerate(BANDS) if band > 99]  # 100 Hz to 16 kHz, as elsewhere (docs/recordings.md)
_SPEEDS = np.geomspace(0.5, 12.0, 25)  # among which one is looked for [m/s]


class StrokeDifference(NamedTuple):
    """Of one stroke at one microphone."""

    name: str  #: of the recording
    speed: float  #: of the model's stroke [m/s]
    early: float  #: root mean square difference of third octaves from 0 to 50 ms, each relative to their sum [dB]
    late: float  #: the same from 50 to 200 ms [dB]


class PartialDifference(NamedTuple):
    """Of one partial of the recording from the model's nearest."""

    frequency: float  #: in the recording [Hz]
    decay_rate: float  #: in the recording [1/s]
    level: float  #: in the recording, below the strongest [dB]
    cents: float  #: of the model's frequency over the recording's; NaN where the model has none within 4 %
    decay_ratio: float  #: of the model's decay rate over the recording's


def _normalized(levels: Array) -> Array:
    """Of one window, relative to their sum."""
    return np.asarray(levels - 10 * np.log10(np.sum(10 ** (levels / 10))))


def difference(recorded: Array, modelled: Array) -> Tuple[float, float]:
    """Root mean square differences of third octaves from 100 Hz to 16 kHz in the first two windows [dB]."""
    found = []
    for window in range(2):
        bands = np.array(_COMPARED) + window * len(BANDS)
        found.append(float(np.sqrt(np.mean((_normalized(recorded[bands]) - _normalized(modelled[bands])) ** 2))))
    return found[0], found[1]


def played(model: Model, mics: Sequence[str], speed: float) -> Stroke:
    """A stroke of the model as a recording."""
    return stroke_of(play(model, speed, mics), mics, model.sample_rate)


def played_beside(model: Model, mics: Sequence[str], speed: float, recorded: Stroke) -> Stroke:
    """A stroke of the model with the noise of a recording, which is what is left of its treble in the end."""
    return _beside(play(model, speed, mics), model.sample_rate, mics, recorded)


def _beside(sound: Array, rate: float, mics: Sequence[str], recorded: Stroke) -> Stroke:
    return stroke_of(with_noise(sound, noises_of(recorded), rate, np.random.default_rng(1)), mics, rate)


def best_speed(model: Model, mics: Sequence[str], recorded: Stroke, hardest: Optional[Tuple[Stroke, float]] = None) -> float:
    """The speed whose stroke is nearest to a recording.

    Parameters
    ----------
    model : Model
        The drum.
    mics : sequence of str
        Names of the microphones.
    recorded : Stroke
        The recording.
    hardest : (Stroke, float), optional
        A recording and its speed, beside whose level that of the recording counts, too, if levels are known.

    Returns
    -------
    float
        The speed [m/s].
    """
    wanted = described(recorded)
    level = np.zeros(0) if hardest is None else levels_of(np.array([recorded.peaks(), hardest[0].peaks()]), True)
    peaks = None if hardest is None else np.abs(play(model, hardest[1], mics)).max(axis=1)

    def cost(speed: float) -> float:
        sound = play(model, speed, mics)
        apart = float(np.mean((wanted - described(_beside(sound, model.sample_rate, mics, recorded))) ** 2))
        if peaks is None:
            return apart
        return apart + float(np.mean((level - levels_of(np.array([np.abs(sound).max(axis=1), peaks]), True)) ** 2))

    costs = [cost(float(speed)) for speed in _SPEEDS]
    place = int(np.clip(np.argmin(costs), 1, len(_SPEEDS) - 2))
    # The lowest point of a parabola in the logarithm of the speed.
    before, here, after = costs[place - 1:place + 2]
    bend = before - 2 * here + after
    shift = 0.0 if bend <= 0 else float(np.clip(0.5 * (before - after) / bend, -1, 1))
    return float(_SPEEDS[place] * (_SPEEDS[1] / _SPEEDS[0]) ** shift)


def stroke_differences(model: Model, mics: Sequence[str], strokes: Sequence[Stroke],
                       speeds: Sequence[float]) -> List[StrokeDifference]:
    """Each stroke at each microphone, beside the model's stroke of a speed."""
    found = []
    for stroke, speed in zip(strokes, speeds):
        for one, two in zip(stroke.recordings, played_beside(model, mics, speed, stroke).recordings):
            found.append(StrokeDifference(one.name, speed, *difference(features(one.channels, one.rate), features(two.channels, two.rate))))
    return found


def partial_differences(model: Model, mics: Sequence[str], strokes: Sequence[Stroke],
                        speeds: Sequence[float]) -> List[PartialDifference]:
    """The recordings' partials beside the nearest of the model's strokes, at the first microphone."""
    recorded = find_partials([stroke.recordings[0] for stroke in strokes])
    try:
        modelled = find_partials([played(model, mics[:1], speed).recordings[0] for speed in speeds])
    except Error:  # it rings too little
        modelled = recorded._replace(frequency=np.full(1, np.inf), decay_rate=np.ones(1), level=np.zeros(1))
    found = []
    for frequency, decay, level in zip(recorded.frequency, recorded.decay_rate, recorded.level):
        if level < _LEAST_LEVEL:
            continue
        nearest = int(np.argmin(np.abs(np.log(modelled.frequency / frequency))))
        apart = float(np.log(modelled.frequency[nearest] / frequency))
        near = abs(apart) < _NEAR
        found.append(PartialDifference(float(frequency), float(decay), float(level), 1200 * apart / np.log(2) if near else np.nan,
                                       float(modelled.decay_rate[nearest] / decay) if near else np.nan))
    return found
