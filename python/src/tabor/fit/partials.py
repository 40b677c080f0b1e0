# SPDX-License-Identifier: MIT
"""Partials of strokes: frequencies, decays and energies that all strokes share.

A drum that rings is a sum of damped sines, whose frequencies and decays are the same in every stroke while their
amplitudes differ. Shift invariance of the signals' common subspace (ESPRIT [RoyKailath1989]) gives both at once. The head's pitch
glides at first, so the strokes are looked at from 0.1 s on, below 800 Hz.
"""

from __future__ import annotations

from typing import NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from .._library import Error
from .recordings import Recording

_SKIP, _LENGTH = 0.1, 0.45  # from the stroke on [s]
_TOP, _STOP = 800.0, 1000.0  # the band ends between these [Hz]
_RATE = 2400.0  # of the band [Hz]
_ROWS = 400  # of the trajectory matrix
_ORDER = 40  # poles, twice the partials
_LEAST_LEVEL = -42.0  # below the strongest [dB]
_LOWEST, _HIGHEST = 40.0, 620.0  # of the partials that are taken [Hz]
_REACH = 6.0  # times the strongest: above, modes of large drums lie too close together to be told apart
_DECAYS = (0.5, 70.0)  # [1/s]
_APART = 0.03  # of a frequency: a glide and a room leave weak poles beside a strong one


class Partials(NamedTuple):
    """Partials in order of frequency; all arrays have as many elements."""

    frequency: NDArray[np.float64]  #: [Hz]
    decay_rate: NDArray[np.float64]  #: of the amplitude [1/s]
    level: NDArray[np.float64]  #: energy below the strongest, in the mean over the strokes [dB]
    highest: float  #: they were looked for up to here [Hz]


def _band(recording: Recording) -> NDArray[np.float64]:
    """The band of the window, at _RATE, with the mean square 1."""
    first = int(_SKIP * recording.rate)
    sound = recording.sound[first:first + int(2 * _LENGTH * recording.rate)]
    spectrum = np.fft.rfft(sound)
    frequencies = np.fft.rfftfreq(len(sound), 1 / recording.rate)
    spectrum *= np.cos(0.5 * np.pi * np.clip((frequencies - _TOP) / (_STOP - _TOP), 0, 1)) ** 2
    count = int(len(sound) / recording.rate * _RATE)
    band = np.fft.irfft(spectrum[:count // 2 + 1], count)[:int(_LENGTH * _RATE)]
    return np.asarray(band / np.sqrt(np.mean(band**2)))


def _poles(bands: Sequence[NDArray[np.float64]]) -> NDArray[np.complex128]:
    rows = min(_ROWS, min(len(band) for band in bands) // 2)
    covariance = np.zeros((rows, rows))
    for band in bands:
        trajectory = np.ascontiguousarray(np.lib.stride_tricks.sliding_window_view(band, rows).T)
        covariance += trajectory @ trajectory.T
    basis = np.linalg.eigh(covariance)[1][:, -_ORDER:]
    shift = np.linalg.lstsq(basis[:-1], basis[1:], rcond=None)[0]
    poles = np.linalg.eigvals(shift)
    return np.asarray(poles[(poles.imag > 1e-6) & (np.abs(poles) < 1)])


def _levels(poles: NDArray[np.complex128], decays: NDArray[np.float64],
            bands: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    pairs = np.log(np.concatenate([poles, poles.conj()]))
    energy = np.zeros(len(poles))
    for band in bands:
        waves = np.exp(np.outer(np.arange(len(band)), pairs))
        amplitude = np.linalg.lstsq(waves, band.astype(complex), rcond=None)[0][:len(poles)]
        energy += np.abs(amplitude) ** 2 / np.maximum(decays, _DECAYS[0])
    return np.asarray(10 * np.log10(energy / energy.max() + 1e-20))


def find_partials(recordings: Sequence[Recording]) -> Partials:
    """Finds the partials that all strokes have.

    Parameters
    ----------
    recordings : sequence of Recording
        One stroke or several, on the same drum.

    Returns
    -------
    Partials
        Those within 42 dB of the strongest, from 40 to 620 Hz or to six times its frequency.

    Raises
    ------
    Error
        Fewer than four partials were found.
    """
    bands = [_band(recording) for recording in recordings]
    poles = _poles(bands)
    frequency, decay = np.angle(poles) * _RATE / (2 * np.pi), -np.log(np.abs(poles)) * _RATE
    level = _levels(poles, decay, bands)
    kept = (level > _LEAST_LEVEL) & (frequency > _LOWEST) & (frequency < _HIGHEST) & (decay > _DECAYS[0]) & (decay < _DECAYS[1])
    highest = min(_HIGHEST, _REACH * float(frequency[kept][level[kept].argmax()])) if np.any(kept) else _HIGHEST
    kept &= frequency < highest
    beside = np.abs(np.log(frequency[:, None] / frequency[None])) < _APART
    kept &= ~np.any(beside & kept[None] & (level[None] > level[:, None]), axis=1)
    if np.count_nonzero(kept) < 4:
        raise Error(f"only {np.count_nonzero(kept)} partials between {_LOWEST:g} and {highest:.0f} Hz ring on after {_SKIP} s; "
                    "a drum has four or more")
    order = np.flatnonzero(kept)[np.argsort(frequency[kept])]
    return Partials(frequency[order], decay[order], level[order], highest)
