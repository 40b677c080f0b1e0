# SPDX-License-Identifier: MIT
"""Simulations that are kept as they are made, so that a fit that was ended goes on where it was.

All that is drawn comes of a seed, so a fit that starts again asks for the same simulations in the same order and finds
those that are there. A line of the file is a simulation; a line that was cut off is made again.
"""

from __future__ import annotations

import hashlib
import json
import os
from concurrent.futures import ThreadPoolExecutor
from typing import Callable, Dict, List, Sequence

import numpy as np
from numpy.typing import NDArray

from .._library import Error

Array = NDArray[np.float64]

#: Describes the simulated recording of a point with a seed.
Simulate = Callable[[Array, int], Array]


def digest(*parts: object) -> str:
    """A name for what these stand for."""
    text = "\n".join(part.tobytes().hex() if isinstance(part, np.ndarray) else repr(part) for part in parts)
    return hashlib.sha256(text.encode()).hexdigest()[:24]


class Journal:
    """A file of simulations.

    Parameters
    ----------
    path : str
        Name of the file; what is in it is used.
    task : str
        What the simulations are for: those of another task are refused.
    jobs : int
        Threads.

    Raises
    ------
    Error
        The file cannot be written, or is of another task.
    """

    def __init__(self, path: str, task: str, jobs: int) -> None:
        self._known: Dict[str, List[float]] = {}
        self._jobs = jobs
        whole = self._read(path, task)
        try:
            self._file = open(path, "r+b" if whole else "wb")
        except OSError as wrong:
            raise Error(f"{path}: {wrong.strerror}") from None
        self._file.truncate(whole)
        self._file.seek(whole)
        if not whole:
            self._write({"task": task})

    def _read(self, path: str, task: str) -> int:
        """Reads whole lines; how many bytes they are."""
        if not os.path.exists(path):
            return 0
        with open(path, "rb") as file:
            content = file.read()
        whole = content.rfind(b"\n") + 1
        lines = content[:whole].splitlines()
        if not lines:
            return 0
        try:
            its_task = json.loads(lines[0])["task"]
            for line in lines[1:]:
                row = json.loads(line)
                self._known[row["of"]] = [np.nan if value is None else value for value in row["vector"]]
        except (ValueError, KeyError, TypeError):
            raise Error(f"{path} is no journal of a fit: remove it, or write into another folder") from None
        if its_task != task:
            raise Error(f"{path} is of another request, or of another version: remove it, or write into another folder")
        return whole

    def _write(self, row: Dict[str, object]) -> None:
        self._file.write(json.dumps(row).encode() + b"\n")
        self._file.flush()

    def describe(self, kind: str, simulate: Simulate, points: Sequence[Array], first_seed: int) -> List[Array]:
        """Describes simulated recordings of points, each with the next seed.

        Parameters
        ----------
        kind : str
            Name of the function.
        simulate : callable
            Describes one.
        points : sequence of ndarray of float64
            What is simulated.
        first_seed : int
            Of the first point.

        Returns
        -------
        list of ndarray of float64
            Descriptions, the same whatever the number of threads.
        """
        names = [digest(kind, point, first_seed + index) for index, point in enumerate(points)]
        missing = [index for index, name in enumerate(names) if name not in self._known]
        with ThreadPoolExecutor(self._jobs) as pool:
            for index, vector in zip(missing, pool.map(lambda index: simulate(points[index], first_seed + index), missing)):
                self._known[names[index]] = [float(value) for value in vector]
                self._write({"of": names[index], "vector": [None if np.isnan(value) else float(value) for value in vector]})
        return [np.array(self._known[name]) for name in names]

    def close(self) -> None:
        """Closes the file."""
        self._file.close()
