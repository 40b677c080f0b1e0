# SPDX-License-Identifier: MIT
"""What is computed once for a drum and a sample rate."""

from __future__ import annotations

from typing import Any, Callable, Dict, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._library import Error, check, choice_of, ffi, fields, lib, text
from .definition import Definition

#: Qualities, from fast to exact. ``"definition"`` in their place means what ``quality.level`` of the definition says.
QUALITIES: Tuple[str, ...] = ("draft", "live", "studio", "reference")

_LEVELS = ("definition",) + QUALITIES  # as TaborQuality counts them
_PARTS = ("batter", "resonant", "both", "cavity", "rim", "plate", "bottom")

#: A mode: `m` nodal diameters, `n` nodal circles with the rim; `frequency` [Hz]; `decay_rate` of the amplitude and the
#: part of it that is radiation, `radiation_rate` [1/s]; `multiplicity`, 2 with a sine copy; the `part` that moves most;
#: `phase` of two heads, 1 together, -1 in opposition.
MODE = np.dtype([("m", "u4"), ("n", "u4"), ("frequency", "f8"), ("decay_rate", "f8"),
                 ("radiation_rate", "f8"), ("multiplicity", "u4"), ("part", "U8"), ("phase", "i4")])


class ModelEstimate(NamedTuple):
    """What building a model takes, right within a factor of 3."""

    seconds: float  #: on one core of a server of 2024
    bytes: int  #: memory while it is built
    key: str  #: the parameter that costs most of it


class ModelInfo(NamedTuple):
    """Facts of a model."""

    sample_rate: float  #: [Hz]
    step_rate: float  #: steps per second, twice the sample rate at ``"studio"`` and ``"reference"`` below 88.2 kHz
    quality: str  #: one of `QUALITIES`
    mode_count: int  #: modes; cosine and sine copies count as two
    mode_rows: int  #: rows of `Model.modes`; the two copies count as one
    two_way_bandwidth: float  #: modes up to here feel the contacts [Hz]
    bandwidth: float  #: modes up to here are heard [Hz]
    high_mode_count: int  #: modes that are heard and feel nothing
    newton_cap: int  #: iterations of the contact solve in a step, at most
    wire_count: int  #: wires
    contact_points: int  #: contact points of all wires together
    mic_count: int  #: microphones
    model_bytes: int  #: memory of the model
    drum_bytes: int  #: memory of each drum on it


def _resolved(definition: Union[Definition, str], sample_rate: Optional[float],
              quality: Optional[str]) -> Tuple[Definition, Any]:
    """The definition, and options for it."""
    if isinstance(definition, str):
        definition = Definition(definition)
    if not isinstance(definition, Definition):
        raise TypeError(f"a Definition or the name of a preset is needed, not {definition!r}")
    options = ffi.new("TaborModelOptions *")
    lib.tabor_model_options_default(options)
    if sample_rate is not None:
        options.sample_rate = sample_rate
    options.quality = choice_of(_LEVELS, "live" if quality is None else quality, "quality")
    return definition, options


#: Hears how far a build is, from 0 to 1; what it raises ends the build.
Progress = Callable[[float], object]


class _Interruption:
    """Lets Python's signal handlers and `progress` run while the library builds a model, and keeps what they raise."""

    def __init__(self, options: Any, progress: Optional[Progress]) -> None:
        self._progress = progress
        self.raised: Optional[BaseException] = None
        self._call = ffi.callback("bool(double, void *)", self._go_on, error=False, onerror=self._keep)
        options.progress = self._call

    def _go_on(self, done: float, context: Any) -> bool:
        if self._progress:
            self._progress(done)
        return True  # a signal's handler runs here, as in any Python code

    def _keep(self, kind: Any, raised: BaseException, traceback: Any) -> None:
        self.raised = raised


def _create(definition: Definition, options: Any, model: Any, progress: Optional[Progress]) -> None:
    interruption = _Interruption(options, progress)
    try:
        check(lib.tabor_model_create, definition._c, options, model)
    except Error:
        if interruption.raised is None:
            raise
        raise interruption.raised from None


class Model:
    """A definition, computed for one sample rate. It never changes; any number of drums share it.

    Parameters
    ----------
    definition : Definition or str
        The drum, or the name of a preset.
    sample_rate : float, optional
        [Hz], 22,050 to 192,000; 48,000 unless given.
    quality : {"live", "draft", "studio", "reference", "definition"}, optional
        Accuracy against cost; ``"definition"``: as ``quality.level`` of the definition says. ``"live"`` unless given.
    progress : callable, optional
        Called as ``progress(done)`` in the calling thread every few milliseconds, with `done` from 0 to 1. What it raises
        ends the build.

    Raises
    ------
    Error
        The definition, the rate or the quality is not allowed.

    Notes
    -----
    A built-in preset takes a quarter of a second at ``"live"``. Other threads go on meanwhile, and
    Ctrl-C ends it.
    """

    def __init__(self, definition: Union[Definition, str], sample_rate: Optional[float] = None,
                 quality: Optional[str] = None, *, progress: Optional[Progress] = None) -> None:
        definition, options = _resolved(definition, sample_rate, quality)
        model = ffi.new("TaborModel **")
        _create(definition, options, model, progress)
        self._take(model[0])

    def _take(self, model: Any) -> None:
        self._c = ffi.gc(model, lib.tabor_model_release)
        self._definition = Definition._of(lib.tabor_model_definition(self._c)[0])
        self._rate = self.info.sample_rate

    def __repr__(self) -> str:
        return f"<tabor.Model {self._definition['drum.name']!r}, {self._rate:g} Hz, {self.info.quality}>"

    def save(self) -> bytes:
        """Writes the model as bytes, so that a program starts without building it. Pickling does the same.

        Returns
        -------
        bytes
            For `load()` of the same version of Tabor on the same kind of machine: 1 to 4 MB for a preset at ``"live"``.
        """
        saved = ffi.new("char[]", lib.tabor_model_saved_size(self._c))
        lib.tabor_model_save(self._c, saved)
        return bytes(ffi.buffer(saved))

    @classmethod
    def load(cls, saved: bytes) -> Model:
        """Makes a model of bytes, in a hundredth of the time that building takes. It plays the same bits.

        Parameters
        ----------
        saved : bytes
            What `save()` returned.

        Returns
        -------
        Model
            As good as the one that was saved.

        Raises
        ------
        Error
            The bytes are damaged, cut off, or of another version or machine. A checksum tells damage, not malice: load
            what you saved yourself.
        """
        if isinstance(saved, str):
            raise TypeError(f"bytes are needed, not {saved!r}: read the file first")
        model = ffi.new("TaborModel **")
        check(lib.tabor_model_load, ffi.from_buffer(saved), memoryview(saved).nbytes, ffi.NULL, model)
        loaded = cls.__new__(cls)
        loaded._take(model[0])
        return loaded

    def __reduce__(self) -> Tuple[Callable[[bytes], Model], Tuple[bytes]]:
        return Model.load, (self.save(),)

    @staticmethod
    def estimate(definition: Union[Definition, str], sample_rate: Optional[float] = None,
                 quality: Optional[str] = None) -> ModelEstimate:
        """What building a model of these arguments takes, and the parameter to lower if that is too much."""
        definition, options = _resolved(definition, sample_rate, quality)
        estimate = ffi.new("TaborModelEstimate *")
        check(lib.tabor_model_estimate, definition._c, options, estimate)
        return ModelEstimate(float(estimate.seconds), int(estimate.bytes), text(estimate.key))

    @property
    def definition(self) -> Definition:
        """A copy of what the model was computed from, with tensions in the place of pitches."""
        return self._definition.copy()

    @property
    def sample_rate(self) -> float:
        """The sample rate [Hz]."""
        return self._rate

    @property
    def mics(self) -> Tuple[str, ...]:
        """Names of the microphones; the first is the usual one."""
        return self._definition.mics

    @property
    def info(self) -> ModelInfo:
        """Facts: how many modes, up to which frequency, how much memory."""
        facts: Dict[str, Any] = fields("TaborModelInfo", ModelInfo._fields, lib.tabor_model_info, self._c)
        facts["quality"] = _LEVELS[facts["quality"]]
        return ModelInfo(**facts)

    @property
    def modes(self) -> NDArray[np.void]:
        """The modes in order of frequency: an array of `MODE`, shape ``(info.mode_rows,)``."""
        row = ffi.new("TaborModeInfo *")
        modes = np.zeros(self.info.mode_rows, MODE)
        for i in range(len(modes)):
            lib.tabor_model_mode(self._c, i, row)
            modes[i] = (row.m, row.n, row.frequency, row.decay_rate, row.radiation_rate, row.multiplicity,
                        _PARTS[row.part], row.phase)
        return modes

    def mode_shape(self, row: int, radii: Union[float, Sequence[float], NDArray[np.floating]],
                   surface: int = 0) -> NDArray[np.float64]:
        """The shape of a mode along a radius, for a modal mass of 1 kg. Where it is 0, a node lies.

        Parameters
        ----------
        row : int
            One of `modes`.
        radii : float or array of float
            Distances from the centre [m].
        surface : int
            0: the batter head, or the upper plate; 1: the other one.

        Returns
        -------
        numpy.ndarray
            The shape of `radii`, in kg^-1/2: times the mode's amplitude and cos(m angle) it is the displacement.

        Raises
        ------
        ValueError
            There is no such row, surface or place; or the drum's lugs have tensions of their own.
        """
        places = np.asarray(radii, np.float64)
        shape = ffi.new("double *")
        values = np.empty(places.shape)
        for index, radius in np.ndenumerate(places):
            if not lib.tabor_model_mode_shape(self._c, row, surface, radius, shape):
                raise ValueError(f"mode {row} has no shape at {radius:g} m on surface {surface}")
            values[index] = shape[0]
        return values


#: What can be played: a preset's name, a definition, or a model.
Playable = Union[Model, Definition, str]


def model_of(playable: Playable, sample_rate: Optional[float] = None, quality: Optional[str] = None,
             progress: Optional[Progress] = None) -> Model:
    """The model itself, or one that is computed."""
    if not isinstance(playable, Model):
        return Model(playable, sample_rate, quality, progress=progress)
    if sample_rate not in (None, playable.sample_rate):
        raise ValueError(f"the model is for {playable.sample_rate:g} Hz, not for {sample_rate:g} Hz")
    if quality not in (None, playable.info.quality):
        raise ValueError(f"the model has quality {playable.info.quality!r}, not {quality!r}")
    return playable
