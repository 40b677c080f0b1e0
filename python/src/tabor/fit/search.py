# SPDX-License-Identifier: MIT
"""The drum that is nearest to the recordings, by the covariance matrix adaptation evolution strategy [Hansen2016].

Rounds of linear descriptions stop where the model cannot follow a recording. From there this search lowers the objective,
the mean over frequencies, decays, levels of strokes, each time window and the click of

    rho((observed_j - simulated_j) / floor_j),    rho(x) = x^2 up to 3, then a straight line [Huber1964],

so that each of these groups counts alike, however many elements it has, and 1 means: as far apart as two strokes of the
same dynamics are. The floor of a level is the scatter between strokes and between channels, at least 1 dB; of a partial,
10 cents and 10 % of its decay; of a stroke's level, 1 dB. A partial that the model lacks counts as 3 floors.

The objective is a sum of squares, which the strategy does not know: a straight line of each element through the last
simulations has its lowest places near by, and these are injected into each generation [Hansen2011]. So they are taken if they
are good, and cost little if elements are not straight there.
"""

from __future__ import annotations

from typing import Any, Callable, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .simulation import DECAY, FREQUENCY, LEVEL, Describe

Array = NDArray[np.float64]

_FLOORS = {FREQUENCY: 10 / 1200 * np.log(2), DECAY: 0.1, LEVEL: 1.0}  # of partials, in logarithms; of strokes [dB]
_LINEAR = 3.0  # floors from which on a difference counts along a line
_LEAST, _MOST = 0.02, 0.3  # of a range: how far the search looks at first
_INSIDE = 0.02  # of a range: the search begins that far from limits
_POPULATION = 2  # times the usual one, 4 + 3 ln(parameters): the objective is rugged where partials come and go
_RECENT = 5  # simulations for each parameter, of the last ones, through which straight lines are laid
_LINED = 1.5  # simulations for each parameter, at least
_TRUSTED = (2.0, 1.0)  # standard deviations of these, as far as the lines are followed
_ITERATIONS = 10  # in which Huber's weights settle
_DOUBT = 0.1  # of so many simulations, that elements do not change: few tell little of slopes
_LEAST_DAMPING = 1e-3  # of the mean curvature
_ENOUGH = 1.0  # objective at which it ends: strokes of the same dynamics are no nearer to each other
_SPOKEN = 10  # generations between lines that say how far it is


class Objective(NamedTuple):
    """What is lowered."""

    observed: Array  #: NaN where an element is missing
    floor: Array  #: of each element
    weight: Array  #: of each element

    @property
    def weights(self) -> Array:
        """Of the observed elements."""
        return self.weight[~np.isnan(self.observed)]

    def apart(self, simulated: Array) -> Array:
        """How many floors the observed elements are above the simulated ones, shape (..., observed elements)."""
        used = ~np.isnan(self.observed)
        return np.asarray((self.observed[used] - simulated[..., used]) / self.floor[used])

    def of(self, simulated: Array) -> float:
        """The mean of rho."""
        apart = np.abs(self.apart(simulated))
        apart = np.where(np.isnan(apart), _LINEAR, apart)
        rho = np.where(apart < _LINEAR, apart**2, _LINEAR * (2 * apart - _LINEAR))
        return float(np.average(rho, weights=self.weights))


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


def _straight(objective: Objective, steps: Array, vectors: Array, best: int) -> Tuple[Array, Array]:
    """A straight line of each element through the best simulation: how far it is there, and its slopes along the steps.

    Near simulations count more. Where an element is missing, it counts as unchanged.
    """
    apart = objective.apart(vectors)
    here, change = np.nan_to_num(apart[best]), np.nan_to_num(apart - apart[best])
    near = 1 / (1 + np.mean(steps**2, axis=1))
    square = (steps.T * near) @ steps + _DOUBT * np.mean(near) * np.eye(steps.shape[1])
    return here, np.linalg.solve(square, (steps.T * near) @ change)


def _step(here: Array, slopes: Array, weight: Array, trusted: float) -> Array:
    """The step to the lowest place, by iterated weights."""
    step = np.zeros(len(slopes))
    for _ in range(_ITERATIONS):
        size = np.abs(here + step @ slopes)
        weighted = slopes * (weight * np.minimum(1.0, _LINEAR / np.maximum(size, 1e-9)))
        step = _within(trusted, weighted @ slopes.T, -weighted @ here)
    return step


def _within(trusted: float, curvature: Array, pull: Array) -> Array:
    """The step to the lowest place of a parabola, damped until it is short enough (Levenberg and Marquardt's method)."""
    damping = _LEAST_DAMPING * float(np.trace(curvature)) / len(pull) + 1e-12
    step = np.linalg.solve(curvature + damping * np.eye(len(pull)), pull)
    while np.linalg.norm(step) > trusted:
        damping *= 2
        step = np.linalg.solve(curvature + damping * np.eye(len(pull)), pull)
    return np.asarray(step)


class _Seen(NamedTuple):
    """All simulations."""

    places: List[Array]  #: as parts of the ranges
    vectors: List[Array]
    costs: List[float]

    def lowest(self, objective: Objective, last: int) -> List[Array]:
        """Where straight lines through the `last` simulations are lowest, as far from the best of them as they are trusted."""
        places, best = np.array(self.places[-last:]), int(np.argmin(self.costs[-last:]))
        unit = places.std(axis=0) + 1e-9
        here, slopes = _straight(objective, (places - places[best]) / unit, np.array(self.vectors[-last:]), best)
        return [np.clip(places[best] + unit * _step(here, slopes, objective.weights, trusted), 0, 1) for trusted in _TRUSTED]


class Found(NamedTuple):
    """Where the search went."""

    point: Array  #: of the lowest objective
    objective: float  #: there
    points: Array  #: all that were simulated, shape (simulations, parameters)
    vectors: Array  #: their descriptions, shape (simulations, elements)


def _strategy(middle: Array, scale: Array, seed: int) -> Any:
    """The evolution strategy within the ranges, from a place on."""
    from cmaes import CMA  # type: ignore[import-untyped,import-not-found,unused-ignore]

    count, sigma = len(middle), float(np.exp(np.mean(np.log(scale))))
    return CMA(mean=np.clip(middle, _INSIDE, 1 - _INSIDE), sigma=sigma, cov=np.diag((scale / sigma) ** 2),
               bounds=np.column_stack([np.zeros(count), np.ones(count)]), seed=seed,
               population_size=_POPULATION * (4 + int(3 * np.log(count))))


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
        How many at most; one has 8 + 6 ln(parameters) simulations.
    seed : int
        Of all that is drawn.
    say : callable
        Hears how far the search is.

    Returns
    -------
    Found
        The drum of the lowest objective, and all that were simulated.
    """
    width = high - low
    scale = np.clip(spread / width, _LEAST, _MOST)
    seen = _Seen([], [], [])
    strategy = _strategy((start - low) / width, scale, seed)
    for generation in range(generations):
        places = [strategy.ask() for _ in range(strategy.population_size)]
        if len(seen.costs) >= _LINED * len(low):
            places[:len(_TRUSTED)] = seen.lowest(objective, _RECENT * len(low))
        vectors = describe([(low + width * place).round(7) for place in places], len(seen.costs))
        costs = [objective.of(simulated) for simulated in vectors]
        strategy.tell(list(zip(places, costs)))
        seen = _Seen(seen.places + places, seen.vectors + vectors, seen.costs + costs)
        lowest = min(seen.costs)
        ends = lowest <= _ENOUGH or generation == generations - 1
        if generation % _SPOKEN == 0 or ends:
            say(f"search, generation {generation + 1} of {generations}: objective {lowest:.2f}")
        if ends:
            break
    best = int(np.argmin(seen.costs))
    points = (low + width * np.array(seen.places)).round(7)
    return Found(points[best], seen.costs[best], points, np.array(seen.vectors))
