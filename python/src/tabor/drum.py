# SPDX-License-Identifier: MIT
"""A drum that sounds."""

from __future__ import annotations

import threading
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._library import Error, check, choice_of, ffi, fields, index_of, lib, saved_state, text
from ._numbers import whole
from ._pieces import Piece, pieces
from .definition import Definition
from .events import TECHNIQUES, TYPES, Event, Placed, live_parameter, place
from .model import Model, model_of

#: What moves, a row a sample, after it: `time` [s]; `head`, `wire`, `striker`, heights [m] over the undeflected head;
#: `striker_force`, `wire_force` [N]; stored `energy` [J]. NaN where there is no such part.
TRACE = np.dtype([(name, "f8") for name in
                  ("time", "head", "wire", "striker", "striker_force", "wire_force", "energy")])

_NO_MIC = 255  # an output without microphone
_MOST_FRAMES = 2**31 - 1
_PLAIN_FIELDS = ("id", "velocity", "radius", "angle")
_VALUE_FIELDS = ("pressure", "seconds", "strength", "value", "factor")  # one of them is the library's `value`


class Ledger(NamedTuple):
    """Where the energy went [J]: injected + control = stored + the losses + radiated + removed + residual."""

    injected: float  #: kinetic energy of launched strikers, and work of pressing hands
    control: float  #: work of changed parameters, silences and swaps
    stored: float  #: above the rest state
    head_loss: float  #: in the heads' material
    wire_loss: float  #: in the wires' material
    contact_loss: float  #: in contacts of wires and strikers
    damper_loss: float  #: in damping and pressing hands
    shell_loss: float  #: in hoop, shell and enclosed air
    radiated: float  #: as sound
    removed: float  #: of strikers that were taken away
    high_band: float  #: stored in the one-way high band; not part of the balance
    residual: float  #: what the numerics lost (positive) or created (negative)


class Statistics(NamedTuple):
    """Counters since creation or reset."""

    frames: int  #: frames played, sleeping ones included
    slept_frames: int  #: frames played asleep
    strikes: int  #: strokes begun
    late_events: int  #: past the end of a block
    misordered_events: int  #: out of order
    dropped_events: int  #: not carried out: too many at once, or nothing was free for them
    solves: int  #: steps with a contact to solve
    newton_iterations: int  #: sum over the solves
    newton_max: int  #: most in one step
    newton_capped: int  #: solves that reached the cap
    work_corrected: int  #: of these, those whose forces were scaled to create no energy
    fallbacks: int  #: of these, those that were replaced by safe steps
    guarded: int  #: steps shortened by the energy guard
    recovered: int  #: resets after a state that was not finite
    contact_sum: int  #: touching points, summed over the solves
    contact_max: int  #: most touching points in one step
    in_play: int  #: strikers and damping hands in play now


class Probe(NamedTuple):
    """Positions and forces now; NaN where there is no such part."""

    head: float  #: height of the centre of the head with the wires [m]
    wire: float  #: height of the first wire's midpoint [m]
    striker: float  #: height of the newest striker in play [m]
    striker_force: float  #: between all strikers and head or hoop [N]
    wire_force: float  #: between all wires and the head [N]


def ledger_of(drum: Any) -> Ledger:
    """That of a TaborDrum, which may be one of a kit."""
    return Ledger(**fields("TaborLedger", Ledger._fields, lib.tabor_drum_ledger, drum))


def statistics_of(drum: Any) -> Statistics:
    """Those of a TaborDrum, which may be one of a kit."""
    return Statistics(**fields("TaborStatistics", Statistics._fields, lib.tabor_drum_statistics, drum))


def routed(mics: Sequence[str], wanted: Sequence[str]) -> bytes:
    """The microphone of each output, as the library wants it; none where the drum has none of this name."""
    return bytes(mics.index(name) if name in mics else _NO_MIC for name in wanted)


def chosen(mics: Sequence[str], wanted: Optional[Sequence[str]]) -> Tuple[str, ...]:
    """The microphones that were asked for, all unless any were; ValueError if one is not there, or twice."""
    if wanted is None:
        return tuple(mics)
    if isinstance(wanted, str):
        raise TypeError(f"mics is a list of names, as [{wanted!r}]")
    for name in wanted:
        index_of(mics, name, "microphone")
    if len(set(wanted)) != len(wanted):
        raise ValueError(f"a microphone is named twice: {', '.join(wanted)}")
    return tuple(wanted)


def pointers(rows: NDArray[np.float32]) -> Any:
    """Pointers to the rows of an array, for the library."""
    array = ffi.new("float *[]", int(lib.TABOR_MAX_MICS))
    for row, samples in enumerate(rows):
        array[row] = ffi.cast("float *", samples.ctypes.data)
    return array


def check_rows(rows: NDArray[np.float32], shape: Tuple[int, int]) -> None:
    """Raises TypeError or ValueError unless the library can write such rows."""
    if not isinstance(rows, np.ndarray):
        raise TypeError(f"out: an array is needed, not {rows!r}")
    fits = rows.dtype == np.float32 and rows.shape == shape and rows.flags.writeable
    if not fits or (shape[1] > 1 and rows.strides[1] != 4):
        raise ValueError(f"out: a writable float32 array of shape {shape} with contiguous rows is needed, "
                         f"not {rows.dtype} of shape {rows.shape}")


class Drum:
    """One sounding drum, at rest to begin with.

    Parameters
    ----------
    model : Model, Definition or str
        What it sounds like; a definition or a preset's name is computed at 48 kHz and ``"live"``.
    mics : sequence of str, optional
        Names of the microphones that are the rows of its sound; all of the model's unless given.

    Notes
    -----
    The sound does not depend on its division into blocks. Threads take turns at one drum; several drums play at the
    same time.

    Examples
    --------
    >>> drum = tabor.Drum("frame-drum", mics=["left", "right"])
    >>> block = drum.process(64, [tabor.strike(velocity=4)])
    >>> block.shape
    (2, 64)
    """

    def __init__(self, model: Union[Model, Definition, str], mics: Optional[Sequence[str]] = None) -> None:
        self._model = model_of(model)
        self._mics = chosen(self._model.mics, mics)
        drum = ffi.new("TaborDrum **")
        check(lib.tabor_drum_create, self._model._c, drum)
        self._swaps: List[Any] = []  # under way
        self._c = ffi.gc(drum[0], _destroyer(self._swaps))
        self._lock = threading.Lock()
        lib.tabor_drum_route(self._c, routed(self._model.mics, self._mics), len(self._mics))

    def __repr__(self) -> str:
        with self._lock:
            model, played = self._model, statistics_of(self._c).frames / self._model.sample_rate
            state = "silent" if lib.tabor_drum_is_silent(self._c) else "sounding"
        name = model.definition["drum.name"]
        return (f"<tabor.Drum {name!r}, {model.sample_rate:g} Hz, {model.info.quality}, "
                f"mics {', '.join(self._mics)}, {state} after {played:.3f} s>")

    @property
    def model(self) -> Model:
        """The model: the first one, or the last that it was swapped to."""
        return self._model

    @property
    def mics(self) -> Tuple[str, ...]:
        """Names of the microphones that are the rows of its sound."""
        return self._mics

    def process(self, frames: int, events: Sequence[Event] = (),
                out: Optional[NDArray[np.float32]] = None) -> NDArray[np.float32]:
        """Plays on.

        Parameters
        ----------
        frames : int
            How many samples.
        events : sequence of Event
            What happens meanwhile; an event at t seconds acts at frame t x rate. Of those at one frame the first
            acts first.
        out : ndarray of float32, shape (len(mics), frames), optional
            Where to write; each row contiguous.

        Returns
        -------
        ndarray of float32, shape (len(mics), frames)
            Sound pressure; 1.0 is ``output.full_scale`` pascals. `out`, if it was given.

        Raises
        ------
        ValueError
            An event is later than these frames, or needs what the drum has not. The drum then stays as it is.
        KeyboardInterrupt
            Ctrl-C, or what else a signal's handler raises, ends the call after some milliseconds of sound. The drum can be
            used: it has played the frames that `statistics` counts, with their events, and none of the later ones. `out` has
            their sound.
        """
        frames = whole("process: frames", frames, 0, _MOST_FRAMES)
        if out is None:
            out = np.empty((len(self._mics), frames), np.float32)
        check_rows(out, (len(self._mics), frames))
        self._play(place(events, self._model.sample_rate, frames), out)
        return out

    def _play(self, placed: Sequence[Placed], out: NDArray[np.float32]) -> None:
        """As `process`, into an array that fits, with events that have their frames."""
        with self._lock:
            prepared = self._prepare(placed)
            try:
                for piece in pieces(out.shape[1], list(prepared.events)):
                    self._advance(prepared, piece, pointers(out[:, piece.start:piece.start + piece.frames]))
            finally:
                self._settle(prepared)

    def _advance(self, prepared: _Prepared, piece: Piece, rows: Any) -> None:
        """Plays the next piece."""
        end = piece.first + piece.events
        self._swaps += [swap for swap in prepared.swaps[piece.first:end] if swap is not None]
        lib.tabor_drum_process(self._c, prepared.events + piece.first, piece.events, rows, piece.frames)

    def trace(self, frames: int, events: Sequence[Event] = ()) -> NDArray[np.void]:
        """Plays on and returns what moves, instead of the sound.

        Parameters
        ----------
        frames : int
            How many samples.
        events : sequence of Event
            What happens meanwhile, as for `process`.

        Returns
        -------
        ndarray of TRACE, shape (frames,)
            A row after each sample.

        Raises
        ------
        ValueError, KeyboardInterrupt
            As from `process`.
        """
        frames = whole("trace: frames", frames, 0, _MOST_FRAMES)
        placed = place(events, self._model.sample_rate, frames)
        rows = np.zeros(frames, TRACE)
        with self._lock:
            prepared = self._prepare(placed)
            try:
                self._trace(prepared, rows)
            finally:
                self._settle(prepared)
        return rows

    def _trace(self, prepared: _Prepared, rows: NDArray[np.void]) -> None:
        """Plays sample by sample, and fills a row after each."""
        probe, ledger = ffi.new("TaborProbe *"), ffi.new("TaborLedger *")
        start = statistics_of(self._c).frames + 1
        for piece in pieces(len(rows), list(prepared.events), 1):
            self._advance(prepared, piece, ffi.NULL)
            lib.tabor_drum_probe(self._c, probe)
            lib.tabor_drum_ledger(self._c, ledger)
            rows[piece.start:piece.start + piece.frames] = (
                (start + piece.start) / self._model.sample_rate, probe.head, probe.wire, probe.striker,
                probe.striker_force, probe.wire_force, ledger.stored)

    def _prepare(self, placed: Sequence[Placed]) -> _Prepared:
        """The events for the library. Changes nothing, so that an event may be refused."""
        models, swaps, made = [self._model], [], []
        for frame, event in placed:
            model = models[-1]
            values = _values(frame, event, model)
            swap = None
            if "model" in event.fields:
                models.append(event.fields["model"])
                swap = values["swap"] = self._swap(model, models[-1])
            swaps.append(swap)
            made.append(values)
        return _Prepared(ffi.new("TaborEvent[]", made), swaps, models)

    def _swap(self, old: Model, new: Model) -> Any:
        swap = ffi.new("TaborSwap **")
        check(lib.tabor_swap_create, old._c, new._c, swap)
        owned = ffi.gc(swap[0], lib.tabor_swap_destroy)
        lib.tabor_swap_route(owned, routed(new.mics, self._mics), len(self._mics))
        return owned

    def _settle(self, prepared: _Prepared) -> None:
        """The model is now that of the last swap that acted: all of them, unless an interrupt came between."""
        now = lib.tabor_drum_model(self._c)
        self._model = next(model for model in reversed(prepared.models) if model._c == now)
        self._swaps[:] = [swap for swap in self._swaps if not lib.tabor_swap_done(swap)]

    @property
    def is_silent(self) -> bool:
        """True once everything has died away; the sound is then exactly 0 until the next event."""
        with self._lock:
            return bool(lib.tabor_drum_is_silent(self._c))

    def reset(self) -> None:
        """Brings the drum to rest; changed parameters, ledger and counters start again."""
        with self._lock:
            lib.tabor_drum_reset(self._c)

    def ledger(self) -> Ledger:
        """Where the energy went since creation or reset.

        Returns
        -------
        Ledger
            Energies [J].
        """
        with self._lock:
            return ledger_of(self._c)

    def statistics(self) -> Statistics:
        """What was counted since creation or reset.

        Returns
        -------
        Statistics
            Counters.
        """
        with self._lock:
            return statistics_of(self._c)

    def probe(self) -> Probe:
        """Where things are now.

        Returns
        -------
        Probe
            Heights [m] and forces [N].
        """
        with self._lock:
            return Probe(**fields("TaborProbe", Probe._fields, lib.tabor_drum_probe, self._c))

    def save(self) -> bytes:
        """Saves the state of the drum, strikers in flight included.

        Returns
        -------
        bytes
            For `load` of a drum on the same model, with the same library.
        """
        with self._lock:
            return self._saved()

    def _saved(self) -> bytes:
        return saved_state(self._c, lib.tabor_drum_state_size, lib.tabor_drum_state_save)

    def load(self, state: bytes) -> None:
        """Goes on from a saved state, with the same bits.

        Parameters
        ----------
        state : bytes
            What `save` gave.

        Raises
        ------
        Error
            The bytes are damaged, or of another model; the drum then stays as it is.
        """
        with self._lock:
            if lib.tabor_drum_state_load(self._c, state, len(state)) != lib.TABOR_OK:
                raise Error("the saved state is damaged, or of another model than this drum's", "state")

    def copy(self) -> Drum:
        """Another drum in the same state.

        Returns
        -------
        Drum
            It goes on as this one does, but for sounds that fade out after a silence, a swap or a replacement.
            Another thread may play this drum meanwhile: the copy is from between two of its calls.
        """
        with self._lock:
            model, state = self._model, self._saved()
        other = Drum(model, None)
        other._mics = self._mics
        lib.tabor_drum_route(other._c, routed(model.mics, self._mics), len(self._mics))
        other.load(state)
        return other

    __copy__ = copy


class _Prepared(NamedTuple):
    """Events as the library takes them, with what must live as long as they do."""

    events: Any
    swaps: List[Any]  # of each event; None of most
    models: List[Model]  # before the first event, and after each swap


def _values(frame: int, event: Event, model: Model) -> Dict[str, Any]:
    """The members of the library's event, for a drum of this model."""
    values = {name: event.fields[name] for name in _PLAIN_FIELDS if event.fields.get(name) is not None}
    values.update({"value": event.fields[name] for name in _VALUE_FIELDS if name in event.fields})
    values.update(frame=frame, type=TYPES[event.kind])
    if event.kind == "strike":
        _complete_stroke(values, event, model.definition)
    elif event.kind == "pluck":
        values.update(_pluck(event, model.definition))
    elif event.kind == "change":
        key = event.fields["key"]
        values["parameter"] = live_parameter(key).id
        if key.startswith("mic."):
            values["index"] = index_of(model.mics, key.split(".")[1], "microphone")
    return values


def _complete_stroke(values: Dict[str, Any], event: Event, definition: Definition) -> None:
    """What the stroke does not say is as the definition's [strike] says."""
    usual = definition._c.strike
    for name in ("velocity", "radius", "angle"):
        values.setdefault(name, getattr(usual, name))
    striker = event.fields.get("striker") or text(usual.striker) or definition.strikers[0]
    values["striker"] = index_of(definition.strikers, striker, "striker")
    technique = event.fields.get("technique")
    values["technique"] = (usual.technique if technique is None
                           else choice_of(TECHNIQUES, technique, "technique"))


def _pluck(event: Event, definition: Definition) -> Dict[str, Any]:
    """The members that a pluck has in place of a stroke's."""
    wire, wires = event.fields["wire"], definition._c.wires.count
    if wire > wires:
        raise Error(f"pluck: wire {wire}: the drum has {wires}", "range", "wire", str(wire), 1, wires)
    displacement = event.fields["displacement"]
    return {"technique": lib.TABOR_TECHNIQUE_PLUCK, "striker": wire - 1, "radius": event.fields["place"],
            "value": displacement, "velocity": displacement / event.fields["pull"]}


def _destroyer(swaps: List[Any]) -> Callable[[Any], None]:
    """Destroys a drum, and the swaps that it may still be using after it."""
    def destroy(drum: Any) -> None:
        lib.tabor_drum_destroy(drum)
        swaps.clear()
    return destroy
