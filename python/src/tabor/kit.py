# SPDX-License-Identifier: MIT
"""Several drums in one room that hear each other."""

from __future__ import annotations

import os
import threading
import warnings
import wave
from bisect import bisect_left
from itertools import count, takewhile
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._library import Error, UnknownNameError, check, encoded, ffi, index_of, lib, midi_lib, read_ini, saved_state, text
from ._numbers import number, whole
from ._pieces import KIT_PIECE, pieces
from .definition import Definition, Preset, Value
from .drum import Ledger, Statistics, _values, ledger_of, statistics_of
from .events import TYPES, Event, frame_of, place
from .midi import Path, composed, event_of
from .model import Model
from .rendering import LATEST_EVENT, RING_OUT_BLOCK, RingOut

_MOST_FRAMES = 2**31 - 1
_QUIET = np.float32(1e-5)  # -100 dBFS: of the mix, which has room and samples
#: An event and the name of the drum that it is for; None: all drums.
KitEvent = Tuple[Optional[str], Event]


def kits() -> Tuple[Preset, ...]:
    """The built-in kits.

    Returns
    -------
    tuple of Preset
        Names and descriptions.
    """
    rows = [lib.tabor_kit(i) for i in range(lib.tabor_kit_count())]
    return tuple(Preset(text(row.name), text(row.comment), text(row.category)) for row in rows)


def _maps() -> List[str]:
    """Names of the maps of `Kit.midi_events`."""
    return [text(name) for name in takewhile(bool, map(midi_lib.song_events_map_name, count()))]


def _read_wave(path: str) -> Tuple[NDArray[np.float32], int]:
    """The sound of a WAV file of 16, 24 or 32 bits, its first two channels, and its rate."""
    with wave.open(path, "rb") as file:
        width, channels = file.getsampwidth(), file.getnchannels()
        if width not in (2, 3, 4):
            raise ValueError(f"{8 * width} bits are not read; allowed: 16, 24, 32")
        data = np.frombuffer(file.readframes(file.getnframes()), np.uint8).reshape(-1, width)
        words = np.zeros((len(data), 4), np.uint8)
        words[:, 4 - width:] = data
        sound = words.view("<i4").reshape(-1, channels)[:, :2].T / np.float32(2**31)
        return sound.astype(np.float32), file.getframerate()


class Kit:
    """A kit of drums, at rest to begin with.

    Parameters
    ----------
    kit : str or path
        Name of a built-in kit, as `kits` lists them, or of a kit file, as `tabor show --kit` writes one: with a ``/`` in it
        or ending in ``.ini``. Samples of the file play nothing here.
    settings : mapping of str to str or number, optional
        Changes, as ``{"drum.snare.batter.pitch": "G3", "kit.coupling": "off"}`` (docs/kit.md has the keys).
    sample_rate : float, optional
        [Hz], 48,000 unless given.
    quality : str, optional
        One of `QUALITIES`, ``"live"`` unless given.

    Raises
    ------
    OSError
        The file cannot be read.
    Error
        There is no such kit, a line of the file is not understood, or a setting is not allowed.

    Notes
    -----
    The sound does not depend on its division into blocks. Threads take turns at one kit.

    Examples
    --------
    >>> kit = tabor.Kit("standard")
    >>> sound = kit.process(48000, [("kick", tabor.strike(0, velocity=5)), ("snare", tabor.strike(0.5))])
    """

    def __init__(self, kit: Path = "standard", settings: Optional[Mapping[str, Value]] = None,
                 sample_rate: Optional[float] = None, quality: Optional[str] = None) -> None:
        self._def = ffi.new("TaborKitDef *")
        self._folder = os.getcwd()
        self._define(kit)
        for key, value in (settings or {}).items():
            self._require_drum(key)
            check(lib.tabor_kit_def_set, self._def, encoded(key, "key"), encoded(str(value), "value"))
        check(lib.tabor_kit_def_validate, self._def)
        self._drums = tuple(text(self._def.drum[i].name) for i in range(self._def.drum_count))
        self._models = tuple(Model(self._placed(i), sample_rate, quality) for i in range(len(self._drums)))
        models = ffi.new("TaborModel *[]", [model._c for model in self._models])
        made = ffi.new("TaborKit **")
        check(lib.tabor_kit_create, self._def, models, made)
        self._c = ffi.gc(made[0], lib.tabor_kit_destroy)
        self._lock = threading.Lock()
        for note, path in self.samples.items():
            self._load_sample(note, path)

    def _define(self, kit: Path) -> None:
        if isinstance(kit, str) and "/" not in kit and not kit.endswith(".ini"):
            check(lib.tabor_kit_def_preset, self._def, encoded(kit, "kit"))
            return
        with open(kit, "rb") as file:
            read_ini(lib.tabor_kit_def_read, self._def, file.read(), os.fspath(kit))
        self._folder = os.path.dirname(os.path.abspath(kit))

    def _require_drum(self, key: str) -> None:
        """A setting of a drum that is not there is a mistake, unless its preset is given."""
        words = key.split(".")
        if words[0] != "drum" or len(words) < 3 or words[2:] == ["preset"]:
            return
        if lib.tabor_kit_def_find(self._def, encoded(words[1], "drum")) < 0:
            raise UnknownNameError(f"{key}: the kit has no drum {words[1]!r}; a setting 'drum.{words[1]}.preset' adds it", "name",
                                   key, words[1])

    def _placed(self, drum: int) -> Definition:
        """The drum as it stands in the kit."""
        definition = ffi.new("TaborDrumDef *")
        check(lib.tabor_kit_def_place, self._def, drum, definition)
        return Definition._of(definition[0])

    def __repr__(self) -> str:
        return f"<tabor.Kit {text(self._def.name)!r}, {self.sample_rate:g} Hz, drums {', '.join(self._drums)}>"

    @property
    def drums(self) -> Tuple[str, ...]:
        """Names of the drums."""
        return self._drums

    @property
    def models(self) -> Dict[str, Model]:
        """The model of each drum."""
        return dict(zip(self._drums, self._models))

    @property
    def samples(self) -> Dict[int, str]:
        """The sound files of notes that play no drum, by General MIDI's notes; a name without a folder is beside the kit's file."""
        names = ((note, text(self._def.note[note].sample)) for note in range(lib.TABOR_KIT_NOTES))
        return {note: os.path.join(self._folder, name) for note, name in names if name}

    def set_sample(self, note: int, sound: NDArray[Any], sample_rate: float) -> None:
        """Gives a note its sound, with the gain and the choke group that the kit defines for it.

        Parameters
        ----------
        note : int
            0 to 127, as in ``("note.42", tabor.strike(0, velocity=1))``.
        sound : ndarray of float, shape (frames,) or (2, frames)
            Mono, or left and right; 1.0 is full scale.
        sample_rate : float
            Its sample rate [Hz], which is converted to that of the kit.

        Raises
        ------
        Error
            There is no such note, or the rate is not one from 1 kHz to 1 MHz.
        ValueError
            The sound has another shape.
        """
        sides = np.atleast_2d(np.ascontiguousarray(sound, np.float32))
        if sides.ndim != 2 or sides.shape[0] not in (1, 2):
            raise ValueError(f"set_sample: a sound has the shape (frames,) or (2, frames), not {np.shape(sound)}")
        left, right = (ffi.cast("float *", side.ctypes.data) for side in (sides[0], sides[-1]))
        with self._lock:
            check(lib.tabor_kit_set_sample, self._c, whole("set_sample: note", note, 0, lib.TABOR_KIT_NOTES - 1), left,
                  right if len(sides) == 2 else ffi.NULL, sides.shape[1], float(sample_rate))

    def _load_sample(self, note: int, path: str) -> None:
        """Reads a WAV file; a note whose file cannot be read is silent."""
        try:
            sound, rate = _read_wave(path)
        except (OSError, EOFError, ValueError, wave.Error) as error:
            warnings.warn(f"note {note} is silent: {path}: {error}; Kit.set_sample takes any sound", stacklevel=3)
            return
        self.set_sample(note, sound, rate)

    @property
    def sample_rate(self) -> float:
        """The sample rate [Hz]."""
        return self._models[0].sample_rate

    def process(self, frames: int, events: Sequence[KitEvent] = ()) -> NDArray[np.float32]:
        """Plays on.

        Parameters
        ----------
        frames : int
            How many samples.
        events : sequence of (str or None, Event)
            What happens meanwhile, and to which drum; None: to all. An event at t seconds acts at frame t x rate. The
            sound of note 42 has the name "note.42"; the velocity of a stroke, 0 to 1, is its strength there, the square of
            which is how loud it is, and a silence fades it.

        Returns
        -------
        ndarray of float32, shape (2, frames)
            The stereo mix, with the room.

        Raises
        ------
        ValueError
            An event is later than these frames, is for no drum of the kit, or is a swap, which kits do not take. The kit
            then stays as it is.
        KeyboardInterrupt
            Ctrl-C ends the call as that of `Drum.process`: the kit can be used, and has played the frames that `statistics`
            counts.
        """
        frames = whole("process: frames", frames, 0, _MOST_FRAMES)
        return self._play(self._prepare(events, frames), frames)

    def _play(self, events: Sequence[Dict[str, Any]], frames: int) -> NDArray[np.float32]:
        """Plays on, with events for the library."""
        made = ffi.new("TaborKitEvent[]", events)
        out = np.empty((2, frames), np.float32)
        outputs = ffi.new("TaborKitOutputs *")
        with self._lock:
            for piece in pieces(frames, [row.event for row in made], KIT_PIECE):
                for side in range(2):
                    outputs.stereo[side] = ffi.cast("float *", out[side, piece.start:].ctypes.data)
                lib.tabor_kit_process(self._c, made + piece.first, piece.events, outputs, piece.frames)
        return out

    def midi_events(self, path: Path, *, notes_of: Optional[str] = None,
                    place_cc: Tuple[int, int] = (16, 18), strict: bool = False) -> List[KitEvent]:
        """The strokes and other events of a MIDI file, as `tabor render --kit --midi-file` plays them.

        Parameters
        ----------
        path : str or path
            Name of a Standard MIDI File of format 0 or 1.
        notes_of : {"roland", "yamaha", "alesis", "superior", "addictive"}, optional
            What the notes are those of (``--map``). Unless given they are those of the kit: General MIDI's in the
            built-in ones.
        place_cc : (int, int), optional
            With `notes_of`: controllers, 0 to 119, of a stroke's place on the snare drum and on the toms.
        strict : bool
            Whether to refuse a file in which anything is wrong, instead of a `MidiWarning`.

        Returns
        -------
        list of (str, Event)
            Each with the name of its drum, in the order in which they act.

        Raises
        ------
        OSError
            The file cannot be read.
        Error
            It is not a MIDI file, none of its notes plays a drum, or there is no such map.
        """
        snare, toms = (whole("place_cc", controller, 0, 119) for controller in place_cc)
        chosen = -1 if notes_of is None else index_of(_maps(), notes_of, "map")
        rows = composed(path, strict, midi_lib.song_events_of_kit, self._def, chosen, snare, toms, self.sample_rate)
        return [(self._name_of(row.drum), event_of(row.event, self.sample_rate, {}, self._strikers_of(row.drum))) for row in rows]

    def _strikers_of(self, drum: int) -> Tuple[str, ...]:
        return self._models[drum].definition.strikers if drum < len(self._models) else ()

    def _name_of(self, drum: int) -> str:
        """The name of an address."""
        return self._drums[drum] if drum < len(self._drums) else f"note.{drum - lib.TABOR_KIT_NOTE}"

    def render(self, events: Union[Path, Sequence[KitEvent]], duration: Optional[float] = None, *,
               notes_of: Optional[str] = None) -> NDArray[np.float32]:
        """Plays from rest.

        Parameters
        ----------
        events : str, path or sequence of (str or None, Event)
            Name of a MIDI file, as for `midi_events`; its events after the end are left out. Or what happens, as for
            `process`.
        duration : float, optional
            [s]; until the sound has died away unless given, as `tabor render --kit` has it: until the mix is below -100 dBFS and
            the energy of the drums 90 dB below its largest since the last event, 0.5 to 20 s after that event.
        notes_of : str, optional
            Of a MIDI file: as for `midi_events`.

        Returns
        -------
        ndarray of float32, shape (2, frames)
            The stereo mix.

        Raises
        ------
        ValueError, KeyboardInterrupt
            As from `process`.
        """
        most = LATEST_EVENT if duration is None else number("render: duration", duration, 0, LATEST_EVENT)
        frames = round(most * self.sample_rate)
        if isinstance(events, (str, os.PathLike)):
            events = [(drum, event) for drum, event in self.midi_events(events, notes_of=notes_of)
                      if frame_of(event, self.sample_rate) < frames]
        made = self._prepare(events, frames)  # before anything changes
        self.reset()
        return self._ring_out(made) if duration is None else self._play(made, frames)

    def _ring_out(self, events: Sequence[Dict[str, Any]]) -> NDArray[np.float32]:
        """Plays events for the library until the sound has died away."""
        frames = [row["event"]["frame"] for row in events]
        sound = RingOut(frames[-1] if frames else 0, self.sample_rate)
        blocks: List[NDArray[np.float32]] = []
        position, first, over = 0, 0, False
        while not over:
            count = min(RING_OUT_BLOCK, sound.most - position)
            end = bisect_left(frames, position + count, first)
            due = [{**row, "event": {**row["event"], "frame": row["event"]["frame"] - position}} for row in events[first:end]]
            block = self._play(due, count)
            blocks.append(block)
            position, first = position + count, end
            is_alone = bool(np.abs(block).max() < _QUIET) and lib.tabor_kit_sounds(self._c) == 0
            over = sound.is_over(position, self._stored, self.is_silent, is_alone)
        return np.concatenate(blocks, axis=1)

    def _stored(self) -> float:
        """The energy of all drums [J]."""
        return sum((self.ledger(drum).stored for drum in self._drums), 0.0)

    def _prepare(self, events: Sequence[KitEvent], frames: int) -> List[Dict[str, Any]]:
        """The events for the library, in order."""
        made: List[Tuple[int, Dict[str, Any]]] = []
        for name, event in events:
            for frame, placed in place([event], self.sample_rate, frames):
                if name is not None and name.startswith("note."):
                    made.append((frame, self._of_note(name, frame, placed)))
                    continue
                if "model" in placed.fields:
                    raise ValueError(f"{placed.kind}: the drums of a kit stay")
                made += [(frame, {"drum": drum, "event": _values(frame, placed, self._models[drum])})
                         for drum in self._addressed(name)]
        return [values for _, values in sorted(made, key=lambda pair: pair[0])]

    def _of_note(self, name: str, frame: int, event: Event) -> Dict[str, Any]:
        """An event for the sound of a note."""
        number_of = name[len("note."):]
        if not number_of.isdecimal() or int(number_of) >= lib.TABOR_KIT_NOTES:
            raise UnknownNameError(f"{name!r} is no note; there are note.0 to note.127", "name", "drum", name)
        if event.kind not in ("strike", "silence"):
            raise ValueError(f"{event.kind}: the sound of a note is struck and silenced")
        strength = event.fields.get("velocity")
        return {"drum": lib.TABOR_KIT_NOTE + int(number_of),
                "event": {"frame": frame, "type": TYPES[event.kind], "velocity": 1.0 if strength is None else strength}}

    def _addressed(self, name: Optional[str]) -> Sequence[int]:
        if name is None:
            return range(len(self._drums))
        return (index_of(self._drums, name, "drum"),)

    def _drum(self, name: str) -> Any:
        return lib.tabor_kit_drum(self._c, self._addressed(name)[0])

    def ledger(self, drum: str) -> Ledger:
        """Where the energy of a drum went since creation or reset.

        Parameters
        ----------
        drum : str
            Its name.

        Returns
        -------
        Ledger
            Energies [J]; the work of others' sound counts as injected.
        """
        with self._lock:
            return ledger_of(self._drum(drum))

    def statistics(self, drum: str) -> Statistics:
        """What was counted of a drum since creation or reset.

        Parameters
        ----------
        drum : str
            Its name.

        Returns
        -------
        Statistics
            Counters.
        """
        with self._lock:
            return statistics_of(self._drum(drum))

    @property
    def is_silent(self) -> bool:
        """True once everything has died away."""
        with self._lock:
            return bool(lib.tabor_kit_is_silent(self._c))

    def reset(self) -> None:
        """Brings all drums and the room to rest."""
        with self._lock:
            lib.tabor_kit_reset(self._c)

    def save(self) -> bytes:
        """Saves the state of the kit.

        Returns
        -------
        bytes
            For `load` of a kit like this one.
        """
        with self._lock:
            return saved_state(self._c, lib.tabor_kit_state_size, lib.tabor_kit_state_save)

    def load(self, state: bytes) -> None:
        """Goes on from a saved state, with the same bits.

        Parameters
        ----------
        state : bytes
            What `save` gave.

        Raises
        ------
        Error
            The bytes are damaged, or of another kit.
        """
        with self._lock:
            if lib.tabor_kit_state_load(self._c, state, len(state)) != lib.TABOR_OK:
                raise Error("the saved state is damaged, or of another kit than this one", "state")
