# SPDX-License-Identifier: MIT
"""What is compared of a recording and a model: levels of third octaves in time windows, and the click.

Levels are in dB relative to the stroke's whole first window, so that gains do not count. The windows are those in which
recorded drums are described elsewhere in this project (docs/recordings.md): 0 to 50 ms, 50 to 200 ms, and 200 to 500 ms,
each faded out over its last fifth, all but the first in over their first tenth. The click is three octaves in the first
4 ms, before the head's waves have come back.
"""

from __future__ import annotations

from typing import List, NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray

from .recordings import Stroke

Array = NDArray[np.float64]

WINDOWS: Tuple[Tuple[float, float], ...] = ((0.0, 0.05), (0.05, 0.2), (0.2, 0.5))  # [s]
CLICK = (0.0, 0.004)  # [s]
BANDS: Tuple[float, ...] = tuple(1000 * 2 ** (i / 3) for i in range(-12, 13))  # third octaves: middles [Hz]
_CLICK_BANDS = (2000.0, 4000.0, 8000.0)  # octaves: middles [Hz]
_NOISE = (0.1, 1.0)  # a piece that long, until then, is noise [s]
_FLOOR = -80.0  # below the first window: less is not told apart [dB]


class Label(NamedTuple):
    """What an element of `features` is."""

    window: int  #: of WINDOWS, or -1: the click
    band: float  #: its middle [Hz]


LABELS: Tuple[Label, ...] = (*(Label(window, band) for window in range(len(WINDOWS)) for band in BANDS),
                             *(Label(-1, band) for band in _CLICK_BANDS))


def _faded(sound: Array, rate: float, window: Tuple[float, float]) -> Array:
    first, last = (round(edge * rate) for edge in window)
    piece = np.zeros(last - first)
    part = sound[first:last]
    piece[:len(part)] = part
    count = len(piece) // 5
    piece[-count:] *= 0.5 + 0.5 * np.cos(np.pi * np.arange(1, count + 1) / count)
    if first:
        count = len(piece) // 10
        piece[:count] *= 0.5 - 0.5 * np.cos(np.pi * np.arange(count) / count)
    return piece


def energies(piece: Array, rate: float, middles: Tuple[float, ...], width: float) -> List[float]:
    """Sums of squares of a sound in bands around `middles` [Hz], each `width` octaves wide."""
    size = 2 ** int(np.ceil(np.log2(len(piece) + 1)))
    power = 2 * np.abs(np.fft.rfft(piece, size)) ** 2 / size
    step = 0.5 * rate / (len(power) - 1)
    # The bands' edges fall between lines: the running sum is interpolated there.
    below = np.concatenate(([0.0], np.cumsum(power)))
    edges = np.array([[middle * 2 ** (-width / 2), middle * 2 ** (width / 2)] for middle in middles])
    at = np.interp(edges / step + 0.5, np.arange(len(below)), below)
    return list(at[:, 1] - at[:, 0])


def noise_of(sound: Array, rate: float) -> Array:
    """The noise that is left late in a recording.

    Parameters
    ----------
    sound : ndarray of float64, shape (frames,)
        From the stroke on.
    rate : float
        [Hz].

    Returns
    -------
    ndarray of float64, shape (len(BANDS),)
        Power per hertz in each of BANDS over the square of the sound's peak, in the last 100 ms of its first second. Where
        the drum rings that long, it counts as noise.
    """
    last = min(len(sound), round(_NOISE[1] * rate))
    piece = sound[last - round(_NOISE[0] * rate):last] / np.abs(sound).max()
    power = np.array(energies(piece * np.hanning(len(piece)), rate, BANDS, 1 / 3)) / (0.375 * len(piece))  # Hann's window
    return np.asarray(power / (np.array(BANDS) * (2 ** (1 / 6) - 2 ** (-1 / 6))))


def noises_of(stroke: Stroke) -> Tuple[Array, ...]:
    """The noise of each microphone."""
    return tuple(noise_of(one.sound, one.rate) for one in stroke.recordings)


def make_noise(noise: Array, frames: int, rate: float, random: np.random.Generator) -> Array:
    """Noise such as `noise_of` measured, for a sound whose peak is 1.

    Parameters
    ----------
    noise : ndarray of float64, shape (len(BANDS),)
        As measured.
    frames : int
        Its length.
    rate : float
        [Hz].
    random : numpy.random.Generator
        What draws it.

    Returns
    -------
    ndarray of float64, shape (frames,)
        Gaussian noise.
    """
    size = 2 ** int(np.ceil(np.log2(frames)))
    frequencies = np.fft.rfftfreq(size, 1 / rate)
    level = np.interp(np.log(np.maximum(frequencies, 1.0)), np.log(BANDS), np.log(np.maximum(noise, 1e-30)))
    spectrum = np.fft.rfft(random.standard_normal(size)) * np.exp(0.5 * level) * np.sqrt(0.5 * rate)
    return np.fft.irfft(spectrum, size)[:frames]


def features(sound: Array, rate: float) -> Array:
    """Describes one stroke at one microphone.

    Parameters
    ----------
    sound : ndarray of float64, shape (channels, frames)
        From the stroke on.
    rate : float
        [Hz].

    Returns
    -------
    ndarray of float64, shape (len(LABELS),)
        Levels [dB], of the channels' energies together; not below -80.
    """
    energies = np.sum([_levels(channel, rate) for channel in sound], axis=0)
    whole = max(float(np.sum(energies[:len(BANDS)])), 1e-300)
    return np.asarray(10 * np.log10(np.maximum(energies / whole, 10 ** (_FLOOR / 10))))


def _levels(sound: Array, rate: float) -> List[float]:
    levels: List[float] = []
    for window in WINDOWS:
        levels += energies(_faded(sound, rate, window), rate, BANDS, 1 / 3)
    return levels + energies(_faded(sound, rate, CLICK), rate, _CLICK_BANDS, 1.0)


def described(stroke: Stroke) -> Array:
    """The features of all microphones, one after the other."""
    return np.concatenate([features(one.channels, one.rate) for one in stroke.recordings])
