# SPDX-License-Identifier: MIT
"""The drum that is nearest to the recordings, by the covariance matrix adaptation evolution strategy [Hansen2016].

Rounds of linear descriptions stop where the model cannot follow a recording. From there this search lowers the objective,
the mean over frequencies, decays, levels of strokes, each time window and the click of

    rho((observed_j - simulated_j) / floor_j),    rho(x) = x^2 up to 3, then a straight line [Huber1964],

so that each of these groups counts alike, however many elements it has, and 1 means: as far apart as two strokes of the
same dynamics are. The floor of a level is the scatter between strokes and between channels, at least 1 dB; of a partial,
10 cents and 10 % of its decay; of a stroke's level, 1 dB. A partial that the model lacks counts as 3 floors.
"""

from __future__ import annotations

from typing import Callable, List, NamedTuple, Sequence

import numpy as np
from numpy.typing import NDArray

from .simulation import DECAY, FREQUENCY, LEVEL, Describe

Array = NDArray[np.float64]

_FLOORS = {FREQUENCY: 10 / 1200 * np.log(2), DECAY: 0.1, LEVEL: 1.0}  # of partials, in logarithms; of strokes [dB]
_LINEAR = 3.0  # floors from which on a difference counts along a line
_LEAST, _MOST = 0.02, 0.3  # of a range: how far the search looks at first
_INSIDE = 0.02  # of a range: the search begins that far from limits
_POPULATION = 2  # times the usual one, 4 + 3 ln(parameters): the objective is rugged where partials come and go
_SPOKEN = 10  # generations between lines that say how far it is


class Objective(NamedTuple):
    """What is lowered."""

    observed: Array  #: NaN where an element is missing
    floor: Array  #: of each element
    weight: Array  #: of each element

    def of(self, simulated: Array) -> float:
        """The mean of rho."""
        used = ~np.isnan(self.observed)
        apart = np.abs((self.observed - simulated) / self.floor)[used]
        apart = np.where(np.isnan(apart), _LINEAR, apart)
        rho = np.where(apart < _LINEAR, apart**2, _LINEAR * (2 * apart - _LINEAR))
        return float(np.average(rho, weights=self.weight[used]))


def objective_of(observed: Array, groups: NDArray[np.int64], floor: Array) -> Objective:
    """The objective of a description.

    Parameters
    ----------
    observed : ndarray of float64, shape (elements,)
        The recording's.
    groups : ndarray of int64, shape (elements,)
        As of `Plan.groups`.
    floor : ndarray of float64, shape (features,)
        Of a stroke's features, with which elements end [dB].

    Returns
    -------
    Objective
        What is lowered.
    """
    floors = np.array([_FLOORS.get(int(group), np.nan) for group in groups])
    features = np.isnan(floors)
    floors[features] = np.tile(floor, np.count_nonzero(features) // len(floor))
    known = ~np.isnan(observed)
    weight = np.array([1 / max(1, int(np.count_nonzero(known & (groups == group)))) for group in groups])
    return Objective(observed, floors, weight)


class Found(NamedTuple):
    """Where the search went."""

    point: Array  #: of the lowest objective
    objective: float  #: there
    points: Array  #: all that were simulated, shape (simulations, parameters)
    vectors: Array  #: their descriptions, shape (simulations, elements)


def search(objective: Objective, start: Array, spread: Array, low: Array, high: Array, describe: Describe, generations: int,
           seed: int, say: Callable[[str], object]) -> Found:
    """Searches from a drum on.

    Parameters
    ----------
    objective : Objective
        What is lowered.
    start, spread : ndarray of float64, shape (parameters,)
        Where the search begins, and how far it looks at first.
    low, high : ndarray of float64, shape (parameters,)
        Limits.
    describe : callable
        Describes simulated recordings.
    generations : int
        How many; one has 8 + 6 ln(parameters) simulations.
    seed : int
        Of all that is drawn.
    say : callable
        Hears how far the search is.

    Returns
    -------
    Found
        The drum of the lowest objective, and all that were simulated.
    """
    from cmaes import CMA  # type: ignore[import-untyped,import-not-found,unused-ignore]

    width = high - low
    scale = np.clip(spread / width, _LEAST, _MOST)
    sigma = float(np.exp(np.mean(np.log(scale))))
    size = _POPULATION * (4 + int(3 * np.log(len(low))))
    strategy = CMA(mean=np.clip((start - low) / width, _INSIDE, 1 - _INSIDE), sigma=sigma, cov=np.diag((scale / sigma) ** 2),
                   bounds=np.column_stack([np.zeros(len(low)), np.ones(len(low))]), seed=seed, population_size=size)
    points: List[Array] = []
    vectors: List[Array] = []
    costs: List[float] = []
    for generation in range(generations):
        places = [strategy.ask() for _ in range(strategy.population_size)]
        new = [(low + width * place).round(7) for place in places]
        seen = describe(new, len(points))
        new_costs = [objective.of(simulated) for simulated in seen]
        strategy.tell(list(zip(places, new_costs)))
        points, vectors, costs = points + new, vectors + seen, costs + new_costs
        if generation % _SPOKEN == 0 or generation == generations - 1:
            say(f"search, generation {generation + 1} of {generations}: objective {min(costs):.2f}")
    best = int(np.argmin(costs))
    return Found(points[best], costs[best], np.array(points), np.array(vectors))
