# SPDX-License-Identifier: MIT
"""What a recording says of parameters, learnt from simulated recordings.

Near the drum that is looked for, each element s_j of a description changes in proportion to the parameters theta:

    s = a + B theta + e,    e of covariance R,

which N simulated recordings show, with rooms, noise and unknown speeds among e. The best linear estimate of theta from s
is E s, E = (B' R^-1 B)^-1 B' R^-1 with a shrunk R [LedoitWolf2004]. How well it estimates is measured on simulations that it
has not seen (cross-validation): E s = c + D theta + u there, with u of covariance U. Parameters equally likely within
limits, with u of Student's distribution of N - d degrees of freedom [PriceEtAl2018], give the posterior distribution, from
which hit-and-run [ChenSchmeiser1996] draws. So a parameter that a recording does not determine keeps its limits, and
what is nonlinear or random widens an interval.
"""

from __future__ import annotations

from typing import NamedTuple, Tuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri  # type: ignore[import-untyped,import-not-found,unused-ignore]

Array = NDArray[np.float64]

_FOLDS = 5
_SHRINKAGE = (0.05, 0.2, 0.5, 1.0)  # of R towards its diagonal: the one that estimates best is taken
_MISSING = 0.3  # of the simulations: an element that is missing in more of them is left out
_RIDGE = 1e-6
_CHAINS, _SWEEPS = 400, 60


class Description(NamedTuple):
    """How a description hangs on parameters, near a drum."""

    middle: Array  #: of the points
    offset: Array  #: a
    slopes: Array  #: B, shape (elements, parameters)
    covariance: Array  #: R


def _filled(points: Array, vectors: Array) -> Array:
    """Missing values become what the others' line says."""
    filled = vectors.copy()
    design = np.column_stack([np.ones(len(points)), points - points.mean(axis=0)])
    for column in np.flatnonzero(np.isnan(vectors).any(axis=0)):
        known = ~np.isnan(vectors[:, column])
        line = _line(design[known], vectors[known][:, [column]])
        filled[~known, column] = (design[~known] @ line)[:, 0]
    return filled


def _line(design: Array, values: Array) -> Array:
    square = design.T @ design
    square[np.diag_indices_from(square)] += _RIDGE * np.trace(square) / len(square)
    return np.asarray(np.linalg.solve(square, design.T @ values))


def _describe(points: Array, vectors: Array, shrinkage: float) -> Description:
    middle = points.mean(axis=0)
    design = np.column_stack([np.ones(len(points)), points - middle])
    line = _line(design, vectors)
    rest = vectors - design @ line
    covariance = rest.T @ rest / max(1, len(points) - design.shape[1])
    diagonal = np.diag(np.maximum(np.diag(covariance), 1e-12))
    return Description(middle, line[0], line[1:].T, (1 - shrinkage) * covariance + shrinkage * diagonal)


def _estimate(description: Description, precision: Array, vectors: Array) -> Array:
    """Of the parameters, with a weak pull towards the middle where the description says nothing."""
    weighted = np.linalg.solve(description.covariance, description.slopes)
    square = description.slopes.T @ weighted + precision
    return np.asarray((vectors - description.offset) @ weighted @ np.linalg.inv(square).T + description.middle)


def _cross_validated(points: Array, vectors: Array, precision: Array, shrinkage: float) -> Array:
    estimates = np.empty_like(points)
    for fold in range(_FOLDS):
        held = np.arange(len(points)) % _FOLDS == fold
        description = _describe(points[~held], vectors[~held], shrinkage)
        estimates[held] = _estimate(description, precision, vectors[held])
    return estimates


class Posterior(NamedTuple):
    """What is known of the parameters."""

    samples: Array  #: shape (samples, parameters)
    surprise: float  #: of the observed description: its squared distance per element, 1 if the model can follow it


def _hit_and_run(middle: Array, spread: Array, mean: Array, covariance: Array, low: Array, high: Array, freedom: int,
                 random: np.random.Generator) -> Array:
    """Draws theta from the limits, where mean = middle + spread theta + u."""
    count = len(low)
    precision = np.linalg.inv(covariance)
    curvature = spread.T @ precision @ spread
    pull = spread.T @ precision @ (mean - middle)
    # Directions: those of the curvature, scaled, which reach along narrow ridges, and those of the parameters.
    values, vectors = np.linalg.eigh(0.5 * (curvature + curvature.T) + np.diag(1 / (high - low) ** 2))
    values = np.maximum(values, values.max() * 1e-12)
    directions = np.concatenate([(vectors / np.sqrt(values)).T, np.diag(high - low)])
    points = random.uniform(low, high, (_CHAINS, count))
    best = np.clip(np.linalg.solve(curvature + np.diag(12 / (high - low) ** 2), pull + (6 * (high + low)) / (high - low) ** 2), low, high)
    points = best + 0.05 * (points - best)
    kept = []
    for sweep in range(_SWEEPS):
        # Student's distribution is a normal one of a random width, here drawn as the points have it.
        rest = mean - middle - points @ spread.T
        size = np.einsum("ci,ij,cj->c", rest, precision, rest)
        width = random.chisquare(freedom + count, _CHAINS) / (freedom + size)
        for direction in directions[random.permutation(len(directions))]:
            with np.errstate(divide="ignore", invalid="ignore"):
                ends = np.sort([(low - points) / direction, (high - points) / direction], axis=0)
            ends[:, :, direction == 0] = np.array([-np.inf, np.inf])[:, None, None]
            first, last = ends[0].max(axis=1), ends[1].min(axis=1)
            stiff = width * float(direction @ curvature @ direction) + 1e-12
            centre = width * ((pull - points @ curvature) @ direction) / stiff
            points = points + _truncated(centre, 1 / np.sqrt(stiff), first, last, random)[:, None] * direction
            points = np.clip(points, low, high)
        if sweep >= _SWEEPS // 2 and sweep % 3 == 0:
            kept.append(points)
    return np.concatenate(kept).round(7)


def _truncated(mean: Array, deviation: Array, first: Array, last: Array, random: np.random.Generator) -> Array:
    """Normal variables between limits."""
    low, high = (first - mean) / deviation, (last - mean) / deviation
    flip = low > 0  # the lower tail has the better numbers
    low, high = np.where(flip, -high, low), np.where(flip, -low, high)
    below, above = ndtr(low), ndtr(high)
    drawn = ndtri(below + random.uniform(size=len(mean)) * (above - below))
    drawn = np.clip(np.where(np.isfinite(drawn), drawn, high), low, high)
    return np.asarray(mean + deviation * np.where(flip, -drawn, drawn))


def infer(points: Array, vectors: Array, observed: Array, low: Array, high: Array,
          random: np.random.Generator) -> Posterior:
    """What an observed description says of the parameters.

    Parameters
    ----------
    points : ndarray of float64, shape (simulations, parameters)
        Of simulated recordings.
    vectors : ndarray of float64, shape (simulations, elements)
        Their descriptions; NaN where an element is missing.
    observed : ndarray of float64, shape (elements,)
        Description of the recording; NaN where an element is missing.
    low, high : ndarray of float64, shape (parameters,)
        Limits.
    random : numpy.random.Generator
        What draws.

    Returns
    -------
    Posterior
        Samples, and how well the model can follow the recording.
    """
    used = ~np.isnan(observed) & (np.isnan(vectors).mean(axis=0) <= _MISSING)
    used[used] = np.nanstd(vectors[:, used], axis=0) > 1e-9
    seen, recorded = _filled(points, vectors[:, used]), observed[used]
    precision = np.diag(1 / (high - low) ** 2)
    shrinkage, estimates = _best_shrinkage(points, seen, precision)
    description = _describe(points, seen, shrinkage)
    estimate = _estimate(description, precision, recorded[None])[0]
    found = _describe(points, estimates, 0.0)  # c, D and U
    freedom = max(1, len(points) - len(low) - 1)
    nearest = description.offset + description.slopes @ (estimate - description.middle)
    surprise = float(np.mean((recorded - nearest) ** 2 / np.diag(description.covariance)))
    covariance = found.covariance * max(1.0, surprise)  # what the model cannot follow makes all less certain
    samples = _hit_and_run(found.offset - found.slopes @ found.middle, found.slopes, estimate, covariance, low, high, freedom, random)
    return Posterior(samples, surprise)


def _best_shrinkage(points: Array, vectors: Array, precision: Array) -> Tuple[float, Array]:
    found = []
    scale = np.maximum(points.std(axis=0), 1e-9)
    for shrinkage in _SHRINKAGE:
        estimates = _cross_validated(points, vectors, precision, shrinkage)
        error = float(np.mean(np.log(np.mean(((estimates - points) / scale) ** 2, axis=0))))
        found.append((error, shrinkage, estimates))
    best = min(found, key=lambda one: one[0])
    return best[1], best[2]
