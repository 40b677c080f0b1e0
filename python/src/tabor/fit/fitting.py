# SPDX-License-Identifier: MIT
"""A fit from beginning to end."""

from __future__ import annotations

import math
import os
from typing import Callable, Dict, List, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits  # type: ignore[import-untyped,import-not-found,unused-ignore]

from .._library import Error, version
from ..definition import Definition
from .features import noise_of
from .journal import Journal, digest
from .modal_fit import ModalFit, fit_partials
from .partials import Partials, find_partials
from .parameters import Space
from .recordings import Stroke
from .request import Request
from .rounds import Round, run_rounds
from .scatter import Scatter, scatter_of
from .simulation import DIGITS, Plan, describe_partials, simulate

Array = NDArray[np.float64]

_SIMULATED = 3  # strokes of a simulated recording, at most


class Settings(NamedTuple):
    """How much is computed."""

    counts: Tuple[int, ...] = (45, 40, 40)  #: simulations of each round
    jobs: int = 1  #: threads
    seed: int = 1  #: of all that is drawn
    quality: str = "live"  #: of the simulations


class Estimate(NamedTuple):
    """One parameter, or what follows from several."""

    key: str  #: of a definition; or a ratio of two keys, with a slash; or a head's loss
    value: float  #: the middle of what is likely, in the unit of the key
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
    rounds: Tuple[Round, ...]
    definition: Definition
    estimates: Tuple[Estimate, ...]
    speeds: Tuple[float, ...]  #: of the request's strokes [m/s]

    @property
    def surprise(self) -> float:
        """Squared distance of the recording from what the model can follow, 1 if it can."""
        return self.rounds[-1].posterior.surprise


def loudness_of(strokes: Sequence[Stroke], are_levels_known: bool) -> List[float]:
    """Parts of the hardest stroke's speed, as the peaks have it; or places among the strokes, 0 to 1."""
    if not are_levels_known:
        return list(np.linspace(0.0, 1.0, len(strokes))) if len(strokes) > 1 else [1.0]
    peaks = [float(np.abs(stroke.recordings[0].sound).max()) for stroke in strokes]
    return [peak / max(peaks) for peak in peaks]


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
    partials, modal = first_stage(request)
    # Last bits of linear algebra differ from run to run, and would draw other points.
    modal = modal._replace(point=modal.point.round(7), covariance=modal.covariance.round(9))
    say(f"{len(partials.frequency)} partials, {sum(label is not None for label in modal.labels)} of them modes")
    loudness = loudness_of(request.strokes, request.are_levels_known)
    scatter = scatter_of(request.strokes, loudness)
    chosen = _chosen(len(request.strokes))
    noise = tuple(np.mean([noise_of(stroke.recordings[mic].sound, stroke.recordings[mic].rate) for stroke in request.strokes], axis=0)
                  for mic in range(len(request.mics)))
    labels = tuple(label for label in dict.fromkeys(modal.labels) if label is not None)
    plan = Plan(request.space, request.rate, request.mics, tuple(loudness[index] for index in chosen),
                request.are_levels_known, noise, labels, settings.quality)
    observed = np.concatenate([describe_partials(plan, [request.strokes[index] for index in chosen], modal.modes),
                               scatter.smooth[chosen].ravel()]).round(DIGITS)
    os.makedirs(folder, exist_ok=True)
    journal = Journal(os.path.join(folder, "journal.jsonl"), _task(request, plan, observed, settings), settings.jobs)
    total = sum(settings.counts)

    def describe_points(points: Sequence[Array], done: int) -> List[Array]:
        say(f"simulations {done + 1} to {done + len(points)} of {total}")
        return journal.describe("round", lambda point, seed: simulate(plan, point, seed), points, done)

    try:
        rounds = run_rounds(request.space, modal, observed, describe_points, settings.counts, settings.seed)
    finally:
        journal.close()
    point = rounds[-1].posterior.samples.mean(axis=0)
    every = plan._replace(loudness=tuple(loudness))
    return Fit(request, partials, modal, scatter, rounds, request.space.definition(point),
               _estimates(request.space, rounds[-1].posterior.samples), tuple(every.speeds(point)))


def _estimate(key: str, samples: Array, least: float, most: float) -> Estimate:
    """Of the logarithms of one quantity and of its limits."""
    low, middle, high = (float(one) for one in np.quantile(samples, [0.05, 0.5, 0.95]))
    return Estimate(key, math.exp(middle), math.exp(low), math.exp(high), math.exp(least), math.exp(most),
                    high - low <= 0.5 * (most - least))


def _estimates(space: Space, samples: Array) -> Tuple[Estimate, ...]:
    """Of all parameters, then of tension over density of both heads."""
    found = [_estimate(key, samples[:, index], float(space.low[index]), float(space.high[index]))
             for index, key in enumerate(space.keys)]
    for head in ("batter", "resonant"):
        names = (f"{head}.tension", f"{head}.surface_density")
        if all(name in space.keys for name in names):
            over, under = (space.keys.index(name) for name in names)
            found.append(_estimate("/".join(names), samples[:, over] - samples[:, under],
                                   float(space.low[over] - space.high[under]), float(space.high[over] - space.low[under])))
    return tuple(found)


def _task(request: Request, plan: Plan, observed: Array, settings: Settings) -> str:
    known: Dict[str, object] = dict(request.space.base)
    return digest(version(), sorted(known.items()), request.space.keys, request.space.low, request.space.high, plan.loudness,
                  plan.labels, observed, settings.seed, settings.quality)
