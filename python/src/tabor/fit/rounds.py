# SPDX-License-Identifier: MIT
"""Rounds of simulated recordings, each nearer to the recording than the one before."""

from __future__ import annotations

from typing import Sequence

import numpy as np
from numpy.typing import NDArray

from .inference import Posterior, infer
from .modal_fit import ModalFit
from .parameters import Space
from .simulation import Describe

Array = NDArray[np.float64]

_WIDER = 1.5  # than what is known: where the next round simulates


def _reflected(points: Array, low: Array, high: Array) -> Array:
    """Within the limits."""
    width = high - low
    place = np.mod(points - low, 2 * width)
    return np.asarray(low + np.minimum(place, 2 * width - place))


def _first_points(space: Space, fit: ModalFit, count: int, random: np.random.Generator) -> Array:
    """Around what the partials say; elsewhere equally likely."""
    points = random.multivariate_normal(fit.point, _WIDER**2 * fit.covariance, count)
    wide = np.array([not key.startswith(("batter.", "resonant.")) for key in space.keys])
    points[:, wide] = random.uniform(space.low[wide], space.high[wide], (count, int(wide.sum())))
    return _reflected(points, space.low, space.high)


def run_rounds(space: Space, fit: ModalFit, observed: Array, describe: Describe, counts: Sequence[int],
               seed: int) -> Posterior:
    """Simulates and learns.

    Parameters
    ----------
    space : Space
        What is looked for.
    fit : ModalFit
        What the partials say of it.
    observed : ndarray of float64
        Description of the recording.
    describe : callable
        Describes simulated recordings.
    counts : sequence of int
        Simulations of each round.
    seed : int
        Of all that is drawn.

    Returns
    -------
    Posterior
        What the last two rounds say.
    """
    random = np.random.default_rng(seed)
    points = _first_points(space, fit, counts[0], random)
    near, seen = points[:0], np.empty((0, len(observed)))
    done = 0
    for index, count in enumerate(counts):
        points = points.round(7)  # as descriptions are: see simulation.DIGITS
        vectors = np.array(describe(list(points), done))
        done += count
        posterior = infer(np.concatenate([near, points]), np.concatenate([seen, vectors]), observed, space.low, space.high, random)
        near, seen = points, vectors
        if index + 1 < len(counts):
            samples = posterior.samples
            drawn = samples[random.choice(len(samples), counts[index + 1])]
            points = _reflected(samples.mean(axis=0) + _WIDER * (drawn - samples.mean(axis=0)), space.low, space.high)
    return posterior
