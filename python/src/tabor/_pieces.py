# SPDX-License-Identifier: MIT
"""Long calls of the library in pieces. Python runs signal handlers between them, so Ctrl-C ends a call after a piece."""

from __future__ import annotations

from bisect import bisect_left
from typing import Any, Iterator, NamedTuple, Sequence

PIECE = 256  # frames of a drum: 5 ms of sound, a fraction of a second of work at any quality
KIT_PIECE = 64  # frames of a kit, which may have many drums


class Piece(NamedTuple):
    """Frames that are played in one call, and the events among them."""

    start: int  # the first frame
    frames: int
    first: int  # of the events
    events: int  # how many


def pieces(frames: int, events: Sequence[Any], longest: int = PIECE) -> Iterator[Piece]:
    """Divides frames and the library's events, which are in order; an event's frame becomes that within its piece."""
    at = [event.frame for event in events]
    first = 0
    for start in range(0, max(frames, 1), longest):  # one piece if there are events and no frames
        end = bisect_left(at, start + longest, first)
        for event in events[first:end]:
            event.frame -= start
        yield Piece(start, min(longest, frames - start), first, end - first)
        first = end
