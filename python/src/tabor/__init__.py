# SPDX-License-Identifier: MIT
"""Drums computed from physics, into NumPy arrays.

    import tabor
    sound = tabor.render("snare-14x5.5", [tabor.strike(0, velocity=3.0)], duration=1.0)

From slow to fast, there is a `Definition`, physical parameters of a drum; a `Model`, everything that can be computed
from it for one sample rate; a `Drum`, which sounds; and a `Room` around it. A `Kit` has several
drums that hear each other. `render` does it all at once, and
`render_takes` for many drums in parallel. `strike`, `change` and others make the events that happen to a drum.

Units are SI, angles in degrees. Sound is an array of float32, shape (microphones, frames).
"""

import warnings

from ._library import Error, UnknownNameError, version
from .definition import Definition, Parameter, Preset, Value, parameters, presets
from .drum import TRACE, Drum, Ledger, Probe, Statistics
from .events import (TECHNIQUES, Event, change, damp, gain, move, pluck, press, release, replace, reset, silence, strike,
                     swap)
from .kit import Kit, KitEvent, kits
from .midi import MidiWarning, midi_events
from .model import MODE, QUALITIES, Model, ModelEstimate, ModelInfo, Playable
from .rendering import render, trace
from .room import Room, RoomInfo
from .takes import render_takes

__version__ = version()

__all__ = [
    "Definition", "Drum", "Error", "Event", "Kit", "KitEvent", "Ledger", "MODE", "MidiWarning", "Model", "ModelEstimate", "ModelInfo", "Parameter",
    "Playable", "Preset", "Probe", "QUALITIES", "Room", "RoomInfo", "Statistics", "TECHNIQUES", "TRACE", "UnknownNameError", "Value",
    "change", "damp", "gain", "kits", "midi_events", "move", "parameters", "pluck", "presets", "press", "release", "render",
    "render_takes", "replace", "reset", "silence", "strike", "swap", "trace", "version",
]


def __getattr__(name: str) -> object:
    """The names that functions had in versions before."""
    if name != "render_kit":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    warnings.warn("render_kit is render_takes now; drums that hear each other are a Kit", DeprecationWarning, stacklevel=2)
    return render_takes
