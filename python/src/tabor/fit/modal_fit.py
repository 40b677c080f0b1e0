# SPDX-License-Identifier: MIT
"""Tensions, masses and losses whose modes have the partials' frequencies and decays: the first stage, in closed form.

The engine computes the modes of a drum in some 30 ms. Each partial is compared with the mode that is nearest in frequency
and decay among those that a stroke makes heard. The search begins on a grid of both tensions, between whose points
frequencies and decays are interpolated, and goes on from the best places by Gauss and Newton's method with Cauchy weights.
Parameters equally likely within limits stand in the equations as Gaussians of the same variance.

What comes out is a Gaussian around the best drum, widened by what the residuals exceed the expected errors. The
expected errors of a partial were measured on simulated toms in rooms: 0.05 % of the frequency for the strongest, more for
weaker and faster ones.
"""

from __future__ import annotations

from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from .._library import Error
from ..model import Model
from .parameters import Space
from .partials import Partials

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

_SCAN_TOP, TOP = 450.0, 700.0  # of the modes that are computed on the grid, and later, at most [Hz]
_ABOVE = 1.13  # times the highest partial: modes that may belong to it
_GRID, _FINE = 5, 49  # tensions of each head that are computed and interpolated
_STARTS, _KEPT = 3, (3, 2, 1)  # places where the search begins, and those that it keeps as it comes closer
_APART = 0.15  # of the starts, in logarithms of tension
# Of frequencies that may belong together: as steps come closer.
_FAR, _NEAR = (0.04, 0.02, 0.01), (0.01, 0.006)
DECAY_WIDTH = 0.7
_FARTHEST = 9.0  # squared distance of a partial that belongs to no mode
_HEARD = -20.0  # modes that radiate less than this below the loudest are not expected [dB]
_MISSING = -12.0  # modes that are louder than this should be found [dB]
_STEP = 0.01  # of a derivative
_MOST_LOST = 0.45  # part of the partials' weight that may fit no mode
_HALVINGS = 2  # of a step that leads away
_HEADS = ("batter.tension", "resonant.tension")
_FITTED = ("batter.", "resonant.")  # what modes hang on


class Modes(NamedTuple):
    """Those of a drum that a stroke makes heard."""

    labels: Tuple[Tuple[int, int], ...]  #: nodal diameters, and the how manyth of them, from 0
    frequency: Array  #: logarithm
    decay: Array  #: logarithm of the rate
    level: Array  #: expected energy below the loudest [dB]


class ModalFit(NamedTuple):
    """The drum whose modes are nearest."""

    point: Array  #: of the space
    covariance: Array  #: of the parameters; those that modes do not hang on are independent, and as wide as their limits
    labels: Tuple[Optional[Tuple[int, int]], ...]  #: of each partial's mode, None where it fits none
    modes: Modes


def modes_of(model: Model, radius: float, top: float) -> Modes:
    """The modes of heads below a frequency.

    Parameters
    ----------
    model : Model
        A drum with heads.
    radius : float
        Where it is struck [m].
    top : float
        [Hz].

    Returns
    -------
    Modes
        In order of frequency.
    """
    table = model.modes
    rows = np.flatnonzero((table["frequency"] < top) & (table["part"] != "rim"))
    table = table[rows]
    shape = np.array([model.mode_shape(int(row), [radius])[0] for row in rows])
    energy = shape**2 * table["radiation_rate"] / table["decay_rate"]
    seen = [int(np.sum(table["m"][:row] == table["m"][row])) for row in range(len(rows))]
    return Modes(tuple(zip(map(int, table["m"]), seen)), np.log(table["frequency"]), np.log(table["decay_rate"]),
                 10 * np.log10(energy / max(float(energy.max(initial=0.0)), 1e-300) + 1e-12))


class _Search:
    def __init__(self, space: Space, partials: Partials) -> None:
        self.space, self.partials = space, partials
        self.heads = [space.keys.index(key) for key in _HEADS if key in space.keys]
        self.placing = [index for index, key in enumerate(space.keys) if key.endswith((".tension", ".surface_density"))
                        and key.startswith(_FITTED)]
        self.fitted = [index for index, key in enumerate(space.keys) if key.startswith(_FITTED)]
        self.frequency, self.decay = np.log(partials.frequency), np.log(partials.decay_rate)
        self.top = min(TOP, _ABOVE * partials.highest)
        self.scan_top = min(_SCAN_TOP, self.top)
        level, decay = partials.level, partials.decay_rate
        self.frequency_error = np.minimum(5e-4 * 10 ** (-level / 45) * (1 + (decay / 8) ** 3), 0.03)
        self.decay_error = np.minimum(0.1 * 10 ** (-level / 90) * (1 + (decay / 10) ** 2), 1.0)
        self.weight = (level + 45) / 45
        self._known: Dict[bytes, Modes] = {}

    def modes(self, point: Array, top: float) -> Modes:
        key = point.tobytes() + bytes(str(top), "ascii")
        if key not in self._known:
            self._known[key] = self._modes(point, top)
        return self._known[key]

    def _modes(self, point: Array, top: float) -> Modes:
        drum = self.space.definition(point)
        drum["wires.count"] = 0
        drum["quality.two_way_bandwidth"] = drum["quality.bandwidth"] = top
        return modes_of(Model(drum, quality="draft"), float(drum["strike.radius"]), top)

    def match(self, modes: Modes, width: float) -> Tuple[Indices, Array]:
        """The mode of each partial, and the squared distance to it."""
        distance = ((self.frequency[:, None] - modes.frequency) / width) ** 2
        distance += ((self.decay[:, None] - modes.decay) / DECAY_WIDTH) ** 2
        distance += np.clip((_HEARD - modes.level) / 10, 0, None) ** 2
        nearest = distance.argmin(axis=1)
        return nearest, distance[np.arange(len(nearest)), nearest]

    def cost(self, modes: Modes, width: float, top: float) -> float:
        inside = self.partials.frequency < top
        nearest, distance = self.match(modes, width)
        loud = np.flatnonzero((modes.level > _MISSING) & (modes.frequency < np.log(min(top, self.partials.highest))))
        missing = np.setdiff1d(loud, nearest[inside])
        return float(np.sum((self.weight * np.minimum(distance, _FARTHEST))[inside]) + 2 * len(missing))

    def step(self, point: Array, free: Sequence[int], width: float) -> Tuple[Array, Array]:
        """One step of Gauss and Newton's method, and the covariance there."""
        modes = self.modes(point, self.top)
        nearest, distance = self.match(modes, width)
        used = distance < _FARTHEST
        labels = [modes.labels[mode] for mode in nearest[used]]
        scale = np.concatenate([np.maximum(self.frequency_error, 0.1 * width)[used], self.decay_error[used]])
        here = np.concatenate([(self.frequency - modes.frequency[nearest])[used],
                               (self.decay - modes.decay[nearest])[used]]) / scale
        slopes = np.zeros((len(here), len(free)))
        for column, index in enumerate(free):
            moved = point.copy()
            moved[index] += _STEP
            slopes[:, column] = self._slope(modes, self.modes(moved, self.top), labels) / scale
        low, high = self.space.low[free], self.space.high[free]
        robust = 1 / (1 + (here / 3) ** 2)
        precision = np.diag(12 / (high - low) ** 2)
        curvature = (slopes.T * robust) @ slopes + precision
        pull = (slopes.T * robust) @ here - precision @ (point[free] - 0.5 * (low + high))
        spread = max(1.0, float(np.sum(robust * here**2) / max(1.0, np.sum(robust) - 0.5 * len(free))))
        after = point.copy()
        after[free] = np.clip(point[free] + np.linalg.solve(curvature, pull), low, high)
        before = self.cost(modes, width, self.top)
        for _ in range(_HALVINGS):
            if self.cost(self.modes(after, self.top), width, self.top) <= before:
                break
            after = 0.5 * (point + after)
        return after, spread * np.linalg.inv(curvature)

    @staticmethod
    def _slope(here: Modes, there: Modes, labels: Sequence[Tuple[int, int]]) -> Array:
        """Of the labelled modes' frequencies, then decays; 0 for one that left the band."""
        before, after = dict(zip(here.labels, range(len(here.labels)))), dict(zip(there.labels, range(len(there.labels))))
        pairs = [(before[label], after.get(label, -1)) for label in labels]
        parts = [[(b[j] - a[i]) / _STEP if j >= 0 else 0.0 for i, j in pairs]
                 for a, b in ((here.frequency, there.frequency), (here.decay, there.decay))]
        return np.array(parts[0] + parts[1])

    def starts(self, middle: Array) -> List[Array]:
        """Places apart from each other whose tensions fit best."""
        if not self.heads:
            return [middle]
        lines = [np.linspace(self.space.low[head], self.space.high[head], _GRID) for head in self.heads]
        scan = _Scan(self, middle, lines)
        fine = [np.linspace(line[0], line[-1], _FINE) for line in lines]
        points = np.stack(np.meshgrid(*fine, indexing="ij"), axis=-1).reshape(-1, len(fine))
        costs = np.array([self.cost(scan.modes(place), _FAR[0], self.scan_top) for place in points])
        chosen: List[Array] = []
        for place in points[np.argsort(costs, kind="stable")]:
            if all(np.abs(place - other).max() > _APART for other in chosen):
                chosen.append(place)
            if len(chosen) == _STARTS:
                break
        starts = []
        for place in chosen:
            start = middle.copy()
            start[self.heads] = place
            starts.append(start)
        return starts

    def run(self) -> ModalFit:
        middle = 0.5 * (self.space.low + self.space.high)
        points = self.starts(middle)
        for width, kept in zip(_FAR, _KEPT):
            points = [self.step(point, self.placing, width)[0] for point in points]
            points = sorted(points, key=lambda point: self.cost(self.modes(point, self.top), _NEAR[0], self.top))[:kept]
        point = points[0]
        for width in _NEAR:
            point, part = self.step(point, self.fitted, width)
        covariance = np.diag((self.space.high - self.space.low) ** 2 / 12)
        covariance[np.ix_(self.fitted, self.fitted)] = part
        modes = self.modes(point, self.top)
        nearest, distance = self.match(modes, _NEAR[0])
        return ModalFit(point, covariance, tuple(modes.labels[mode] if far < _FARTHEST else None
                                                 for mode, far in zip(nearest, distance)), modes)


class _Scan:
    """Modes on a grid of tensions, interpolated between its points."""

    def __init__(self, search: _Search, middle: Array, lines: Sequence[Array]) -> None:
        self.lines = lines
        places = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1)
        found = {}
        for index in np.ndindex(places.shape[:-1]):
            point = middle.copy()
            point[search.heads] = places[index]
            found[index] = search.modes(point, search.scan_top)
        self.labels = tuple(sorted({label for modes in found.values() for label in modes.labels}))
        # A mode above the band lies at its upper end, unheard.
        self.values = np.full((*places.shape[:-1], len(self.labels), 3), [np.log(1.2 * search.scan_top), 3.0, -60.0])
        for index, modes in found.items():
            rows = [self.labels.index(label) for label in modes.labels]
            self.values[index][rows] = np.stack([modes.frequency, modes.decay, modes.level], axis=1)

    def modes(self, place: Array) -> Modes:
        values = self.values
        for line, at in zip(self.lines, place):
            index = min(int(np.searchsorted(line, at, side="right")) - 1, len(line) - 2)
            part = (at - line[index]) / (line[index + 1] - line[index])
            values = (1 - part) * values[index] + part * values[index + 1]
        return Modes(self.labels, values[:, 0], values[:, 1], values[:, 2])


def fit_partials(space: Space, partials: Partials) -> ModalFit:
    """Looks for the drum that has these partials.

    Parameters
    ----------
    space : Space
        What is looked for, of a drum with heads; wires are left out.
    partials : Partials
        Of the recordings.

    Returns
    -------
    ModalFit
        The drum and how well it is known.

    Raises
    ------
    Error
        Half of the partials fit no mode of such a drum, and no wires lie on it.
    """
    search = _Search(space, partials)
    fit = search.run()
    lost = np.array([label is None for label in fit.labels])
    if np.sum(search.weight[lost]) <= _MOST_LOST * np.sum(search.weight):
        return fit
    if space.base["wires.count"] and space.base["wires.strainer"]:
        return _unknown(space, fit)
    some = ", ".join(f"{one:.0f}" for one in partials.frequency[lost][:4])
    raise Error(f"the partials at {some} Hz belong to no drum like '{space.base['drum.name']}': is it of these dimensions, "
                "and is it the only one that sounds?")


def _unknown(space: Space, fit: ModalFit) -> ModalFit:
    """Wires rattle at all frequencies: where their noise hides the modes, partials say nothing."""
    return ModalFit(0.5 * (space.low + space.high), np.diag((space.high - space.low) ** 2 / 12), (None,) * len(fit.labels), fit.modes)
