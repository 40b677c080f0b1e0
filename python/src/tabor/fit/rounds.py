# SPDX-License-Identifier: MIT
"""Rounds of simulated recordings, each nearer to the recording than the one before."""

from __future__ import annotations

from typing import Callable, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .inference import Posterior, infer
from .modal_fit import ModalFit
from .parameters import Space

Array = NDArray[np.float64]

#: Describes simulated recordings of points; the second argument counts all simulations before them.
Describe = Callable[[Sequence[Array], int], List[Array]]

_WIDER = 1.5  # than what is known: where the next round simulates


class Round(NamedTuple):
    """One of them."""

    points: Array
    vectors: Array
    posterior: Posterior


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
               seed: int) -> Tuple[Round, ...]:
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
    tuple of Round
        The last one knows most.
    """
    random = np.random.default_rng(seed)
    rounds: List[Round] = []
    done = 0
    for count in counts:
        if rounds:
            samples = rounds[-1].posterior.samples
            drawn = samples[random.choice(len(samples), count)]
            points = _reflected(samples.mean(axis=0) + _WIDER * (drawn - samples.mean(axis=0)), space.low, space.high)
        else:
            points = _first_points(space, fit, count, random)
        points = points.round(7)  # as descriptions are: see simulation.DIGITS
        vectors = np.array(describe(list(points), done))
        done += count
        before = rounds[-1:]
        near, seen = (np.concatenate([*[getattr(one, part) for one in before], new])
                      for part, new in (("points", points), ("vectors", vectors)))
        rounds.append(Round(points, vectors, infer(near, seen, observed, space.low, space.high, random)))
    return tuple(rounds)
