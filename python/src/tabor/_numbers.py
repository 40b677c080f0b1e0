# SPDX-License-Identifier: MIT
"""Checks of numbers that users give."""

from __future__ import annotations

import math
from numbers import Integral, Real
from typing import Any

import numpy as np

from ._library import Error


def _allowed(minimum: float, maximum: float) -> str:
    if minimum == -math.inf:
        return "a finite number"
    return f"{minimum:g} or more" if maximum == math.inf else f"{minimum:.10g} to {maximum:.10g}"


def _refused(what: str, value: Any, minimum: float, maximum: float, status: str) -> Error:
    key = what.rpartition(" ")[2]
    return Error(f"{what} {value}: allowed: {_allowed(minimum, maximum)}", status, key, str(value), minimum, maximum)


def number(what: str, value: Any, minimum: float = -math.inf, maximum: float = math.inf) -> float:
    """A finite number in a range, as a float.

    `what` is for messages, and its last word is the key of the error. Raises TypeError for what is no number, and
    Error for a number that is not finite or not in the range.
    """
    if not isinstance(value, Real) or isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{what} {value!r}: a number is needed")
    try:
        converted = float(value)
    except OverflowError:  # of a huge int
        converted = math.inf
    if not math.isfinite(converted):
        raise _refused(what, value, minimum, maximum, "value")
    if not minimum <= converted <= maximum:
        raise _refused(what, value, minimum, maximum, "range")
    return converted


def whole(what: str, value: Any, minimum: int, maximum: int) -> int:
    """A whole number in a range, as an int; errors as by `number`."""
    if not isinstance(value, Integral) or isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{what} {value!r}: a whole number is needed")
    if not minimum <= int(value) <= maximum:
        raise _refused(what, value, minimum, maximum, "range")
    return int(value)
