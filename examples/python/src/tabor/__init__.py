# SPDX-License-Identifier: MIT
"""A snare drum computed from physics.

    import tabor
    sound = tabor.render("snare-14x5.5", [tabor.Stroke(velocity=3.0)], duration=1.0)

Three kinds of object, from slow to fast: a Definition, physical parameters in SI units; a Model,
everything that can be computed from it for one sample rate; a Drum, which sounds. Angles are in degrees.
"""

from ._library import Error, version
from .definition import Definition, Parameter, Preset, parameters, presets
from .drum import TRACE, Drum
from .events import Event, damp, gain, move, parameter, press, release, reset, silence, strike
from .model import MODE, QUALITIES, Model
from .rendering import Stroke, render, trace

__version__ = version()

__all__ = [
    "Definition", "Drum", "Error", "Event", "MODE", "Model", "Parameter", "Preset", "QUALITIES",
    "Stroke", "TRACE", "damp", "gain", "move", "parameter", "parameters", "press", "presets", "release", "render",
    "reset", "silence", "strike", "trace", "version",
]
