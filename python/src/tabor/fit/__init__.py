# SPDX-License-Identifier: MIT
"""Finds the drum of a recording.

``python -m tabor.fit drum.toml -o FOLDER`` reads recordings of one drum and what is known of it, and writes a preset and
a table of parameters with 90 % intervals. The first stage compares partials with modes, in closed form; the next ones
simulate recordings, with strikers, microphones, rooms and noise, and learn from them what the recording says. It takes the
packages of ``pip install tabor[fit]``. docs/fit.md in the source tree is the guide.
"""

from importlib.util import find_spec

_missing = [name for name in ("cmaes", "matplotlib", "scipy", "soundfile", "threadpoolctl") if find_spec(name) is None]
if _missing:
    raise ImportError(f"tabor.fit needs {', '.join(_missing)}: pip install 'tabor[fit]'")

from .fitting import Estimate, Fit, Settings, first_stage, fit  # noqa: E402
from .request import Request, read_request  # noqa: E402

__all__ = ["Estimate", "Fit", "Request", "Settings", "first_stage", "fit", "read_request"]
