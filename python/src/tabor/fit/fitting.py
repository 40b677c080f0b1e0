# SPDX-License-Identifier: MIT
"""A fit from beginning to end."""

from __future__ import annotations

import contextlib
import math
import os
from typing import Callable, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits  # type: ignore[import-untyped,import-not-found,unused-ignore]

from .._library import Error, version
from ..definition import Definition
from .features import noises_of
from .inference import Posterior, infer
from .journal import Journal, digest
from .modal_fit import ModalFit, fit_partials
from .partials import Partials, find_partials
from .parameters import Space, derived
from .recordings import Stroke
from .request import Request
from .rounds import run_rounds
from .scatter import Scatter, scatter_of
from .search import Objective, objective_of, search
from .simulation import DIGITS, Describe, Plan, describe_partials, levels_of, simulate

Array = NDArray[np.float64]

_SIMULATED = 3  # strokes of a simulated recording, at most
_FOLLOWED = 1.5  # objective from which on rounds have not found the drum, and a search goes on
_NEAR = 12  # simulations for each parameter, near the drum that a search found: the posterior is learnt from them


class Settings(NamedTuple):
    """How much is computed."""

    counts: Tuple[int, ...] = (45, 40, 40)  #: simulations of each round
    generations: int = 100  #: of a search where rounds do not follow the recording; 0: none
    jobs: int = 1  #: threads
    seed: int = 1  #: of all that is drawn
    quality: str = "live"  #: of the simulations


class Estimate(NamedTuple):
    """One parameter, or what follows from several."""

    key: str  #: of a definition; or a ratio of two keys, with a slash; or a head's loss
    value: float  #: the preset's, in the unit of the key
    low: float  #: its 90 % interval begins here
    high: float  #: and ends here
    least: float  #: it was looked for from here
    most: float  #: to here
    determined: bool  #: the interval is at most half as wide as where it was looked for, in logarithms


class Fit(NamedTuple):
    """What was found."""

    request: Request
    partials: Partials
    modal: ModalFit
    scatter: Scatter
    surprise: float  #: squared distance of the recording from what the last simulations can follow, 1 if they can
    objective: float  #: of the drum (see the module search): 1 if it is as far from the strokes as they are from each other
    definition: Definition
    estimates: Tuple[Estimate, ...]
    speeds: Tuple[float, ...]  #: of the request's strokes [m/s]


def loudness_of(strokes: Sequence[Stroke], are_levels_known: bool) -> List[float]:
    """Parts of the hardest stroke's peak; or places among the strokes, 0 to 1."""
    if not are_levels_known:
        return list(np.linspace(0.0, 1.0, len(strokes))) if len(strokes) > 1 else [1.0]
    return [float(stroke.peaks()[0] / strokes[-1].peaks()[0]) for stroke in strokes]


def _chosen(count: int) -> List[int]:
    """Strokes that are simulated: from soft to hard."""
    return sorted(set(np.linspace(0, count - 1, min(count, _SIMULATED)).round().astype(int).tolist()))


def first_stage(request: Request) -> Tuple[Partials, ModalFit]:
    """Partials of the first microphone, and the drum whose modes have them."""
    partials = find_partials([stroke.recordings[0] for stroke in request.strokes])
    return partials, fit_partials(request.space, partials)


def fit(request: Request, folder: str, settings: Settings, say: Callable[[str], object] = lambda text: None) -> Fit:
    """Finds the drum of recordings.

    Parameters
    ----------
    request : Request
        The recordings, and what is known.
    folder : str
        Where simulations are kept, to go on with; it is made.
    settings : Settings
        How much is computed.
    say : callable
        Hears a line about each stage.

    Returns
    -------
    Fit
        The drum, and what is known of it.

    Raises
    ------
    Error
        The recordings are not of such a drum, or the folder cannot be written.
    """
    with threadpool_limits(1):  # how many threads do linear algebra decides its last bits, and so what is simulated
        return _fit(request, folder, settings, say)


def _fit(request: Request, folder: str, settings: Settings, say: Callable[[str], object]) -> Fit:
    least = 2 * len(request.space.keys)
    if min(settings.counts) < least:
        raise Error(f"a round of {min(settings.counts)} simulations: {len(request.space.keys)} parameters take {least} or more")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as wrong:
        raise Error(f"{folder}: {wrong.strerror}") from None
    try:
        partials, modal = first_stage(request)
    except Error:
        with contextlib.suppress(OSError):
            os.rmdir(folder)  # if nothing is in it
        raise
    # Last bits of linear algebra differ from run to run, and would draw other points.
    modal = modal._replace(point=modal.point.round(7), covariance=modal.covariance.round(9))
    say(f"{len(partials.frequency)} partials, {sum(label is not None for label in modal.labels)} of them modes")
    loudness = loudness_of(request.strokes, request.are_levels_known)
    scatter = scatter_of(request.strokes, loudness)
    chosen = _chosen(len(request.strokes))
    noise = tuple(noises_of(request.strokes[index]) for index in chosen)
    labels = tuple(label for label in dict.fromkeys(modal.labels) if label is not None)
    plan = Plan(request.space, request.rate, request.mics, tuple(loudness[index] for index in chosen),
                request.are_levels_known, noise, labels, settings.quality)
    strokes = [request.strokes[index] for index in chosen]
    peaks = np.array([stroke.peaks() for stroke in strokes])
    observed = np.concatenate([describe_partials(partials, modal.modes, labels), levels_of(peaks, request.are_levels_known),
                               scatter.smooth[chosen].ravel()]).round(DIGITS)
    journal = Journal(os.path.join(folder, "journal.jsonl"), _task(request, plan, observed, settings), settings.jobs)
    total = sum(settings.counts)

    def describe_points(points: Sequence[Array], done: int) -> List[Array]:
        if done < total:
            say(f"simulations {done + 1} to {done + len(points)} of {total}")
        return journal.describe("round", lambda point, seed: simulate(plan, point, seed), points, done)

    try:
        posterior = run_rounds(request.space, modal, observed, describe_points, settings.counts, settings.seed)
        point = posterior.samples.mean(axis=0)
        objective = objective_of(observed, plan.groups(), scatter.floor)
        apart = objective.of(describe_points([point.round(7)], total)[0])
        say(f"objective {apart:.2f}")
        if apart > _FOLLOWED and settings.generations:
            # The same noise and room in each, so that drums are compared.
            def describe_alike(points: Sequence[Array], done: int) -> List[Array]:
                return journal.describe("search", lambda point, seed: simulate(plan, point, settings.seed), points, done)

            point, apart, posterior = _searched(request.space, objective, posterior, describe_alike, settings, say)
    finally:
        journal.close()
    every = plan._replace(loudness=tuple(loudness))
    drum = request.space.definition(point)
    drum["strike.velocity"] = every.speeds(point)[-1]
    return Fit(request, partials, modal, scatter, posterior.surprise, apart, drum,
               _estimates(request.space, posterior.samples, point), tuple(every.speeds(point)))


def _searched(space: Space, objective: Objective, posterior: Posterior, describe_points: Describe, settings: Settings,
              say: Callable[[str], object]) -> Tuple[Array, float, Posterior]:
    """The drum that a search finds, its objective, and what the simulations around it say of the recording."""
    found = search(objective, posterior.samples.mean(axis=0), posterior.samples.std(axis=0), space.low, space.high,
                   describe_points, settings.generations, settings.seed, say)
    enough = _NEAR * len(space.keys)
    if len(found.points) >= enough:
        away = np.linalg.norm((found.points - found.point) / (space.high - space.low), axis=1)
        near = np.sort(np.argsort(away, kind="stable")[:enough])
        posterior = infer(found.points[near], found.vectors[near], objective.observed, space.low, space.high,
                          np.random.default_rng(settings.seed))
    return found.point, found.objective, posterior


def _estimate(key: str, samples: Array, value: float, least: float, most: float) -> Estimate:
    """Of the logarithms of one quantity and of its limits."""
    low, high = (float(one) for one in np.quantile(samples, [0.05, 0.95]))
    low, high = min(low, value), max(high, value)
    return Estimate(key, math.exp(value), math.exp(low), math.exp(high), math.exp(least), math.exp(most),
                    high - low <= 0.5 * (most - least))


def _estimates(space: Space, samples: Array, point: Array) -> Tuple[Estimate, ...]:
    """Of all parameters, then of what follows from them."""
    found = [_estimate(key, samples[:, index], float(point[index]), float(space.low[index]), float(space.high[index]))
             for index, key in enumerate(space.keys)]
    rows = np.vstack([point, samples])
    others = {key: np.log(values) for key, values in derived(space.base, dict(zip(space.keys, np.exp(rows.T)))).items()}
    # A density divides: its limits are the other way round.
    ends = [np.where([key.endswith("density") for key in space.keys], *both) for both in
            ((space.high, space.low), (space.low, space.high))]
    least, most = (derived(space.base, space.values(end)) for end in ends)
    found += [_estimate(key, values[1:], float(values[0]), float(np.log(least[key])), float(np.log(most[key])))
              for key, values in others.items()]
    return tuple(found)


def _task(request: Request, plan: Plan, observed: Array, settings: Settings) -> str:
    known = {key: value for key, value in dict(request.space.base).items() if not key.startswith("drum.")}
    return digest(version(), sorted(known.items()), request.space.keys, request.space.low, request.space.high, plan.loudness,
                  plan.labels, observed, settings.seed, settings.quality)
