# SPDX-License-Identifier: MIT
"""A drum that sounds."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Optional, Sequence, Union

import numpy as np

from ._library import check, ffi, lib
from .definition import Definition
from .events import Event
from .model import Model

#: What moves, a row a sample: time [s], heights [m] over the undeflected head, forces [N], energy [J].
#: NaN where there is no such part.
TRACE = np.dtype([(name, "f8") for name in
                  ("time", "head", "wire", "striker", "striker_force", "wire_force", "energy")])


class Drum:
    """One sounding drum, at rest to begin with. It belongs to one thread at a time.

    model: a Model, or a Definition or preset name to make one of.
    """

    def __init__(self, model: Union[Model, Definition, str]) -> None:
        self.model = model if isinstance(model, Model) else Model(model)
        drum = ffi.new("TaborDrum **")
        check(lib.tabor_drum_create, self.model.c, drum)
        self._swaps: List[Any] = []  # under way
        self.c = ffi.gc(drum[0], _destroyer(self._swaps))  #: the C object
        self._pending: List[Any] = []  # C events for the next frame

    def process(self, frames: int, events: Sequence[Event] = (),
                mics: Optional[Sequence[str]] = None) -> "np.ndarray[Any, np.dtype[np.float32]]":
        """The next frames, with events sorted by their frame.

        Returns an array [microphone, frame], 1.0 = full scale, of the microphones named, or of all.
        """
        names = self.model.definition.mics
        wanted = [_index(names, name, "microphone") for name in (names if mics is None else mics)]
        if len(set(wanted)) != len(wanted):
            raise ValueError(f"a microphone is named twice: {', '.join(mics or names)}")
        sound = np.zeros((len(wanted), frames), np.float32)
        outputs = ffi.new("float *[]", int(lib.TABOR_MAX_MICS))
        for row, index in enumerate(wanted):
            outputs[index] = ffi.cast("float *", sound[row].ctypes.data)
        self._process(events, outputs, frames)
        return sound

    def _process(self, events: Sequence[Event], outputs: Any, frames: int) -> None:
        translated = self._pending + [self._event(event) for event in events]
        array = ffi.new("TaborEvent[]", translated)
        lib.tabor_drum_process(self.c, array, len(translated), outputs, frames)
        if self._pending and lib.tabor_drum_model(self.c) != self.model.c:
            raise RuntimeError("the swap was dropped")
        self._pending = []
        self._swaps[:] = [swap for swap in self._swaps if not lib.tabor_swap_done(swap)]

    def _event(self, event: Event) -> Dict[str, Any]:
        fields = dict(event.fields, frame=event.frame, type=event.type)
        definition = self.model.definition
        if isinstance(fields.get("striker"), str):
            fields["striker"] = _index(definition.strikers, fields["striker"], "striker")
        if "index" in fields:
            fields["index"] = _index(definition.mics, fields["index"], "microphone")
        return fields

    def trace(self, frames: int, events: Sequence[Event] = ()) -> "np.ndarray[Any, np.dtype[np.void]]":
        """The next frames as rows of TRACE, each after its sample, instead of as sound."""
        rows = np.zeros(frames, TRACE)
        probe, ledger = ffi.new("TaborProbe *"), ffi.new("TaborLedger *")
        start = self.statistics()["frames"]
        waiting = list(events)
        for frame in range(frames):
            now = []
            while waiting and waiting[0].frame <= frame:
                now.append(waiting.pop(0)._replace(frame=0))
            self._process(now, ffi.NULL, 1)
            lib.tabor_drum_probe(self.c, probe)
            lib.tabor_drum_ledger(self.c, ledger)
            rows[frame] = ((start + frame + 1) / self.model.rate, probe.head, probe.wire, probe.striker,
                           probe.striker_force, probe.wire_force, ledger.stored)
        return rows

    def swap(self, model: Model) -> None:
        """Goes on with another model of the same rate at the next frame, while the drum rings."""
        swap = ffi.new("TaborSwap **")
        check(lib.tabor_swap_create, self.model.c, model.c, swap)
        owned = ffi.gc(swap[0], lib.tabor_swap_destroy)
        self._swaps.append(owned)
        self._pending.append({"type": lib.TABOR_EVENT_SWAP, "swap": owned})
        self.model = model

    @property
    def silent(self) -> bool:
        """True once everything has died away."""
        return bool(lib.tabor_drum_is_silent(self.c))

    def reset(self) -> None:
        """Back to rest."""
        lib.tabor_drum_reset(self.c)

    def ledger(self) -> Dict[str, float]:
        """Where the energy went since creation or reset [J]: injected + control is the sum of stored,
        the losses, radiated, removed and residual."""
        return _fields("TaborLedger", lib.tabor_drum_ledger, self.c)

    def statistics(self) -> Dict[str, int]:
        """Counters since creation or reset."""
        return _fields("TaborStatistics", lib.tabor_drum_statistics, self.c)

    def probe(self) -> Dict[str, float]:
        """Where things are now: heights [m] and forces [N]."""
        return _fields("TaborProbe", lib.tabor_drum_probe, self.c)

    def save(self) -> bytes:
        """Everything there is of the drum."""
        size = lib.tabor_drum_state_size(self.c)
        state = ffi.new("char[]", size)
        lib.tabor_drum_state_save(self.c, state)
        return bytes(ffi.buffer(state, size))

    def load(self, state: bytes) -> None:
        """Goes on from what save() of a drum on the same model gave."""
        if lib.tabor_drum_state_load(self.c, state, len(state)) != lib.TABOR_OK:
            raise ValueError("the saved state is damaged or not of this drum's model")


def _destroyer(swaps: List[Any]) -> Callable[[Any], None]:
    """Destroys a drum, and the swaps that it may still be using after it."""
    def destroy(drum: Any) -> None:
        lib.tabor_drum_destroy(drum)
        swaps.clear()
    return destroy


def _index(names: Sequence[str], name: str, what: str) -> int:
    try:
        return list(names).index(name)
    except ValueError:
        raise ValueError(f"no {what} is called {name!r}; there are {', '.join(names)}") from None


def _fields(struct: str, read: Any, drum: Any) -> Dict[str, Any]:
    filled = ffi.new(struct + " *")
    read(drum, filled)
    return {name: getattr(filled, name) for name, _ in ffi.typeof(struct).fields}
