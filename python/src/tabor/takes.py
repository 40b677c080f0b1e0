# SPDX-License-Identifier: MIT
"""Many drums at once: jobs for threads, since the library computes while other Python goes on."""

from __future__ import annotations

import os
import threading
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ._library import Error
from .definition import Definition
from .events import strike
from .model import Model, Playable, model_of
from .rendering import Happening, Setting, frames_of, heard_mics

_Job = Callable[[], None]


class _Jobs:
    """Jobs that threads do; a job may add others, which come before those that were there."""

    def __init__(self, jobs: List[_Job], total: int) -> None:
        self._waiting = jobs[::-1]
        self._running = 0
        self._changed = threading.Condition()
        self.error: Optional[BaseException] = None
        self.total = total
        self.done = 0

    def stopped(self) -> bool:
        """True once a job has failed, or all are given up."""
        return self.error is not None

    def go_on(self, done: float) -> None:
        """Hears of a model's build, and ends it once the jobs are given up."""
        if self.stopped():
            raise InterruptedError("the jobs are given up")

    def add(self, jobs: Sequence[_Job]) -> None:
        """Adds jobs, to be done in this order."""
        with self._changed:
            self._waiting += jobs[::-1]
            self._changed.notify_all()

    def count(self) -> None:
        """One of the total is done."""
        with self._changed:
            self.done += 1
            self._changed.notify_all()

    def stop(self, error: BaseException) -> None:
        """Gives up what waits."""
        with self._changed:
            self.error = self.error or error
            self._waiting.clear()
            self._changed.notify_all()

    def _next(self) -> Optional[_Job]:
        with self._changed:
            while not self._waiting and self._running and not self.stopped():
                self._changed.wait()
            if not self._waiting:
                return None
            self._running += 1
            return self._waiting.pop()

    def work(self) -> None:
        """Does jobs until there are none, in a thread."""
        while True:
            job = self._next()
            if job is None:
                return
            try:
                job()
            except BaseException as error:  # raised again where the threads were started
                self.stop(error)
            with self._changed:
                self._running -= 1
                self._changed.notify_all()

    def wait(self, done: int) -> int:
        """Waits until more are done than this, or all has ended; how many are done."""
        with self._changed:
            while self.done == done < self.total and not self.stopped():
                self._changed.wait()
            return self.done


def _run(jobs: _Jobs, workers: int, progress: Optional[Callable[[int, int], object]]) -> None:
    threads = [threading.Thread(target=jobs.work, name=f"tabor-{i}", daemon=True) for i in range(workers)]
    for thread in threads:
        thread.start()
    try:
        done = 0
        while done < jobs.total and not jobs.stopped():
            done = jobs.wait(done)
            if progress and not jobs.stopped():
                progress(done, jobs.total)
    except BaseException as error:  # of progress, or an interrupt
        jobs.stop(error)
    for thread in threads:
        thread.join()
    if jobs.error is not None:
        raise jobs.error


def _same(drums: Sequence[Playable]) -> List[Tuple[Playable, List[int]]]:
    """The different drums, each with its places: equal definitions share a model."""
    places: Dict[Any, Tuple[Playable, List[int]]] = {}
    for i, drum in enumerate(drums):
        key = drum._fingerprint() if isinstance(drum, Definition) else drum
        places.setdefault(key, (drum, []))[1].append(i)
    return list(places.values())


def _processors() -> int:
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on every system
        return os.cpu_count() or 1


def _marked(error: Error, index: int) -> Error:
    error.index = index
    return error


class _Sounds:
    """The sounds of a kit: drums, takes, microphones, frames; without a number of frames each has its own length."""

    def __init__(self, drums: int, takes: int, rows: int, frames: Optional[int]) -> None:
        self._shape = (drums, takes, rows)
        self._out = None if frames is None else np.zeros(self._shape + (frames,), np.float32)
        self._apart: Dict[Tuple[int, int], NDArray[np.float32]] = {}

    def play(self, setting: Setting, events: Happening, places: Sequence[int], take: int,
             stopped: Callable[[], bool]) -> None:
        """Plays a take, whose sound is that of several equal drums. Threads play different takes or drums."""
        if self._out is None:
            sound = setting.ring_out(events, stopped)
            self._apart.update({(place, take): sound for place in places})
            return
        setting.play(events, self._out[places[0], take], stopped)
        for place in places[1:]:
            self._out[place, take] = self._out[places[0], take]

    def all(self) -> NDArray[np.float32]:
        """All in one array."""
        if self._out is not None:
            return self._out
        longest = max((sound.shape[1] for sound in self._apart.values()), default=0)
        out = np.zeros(self._shape + (longest,), np.float32)
        for (place, take), sound in self._apart.items():
            out[place, take, :, :sound.shape[1]] = sound
        return out


def render_takes(drums: Sequence[Playable], takes: Optional[Sequence[Happening]] = None,
                 duration: Optional[float] = None, *, mics: Optional[Sequence[str]] = None,
                 sample_rate: Optional[float] = None, quality: Optional[str] = None, workers: Optional[int] = None,
                 progress: Optional[Callable[[int, int], object]] = None) -> NDArray[np.float32]:
    """Renders every take on every drum, in parallel. Each drum is computed once.

    Parameters
    ----------
    drums : sequence of Model, Definition or str
        The drums; those that are equal are computed once.
    takes : sequence of sequences of Event, or of names of MIDI files, optional
        What happens in each take, which begins on a drum at rest; one take of one stroke unless given.
    duration : float, optional
        Of each take [s]. Unless given, each rings out, as by `render`; zeros follow those that are shorter than the
        longest.
    mics : sequence of str, optional
        Names of the microphones, which all drums must have; the usual one of each drum unless given.
    sample_rate : float, optional
        [Hz]; 48,000 unless given. Models have their own, which must be the same.
    quality : {"live", "draft", "studio", "reference", "definition"}, optional
        Accuracy against cost; ``"live"`` unless given.
    workers : int, optional
        Threads; as many as there are processors unless given.
    progress : callable, optional
        Called as ``progress(done, total)`` in the calling thread, after takes.

    Returns
    -------
    ndarray of float32, shape (len(drums), len(takes), len(mics), frames)
        The sounds, as by `render`, with the same bits whatever `workers` is.

    Raises
    ------
    Error
        A definition is not allowed; `Error.key` says why, `Error.index` which. The other takes are given up.

    Examples
    --------
    >>> drums = [tabor.Definition("frame-drum", {"batter.tension": tension}) for tension in (2000, 3000)]
    >>> tabor.render_takes(drums, [[tabor.strike(velocity=1)], [tabor.strike(velocity=4)]], duration=0.25).shape
    (2, 2, 1, 12000)
    """
    if isinstance(drums, (str, Definition, Model)):
        raise TypeError("drums is a sequence, as [drum]")
    if isinstance(takes, (str, os.PathLike)):
        raise TypeError(f"takes is a sequence, as [{takes!r}]")
    takes = [[strike()]] if takes is None else takes
    workers = _processors() if workers is None else workers
    if workers < 1:
        raise ValueError(f"workers {workers}: allowed: 1 or more")
    given = [drum.sample_rate for drum in drums if isinstance(drum, Model)]
    rate = sample_rate if sample_rate is not None else (given or [48000.0])[0]
    rows = 1 if mics is None else len(mics)
    frames = None if duration is None else frames_of(duration, rate)
    sounds = _Sounds(len(drums), len(takes), rows, frames)

    def play(setting: Setting, places: Sequence[int], take: int) -> _Job:
        def job() -> None:
            sounds.play(setting, takes[take], places, take, jobs.stopped)
            for _ in places:
                jobs.count()
        return job

    def build(drum: Playable, places: Sequence[int]) -> _Job:
        def job() -> None:
            try:
                model = model_of(drum, rate, quality, jobs.go_on)
                setting = Setting(model, heard_mics(model, mics))
            except Error as error:
                raise _marked(error, places[0]) from None
            jobs.add([play(setting, places, take) for take in range(len(takes))])
        return job

    jobs = _Jobs([build(drum, places) for drum, places in _same(drums)], len(drums) * len(takes))
    _run(jobs, workers, progress)
    return sounds.all()
