# SPDX-License-Identifier: MIT
"""Recordings of single strokes, looked at before anything is fitted to them."""

from __future__ import annotations

import os
from typing import NamedTuple, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from .._library import Error

Array = NDArray[np.float64]

DURATION = 0.65  # of a stroke that is looked at [s]
_LEAST_PEAK = 1e-4  # of full scale
_CLIPPED = 4  # samples in a row at the largest value
_ONSET = 0.03  # of the peak
_RISING = 0.001  # [s]
_PIECE = 0.05  # of the envelope [s]
_RISE = 8.0  # by which the envelope rises again where something else is struck [dB]


class Recording(NamedTuple):
    """One stroke at one microphone."""

    name: str  #: of the file
    sound: Array  #: shape (frames,), the mean of the file's channels, from the stroke on
    channels: Array  #: shape (channels, frames), each of them
    rate: float  #: [Hz]


class Stroke(NamedTuple):
    """One stroke at all microphones."""

    recordings: Tuple[Recording, ...]  #: in the order of the microphones

    def peaks(self) -> Array:
        """The largest size at each microphone."""
        return np.array([np.abs(one.sound).max() for one in self.recordings])


def from_stroke(sound: Array, rate: float) -> Array:
    """The sound from the first sample above 3 % of the peak that is no click of the noise: the next millisecond is as loud."""
    size = np.abs(sound)
    level = _ONSET * size.max()
    count = max(1, round(_RISING * rate))
    energy = np.concatenate(([0.0], np.cumsum(sound**2), np.full(count, np.sum(sound**2))))
    loud = energy[count:count + len(sound)] - energy[:len(sound)] >= count * level**2
    return sound[int(np.argmax(loud & (size > level))):]


def _envelope(sound: Array, rate: float) -> Array:
    """Mean square of pieces [dB]."""
    size = int(_PIECE * rate)
    pieces = sound[:len(sound) // size * size].reshape(-1, size)
    return np.asarray(10 * np.log10(np.mean(pieces**2, axis=1) + 1e-20))


def _longest_run(sound: Array) -> int:
    """The most samples in a row that are as large as the largest."""
    size = np.abs(sound)
    edges = np.flatnonzero(np.diff(np.concatenate(([0], (size >= 0.9999 * size.max()).astype(int), [0]))))
    return int(np.max(edges[1::2] - edges[::2]))


def checked(name: str, channels: Array, rate: float) -> Recording:
    """One stroke of a recording.

    Parameters
    ----------
    name : str
        Of the file, for messages.
    channels : ndarray of float64, shape (channels, frames)
        1.0 is full scale.
    rate : float
        [Hz].

    Returns
    -------
    Recording
        From the stroke on.

    Raises
    ------
    Error
        It is silent, clipped, too short, or not one stroke that dies away.
    """
    sound = channels.mean(axis=0)
    if len(sound) < DURATION * rate:
        raise Error(f"{name}: it lasts {len(sound) / rate:.3g} s; a stroke of at least {DURATION} s is needed")
    peak = float(np.max(np.abs(sound)))
    if not np.isfinite(peak):
        raise Error(f"{name}: it holds numbers that are not finite")
    if peak < _LEAST_PEAK:
        raise Error(f"{name}: there is no sound in it")
    run = max(_longest_run(channel) for channel in channels)
    if run >= _CLIPPED:
        raise Error(f"{name}: it is clipped: {run} samples in a row are at its peak")
    struck = from_stroke(sound, rate)
    if len(struck) < DURATION * rate:
        raise Error(f"{name}: its stroke comes {len(struck) / rate:.3g} s before its end; {DURATION} s are needed")
    level = _envelope(struck, rate)
    rises = level[1:] - np.minimum.accumulate(level)[:-1]
    heard = level[1:] > level.max() - 20
    if np.any(heard & (rises > _RISE)) or level[len(level) // 2:].max() > level.max() - 6:
        raise Error(f"{name}: it is not one stroke that dies away")
    return Recording(name, struck, channels[:, len(sound) - len(struck):], rate)


def read_recording(path: Union[str, os.PathLike[str]]) -> Recording:
    """Reads one stroke from a sound file.

    Parameters
    ----------
    path : str or path
        A file that libsndfile reads: WAV, FLAC, AIFF and others.

    Returns
    -------
    Recording
        The mean of its channels, from the stroke on.

    Raises
    ------
    Error
        The file cannot be read, or is not one whole stroke (see `checked`).
    """
    import soundfile  # type: ignore[import-untyped,import-not-found,unused-ignore]

    try:
        sound, rate = soundfile.read(os.fspath(path), always_2d=True)
    except (OSError, RuntimeError) as wrong:
        raise Error(f"{path}: {wrong}") from None
    return checked(os.fspath(path), np.asarray(sound, np.float64).T, float(rate))
