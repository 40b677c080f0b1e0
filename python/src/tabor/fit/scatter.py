# SPDX-License-Identifier: MIT
"""What strokes of rising dynamics have in common, and how much they scatter around it."""

from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from .features import described, features
from .recordings import Stroke

Array = NDArray[np.float64]

_LINE, _PARABOLA = 4, 6  # strokes from which on features may change along a line, or a parabola
_FEWEST_FLOOR = 1.0  # no two strokes are known to be nearer than this [dB]
_FLOOR = 2.0  # where strokes or microphones are too few to tell [dB]


class Scatter(NamedTuple):
    """Of the features of all microphones, one after the other."""

    smooth: Array  #: what features are along the dynamics, shape (strokes, features) [dB]
    floor: Array  #: how far a stroke, or the other channel of a microphone, differs from it, root mean square [dB]


def _between_channels(strokes: Sequence[Stroke]) -> Array:
    """Half the difference of two channels: how far each is from their mean; 0 for one channel."""
    halves = []
    for stroke in strokes:
        for one in stroke.recordings:
            apart = [features(channel[None], one.rate) for channel in one.channels]
            halves.append(np.std(apart, axis=0))
    shape = (len(strokes), len(strokes[0].recordings), -1)
    return np.asarray(np.sqrt(np.mean(np.square(halves).reshape(shape), axis=0)).ravel())


def scatter_of(strokes: Sequence[Stroke], loudness: Sequence[float]) -> Scatter:
    """Measures strokes of rising dynamics.

    Parameters
    ----------
    strokes : sequence of Stroke
        From the softest to the hardest.
    loudness : sequence of float
        How hard each is.

    Returns
    -------
    Scatter
        A line or parabola through each feature, and the root mean square distance from it; with few strokes and one
        channel, 2 dB.
    """
    values = np.array([described(stroke) for stroke in strokes])
    degree = (len(strokes) >= _LINE) + (len(strokes) >= _PARABOLA)
    channels = _between_channels(strokes)
    if degree == 0:
        return Scatter(values, np.where(channels > 0, np.maximum(channels, _FEWEST_FLOOR), _FLOOR))
    design = np.vander(np.asarray(loudness, float), degree + 1)
    smooth = design @ np.linalg.lstsq(design, values, rcond=None)[0]
    hits = np.sum((values - smooth) ** 2, axis=0) / (len(strokes) - degree - 1)
    return Scatter(smooth, np.maximum(np.sqrt(hits + channels**2), _FEWEST_FLOOR))
