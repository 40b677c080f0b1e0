# SPDX-License-Identifier: MIT
"""MIDI files into events, with the program's map of notes and controllers (docs/midi.md).

The package `mido` reads the files: ``pip install tabor[midi]``.
"""

from __future__ import annotations

import math
import os
from typing import Any, Dict, FrozenSet, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from ._library import Error, lib
from .definition import Definition, presets
from .events import Event, change, damp, gain, release, replace, silence, strike
from .model import Model

#: The name of a MIDI file.
Path = Union[str, "os.PathLike[str]"]

_LONGEST = 3600.0  # latest message [s]
_USUAL_TEMPO = 500000  # [us] for a quarter

_RIM_RADIUS = 0.98  # of the head, for the controller of the radius at 127
_CROSS_STICK_RADIUS = 0.6  # of the head
_CROSS_STICK_SPEED = 0.3  # of a stroke's
_HAND_RADIUS = 0.5  # of the head
_HAND_WEAKEST, _HAND_STRONGEST = 0.06, 6.0  # [N s/m]
_FIRST_HAND = 0xFFFF0000  # ids of hands; those of strokes are below

_TECHNIQUES = {36: "normal", 37: "cross-stick", 38: "normal", 39: "rim", 40: "rimshot", 41: "normal", 43: "normal",
               45: "normal", 47: "normal", 48: "normal", 50: "normal"}
_CENTRE_NOTE = 36
_GRIP, _RADIUS, _ANGLE, _STRAINER, _PREFIX = 1, 16, 17, 20, 88  # controllers
_GAINS, _SILENCES = (7, 11), (120, 123)

_NOTE_OFF, _NOTE_ON, _KEY_PRESSURE, _CONTROL, _PROGRAM, _PRESSURE = range(0x80, 0xE0, 0x10)


def midi_events(path: Path, model: Model) -> List[Event]:
    """The strokes and other events of a MIDI file, as `tabor render --midi-file` plays them.

    `render` and `render_kit` do this for a file's name in the place of events. Call it to add other events to those of
    the file.

    Parameters
    ----------
    path : str or path
        Name of a Standard MIDI File of format 0 or 1.
    model : Model
        The drum on which the file is played: its size, its strikers and its sample rate count.

    Returns
    -------
    list of Event
        In the order in which they act.

    Raises
    ------
    ImportError
        The package `mido` is not there.
    OSError
        The file cannot be read.
    Error
        It is not a MIDI file, or none of its notes is a stroke.
    """
    rate = model.sample_rate
    song = _Song(model)
    for placed in sorted(_placed(_timed_messages(path), rate), key=lambda message: message[:3]):
        song.take(placed.frame, placed.data)
    if song.strokes == 0:
        raise Error(f"{os.fspath(path)}: no note in it is a stroke: {song.ignored} are not in the map", "value")
    return [action.event for action in _settled(song.actions, _listed_preset(model.definition))]


class KitPart(NamedTuple):
    """What messages are to one drum of a kit: the techniques of the notes that play it, and the controllers of its strokes'
    place."""

    notes: Mapping[int, str]
    radius: FrozenSet[int] = frozenset({_RADIUS})
    angle: FrozenSet[int] = frozenset({_ANGLE})


def kit_midi_events(path: Path, models: Sequence[Model], parts: Sequence[KitPart]) -> List[Tuple[int, Event]]:
    """The events of a MIDI file for the drums of a kit (`Kit.midi_events`): each with the number of its drum.

    All drums hear controllers, channel pressure and silences; programs do nothing."""
    songs = [_Song(model, part) for model, part in zip(models, parts)]
    events: List[Tuple[int, Event]] = []
    for placed in sorted(_placed(_timed_messages(path), models[0].sample_rate), key=lambda message: message[:3]):
        for drum, song in enumerate(songs):
            song.take(placed.frame, placed.data)
            events += [(drum, action.event) for action in song.actions]
            song.actions.clear()
    if not any(song.strokes for song in songs):
        raise Error(f"{os.fspath(path)}: no note in it plays a drum of the kit", "value")
    return events


# ---- reading ----------------------------------------------------------------------------------------------------

def _timed_messages(path: Path) -> List[Tuple[float, List[int]]]:
    """Time [s] and bytes of each message of a channel, in order of time; of one time in the file's order."""
    file = _read(path)
    division = file.ticks_per_beat & 0xFFFF
    entries = []
    for track in file.tracks:
        tick = 0
        for message in track:
            tick += message.time
            entries.append((tick, message))
    entries.sort(key=lambda entry: entry[0])
    timed, clock = [], _Clock(division)
    for tick, message in entries:
        if message.type == "set_tempo":
            clock.set_tempo(tick, message.tempo)
        elif not message.is_meta and message.type != "sysex":
            timed.append((clock.time(tick), message.bytes()))
    if timed and timed[-1][0] > _LONGEST:
        raise Error(f"{os.fspath(path)}: its last event comes at {timed[-1][0]:.10g} s; allowed: up to {_LONGEST:g}",
                    "range", "time", f"{timed[-1][0]:.10g}", 0, _LONGEST)
    return timed


def _read(path: Path) -> Any:
    try:
        import mido
    except ImportError as error:
        raise ImportError("MIDI files need the package mido: pip install tabor[midi]", name="mido") from error
    with open(path, "rb") as opened:
        try:
            file = mido.MidiFile(file=opened)
            _check_header(file)
        except Exception as error:  # mido has many for a wrong file
            said = str(error) or type(error).__name__
            raise Error(f"{os.fspath(path)}: not a Standard MIDI File of format 0 or 1: {said}", "value") from error
    return file


def _check_header(file: Any) -> None:
    if file.type not in (0, 1):
        raise ValueError(f"format {file.type}")
    if file.ticks_per_beat == 0:
        raise ValueError("0 ticks for a quarter")
    division = file.ticks_per_beat & 0xFFFF
    if division & 0x8000 and (256 - (division >> 8) not in (24, 25, 29, 30) or division & 0xFF == 0):
        raise ValueError(f"division {division:#x}")


class _Clock:
    """Times of ticks, which have changes of tempo or are parts of a frame of film."""

    def __init__(self, division: int) -> None:
        self._is_film = bool(division & 0x8000)
        self._quarter = float(division)  # ticks
        self._tick, self._time, self._tempo = 0, 0.0, _USUAL_TEMPO
        if self._is_film:
            frames = 256 - (division >> 8)
            self._tick_time = 1 / ((30000.0 / 1001 if frames == 29 else frames) * (division & 0xFF))

    def time(self, tick: int) -> float:
        """[s]"""
        ticks = float(tick - self._tick)
        if self._is_film:
            return ticks * self._tick_time
        return self._time + ticks * self._tempo / (1e6 * self._quarter)

    def set_tempo(self, tick: int, tempo: int) -> None:
        """From this tick on, a quarter has this many microseconds."""
        if not self._is_film:
            self._time, self._tick, self._tempo = self.time(tick), tick, tempo


class _Placed(NamedTuple):
    """A message and its rank: at one frame controllers and programs act before notes."""

    frame: int
    goes_with_notes: bool
    order: int
    data: List[int]


def _placed(timed: Sequence[Tuple[float, List[int]]], rate: float) -> Iterator[_Placed]:
    for order, (time, data) in enumerate(timed):
        kind = data[0] & 0xF0
        with_notes = data[1] == _PREFIX if kind == _CONTROL else kind != _PROGRAM
        yield _Placed(math.floor(time * rate + 0.5), with_notes, order, data)


# ---- what messages do -------------------------------------------------------------------------------------------

def speed(velocity: float) -> float:
    """Speed [m/s] of a stroke of MIDI velocity 1 to 127, in the normal range."""
    low, high, slowest, fastest = (1, 20, 0.3, 1.0) if velocity < 20 else (20, 127, 1.0, 10.0)
    inside = min(max(velocity, low), high)
    return slowest * math.pow(fastest / slowest, (inside - low) / (high - low))


class _Action(NamedTuple):
    """An event, and what acts first at one frame: presets, then gains and silences, then all others."""

    frame: int
    rank: int
    place: int
    event: Event
    preset: Optional[int]


class _Song:
    """The drum that a song plays: the program's host/midi/midi_to_events.c."""

    def __init__(self, model: Model, part: Optional[KitPart] = None) -> None:
        self.actions: List[_Action] = []
        self.strokes = self.ignored = 0
        self._part = part or KitPart(_TECHNIQUES)
        self._techniques = self._part.notes
        self._is_of_kit = part is not None
        self._model = model
        self._models: Dict[int, Model] = {}
        self._preset = _listed_preset(model.definition)
        self._radius: Optional[float] = None  # by controllers: part of the head's
        self._angle: Optional[float] = None  # [degrees]
        self._gains: Dict[int, float] = {}
        self._prefixes = [0] * 16
        self._hands = [False, False]  # on the head, by channel and by key pressure
        self._id = 0
        self._bind(model.definition)

    def _bind(self, definition: Definition) -> None:
        """What follows is meant for this drum."""
        drum = definition._c
        self._head = float(drum.shell.radius)
        self._usual_radius, self._usual_angle = float(drum.strike.radius), float(drum.strike.angle)
        self._strainer = float(drum.wires.strainer)
        self._has_wires = "wires.strainer" in definition
        self._has_grip = "hand.grip" in definition

    def _add(self, frame: int, event: Event, rank: int = 2, preset: Optional[int] = None) -> None:
        self.actions.append(_Action(frame, rank, len(self.actions), event, preset))

    def take(self, frame: int, data: Sequence[int]) -> None:
        """Takes a message; messages that mean nothing are passed over."""
        kind, channel, time = data[0] & 0xF0, data[0] & 0x0F, frame / self._model.sample_rate
        if kind in (_NOTE_ON, _NOTE_OFF):
            velocity = data[2] + self._prefixes[channel] / 128.0
            self._prefixes[channel] = 0
            if kind == _NOTE_ON and data[2] > 0:
                self._strike(frame, time, data[1], velocity)
        elif kind == _KEY_PRESSURE and data[1] in self._techniques:
            self._press(frame, time, 1, data[2])
        elif kind == _PRESSURE:
            self._press(frame, time, 0, data[1])
        elif kind == _CONTROL and data[1] == _PREFIX:
            self._prefixes[channel] = data[2]
        elif kind == _CONTROL:
            self._control(frame, time, data[1], data[2])
        elif kind == _PROGRAM and not self._is_of_kit:
            self._program(frame, time, data[1])

    def _strike(self, frame: int, time: float, note: int, velocity: float) -> None:
        if note not in self._techniques:
            self.ignored += 1
            return
        technique = self._techniques[note]
        self.strokes += 1
        self._id = self._id % (_FIRST_HAND - 1) + 1
        angle = self._usual_angle if self._angle is None else self._angle
        factor = _CROSS_STICK_SPEED if technique == "cross-stick" else 1.0
        self._add(frame, strike(time, factor * speed(velocity), radius=self._stroke_radius(note), angle=angle,
                                technique=technique, pressure=0, id=self._id))

    def _stroke_radius(self, note: int) -> float:
        if note == _CENTRE_NOTE and not self._is_of_kit:
            return 0.0
        if self._techniques[note] == "cross-stick":
            return _CROSS_STICK_RADIUS * self._head
        return self._usual_radius if self._radius is None else self._radius * self._head

    def _press(self, frame: int, time: float, hand: int, pressure: int) -> None:
        """Lays a hand on the head, or lifts it."""
        was_there, self._hands[hand] = self._hands[hand], pressure > 0
        if pressure > 0:
            strength = _HAND_WEAKEST * math.pow(_HAND_STRONGEST / _HAND_WEAKEST, (pressure - 1) / 126.0)
            self._add(frame, damp(time, strength, radius=_HAND_RADIUS * self._head, angle=self._usual_angle + 180,
                                  id=_FIRST_HAND + hand))
        elif was_there:
            self._add(frame, release(time, id=_FIRST_HAND + hand))

    def _control(self, frame: int, time: float, number: int, value: int) -> None:
        if number in self._part.radius:
            self._radius = _RIM_RADIUS * value / 127
        elif number in self._part.angle:
            self._angle = 360.0 * value / 128
        elif number == _GRIP and self._has_grip:
            row = lib.tabor_parameter_find(b"hand.grip")
            self._add(frame, change(time, "hand.grip", _between(row, value / 127.0)))
        elif number == _STRAINER and self._has_wires:
            self._add(frame, change(time, "wires.strainer", _strainer(self._strainer, value)))
        elif number in _GAINS:
            self._gains[number] = value / 127.0
            self._add(frame, gain(time, math.prod(self._gains[i] * self._gains[i] for i in sorted(self._gains))), 1)
        elif number in _SILENCES:
            self._hands = [False, False]
            self._add(frame, silence(time), 1)

    def _program(self, frame: int, time: float, program: int) -> None:
        if program >= lib.tabor_preset_count() or program == self._preset:
            return
        self._preset = program
        if program not in self._models:
            name = presets()[program].name
            self._models[program] = Model(name, self._model.sample_rate, self._model.info.quality)
        self._bind(Definition(presets()[program].name))
        self._add(frame, replace(time, self._models[program]), 0, program)


def _between(row: Any, part: float) -> float:
    """A value of a parameter over its range, in equal ratios where it should be moved so."""
    if row.logarithmic and row.minimum > 0:
        return float(row.minimum * math.pow(row.maximum / row.minimum, part))
    return float(row.minimum + (row.maximum - row.minimum) * part)


def _strainer(preset: float, value: int) -> float:
    """64 is what the preset says, whatever that is."""
    return preset * value / 64.0 if value <= 64 else preset + (1 - preset) * (value - 64) / 63.0


def _listed_preset(definition: Definition) -> Optional[int]:
    """The number of the preset that is this definition, if one is."""
    names = [preset.name for preset in presets()]
    name = definition["drum.name"]
    return names.index(str(name)) if name in names and definition == Definition(str(name)) else None


def _settled(actions: List[_Action], preset: Optional[int]) -> List[_Action]:
    """The actions in order, without changes of preset that another overtakes at their frame, or that change nothing."""
    ordered = sorted(actions, key=lambda action: action[:3])
    kept = []
    for action, following in zip(ordered, ordered[1:] + ordered[:1]):
        if action.preset is not None:
            is_overtaken = following.preset is not None and following.frame == action.frame and following is not action
            if is_overtaken or action.preset == preset:
                continue
            preset = action.preset
        kept.append(action)
    return kept
