# SPDX-License-Identifier: MIT
"""What is computed once for a drum and a sample rate."""

from __future__ import annotations

from typing import Any, Dict, Union

import numpy as np

from ._library import check, ffi, lib
from .definition import Definition

#: Names of the qualities, from fast to exact. "default": what the definition says.
QUALITIES = ("default", "draft", "live", "studio", "reference")

_PARTS = ("batter", "resonant", "both", "cavity", "rim")

#: A mode: frequency [Hz], decay and radiation rate [1/s]; m nodal diameters, n circles with the rim.
MODE = np.dtype([("m", "u4"), ("n", "u4"), ("frequency", "f8"), ("decay_rate", "f8"),
                 ("radiation_rate", "f8"), ("multiplicity", "u4"), ("part", "U8"), ("phase", "i4")])


class Model:
    """A definition computed for one sample rate [Hz]; any number of drums share it.

    definition: a Definition, or the name of a preset.
    """

    def __init__(self, definition: Union[Definition, str], rate: float = 48000,
                 quality: str = "default") -> None:
        if quality not in QUALITIES:
            raise ValueError(f"unknown quality {quality!r}; there are {', '.join(QUALITIES)}")
        if isinstance(definition, str):
            definition = Definition(definition)
        options = ffi.new("TaborModelOptions *")
        lib.tabor_model_options_default(options)
        options.sample_rate = rate
        options.quality = QUALITIES.index(quality)
        model = ffi.new("TaborModel **")
        check(lib.tabor_model_create, definition.c, options, model)
        self.c = ffi.gc(model[0], lib.tabor_model_release)  #: the C object
        self.definition = definition.copy()
        self.rate = float(rate)

    @property
    def info(self) -> Dict[str, Any]:
        """Facts: how many modes, up to which frequency, how much memory."""
        info = ffi.new("TaborModelInfo *")
        lib.tabor_model_info(self.c, info)
        facts = {name: getattr(info, name) for name, _ in ffi.typeof("TaborModelInfo").fields}
        facts["quality"] = QUALITIES[info.quality]
        return facts

    @property
    def modes(self) -> "np.ndarray[Any, np.dtype[np.void]]":
        """The modes in order of frequency, rows of MODE."""
        row = ffi.new("TaborModeInfo *")
        modes = np.zeros(self.info["mode_rows"], MODE)
        for i in range(len(modes)):
            lib.tabor_model_mode(self.c, i, row)
            modes[i] = (row.m, row.n, row.frequency, row.decay_rate, row.radiation_rate, row.multiplicity,
                        _PARTS[row.part], row.phase)
        return modes
