# SPDX-License-Identifier: MIT
"""MIDI files into events, by the program's own reader and its map of notes and controllers (docs/midi.md)."""

from __future__ import annotations

import os
import warnings
from typing import Any, Callable, Dict, List, Mapping, Sequence, Union

from ._library import Error, ffi, lib, midi_lib, text
from .definition import Definition, presets
from .events import TECHNIQUES, Event, change, damp, gain, move, press, release, replace, silence, strike
from .model import Model

#: The name of a MIDI file.
Path = Union[str, "os.PathLike[str]"]


class MidiWarning(UserWarning):
    """Something in a MIDI file was passed over: what is wrong in it, which touches no note, or notes that play no drum of a kit."""


def midi_events(path: Path, model: Model, *, strict: bool = False) -> List[Event]:
    """The strokes and other events of a MIDI file, as `tabor render --midi-file` plays them.

    `render` and `render_takes` do this for a file's name in the place of events. Call it to add other events to those of
    the file.

    Parameters
    ----------
    path : str or path
        Name of a Standard MIDI File of format 0 or 1.
    model : Model
        The drum on which the file is played: its size, its strikers and its sample rate count.
    strict : bool
        Whether to refuse a file in which anything is wrong, instead of a warning.

    Returns
    -------
    list of Event
        In the order in which they act.

    Raises
    ------
    OSError
        The file cannot be read.
    Error
        It is not a MIDI file, or none of its notes is a stroke.

    Warns
    -----
    MidiWarning
        Something is wrong and was passed over.
    """
    definition, rate = model.definition, model.sample_rate
    rows = composed(path, strict, midi_lib.song_events_of_drum, definition._c, True,
                    _listed_preset(definition), rate)
    models: Dict[int, Model] = {}
    for row in rows:
        preset = row.event.index
        if row.event.type == lib.TABOR_EVENT_REPLACE and preset not in models:
            models[preset] = Model(presets()[preset].name, rate, model.info.quality)
    return [event_of(row.event, rate, models) for row in rows]


def _listed_preset(definition: Definition) -> int:
    """The number of the preset that is this definition, or -1."""
    names = [preset.name for preset in presets()]
    name = definition["drum.name"]
    return names.index(str(name)) if name in names and definition == Definition(str(name)) else -1


def composed(path: Path, strict: bool, compose: Callable[..., bool], *arguments: Any) -> Any:
    """Reads a file, warns of it, and gives its events as an array of TaborKitEvent."""
    name = os.fspath(path)
    with open(path, "rb") as opened:
        content = opened.read(midi_lib.song_events_most_bytes() + 1)
    song = ffi.gc(midi_lib.song_events_read(content, len(content)), midi_lib.song_events_free)
    if not song:
        raise MemoryError
    lines = _warnings(song)
    _refuse(name, text(midi_lib.song_events_error(song)))
    _refuse(name, f"{lines[0]}; strict=True" if strict and lines else "")
    for line in lines:
        warnings.warn(f"{name}: {line}", MidiWarning, stacklevel=3)
    if not compose(song, *arguments):
        _refuse(name, text(midi_lib.song_events_error(song)))
        raise MemoryError
    for line in _warnings(song)[len(lines):]:  # of notes that a kit does not play
        warnings.warn(f"{name}: {line}", MidiWarning, stacklevel=3)
    made = ffi.new("TaborKitEvent[]", midi_lib.song_events_count(song))
    ffi.memmove(made, midi_lib.song_events_list(song), ffi.sizeof(made))
    return made


def _warnings(song: Any) -> List[str]:
    return [text(midi_lib.song_events_warning(song, i)) for i in range(midi_lib.song_events_warning_count(song))]


def _refuse(name: str, reason: str) -> None:
    if reason:
        raise Error(f"{name}: {reason}", "value")


def event_of(row: Any, rate: float, models: Mapping[int, Model], strikers: Sequence[str] = ()) -> Event:
    """An event of the library, which the default map or a kit has made; without `strikers` the drum's own one strikes."""
    time = row.frame / rate
    if row.type == lib.TABOR_EVENT_STRIKE:
        return strike(time, row.velocity, radius=row.radius, angle=row.angle, technique=TECHNIQUES[row.technique],
                      striker=strikers[row.striker] if strikers else None, pressure=row.value, id=row.id)
    if row.type == lib.TABOR_EVENT_PRESS:
        return press(time, row.value, id=row.id)
    if row.type == lib.TABOR_EVENT_MOVE:
        return move(time, row.radius, row.angle, seconds=row.value, id=row.id)
    if row.type == lib.TABOR_EVENT_DAMP:
        return damp(time, row.value, radius=row.radius, angle=row.angle, id=row.id)
    if row.type == lib.TABOR_EVENT_RELEASE:
        return release(time, id=row.id)
    if row.type == lib.TABOR_EVENT_PARAMETER:
        return change(time, _key_of(row.parameter), row.value)
    if row.type == lib.TABOR_EVENT_GAIN:
        return gain(time, row.value)
    if row.type == lib.TABOR_EVENT_REPLACE:
        return replace(time, models[row.index])
    return silence(time)


def _key_of(parameter: int) -> str:
    rows = (lib.tabor_parameter(i) for i in range(lib.tabor_parameter_count()))
    return next(f"{text(row.section)}.{text(row.key)}" for row in rows if row.id == parameter)
