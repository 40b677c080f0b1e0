# SPDX-License-Identifier: MIT
"""What walls send back to a drum's microphones."""

from __future__ import annotations

import threading
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import Error, check, ffi, fields, lib, saved_state
from ._pieces import pieces
from .definition import Definition
from .drum import chosen, pointers

_FADE = 0.015  # of a silence [s]
_KINDS = ("none", "booth", "studio", "hall")


class RoomInfo(NamedTuple):
    """Facts of a room."""

    kind: str  #: ``"none"``, ``"booth"``, ``"studio"`` or ``"hall"``
    length: float  #: [m]; 0 for none, as are all below
    width: float  #: [m]
    height: float  #: [m]
    decay: float  #: 60 dB decay time of low notes [s]
    decay_8k: float  #: the same at 8 kHz [s]
    loudness: float  #: energy of the late sound over that of the direct sound 1 m from the drum
    feed: Tuple[int, int]  #: indices of the microphones that it hears the drum by
    tail: int  #: frames after which it is silent, at most
    bytes: int  #: memory


class Room:
    """The room around a drum, which ``[room]`` of its definition describes.

    It hears the drum by two of its microphones, the `feeds`. `render` and `render_takes` add rooms by themselves.

    Parameters
    ----------
    definition : Definition or str
        Of the drum, or the name of a preset; its room, air, shell and microphones count.
    sample_rate : float
        [Hz], 22,050 to 192,000.
    mics : sequence of str, optional
        Names of the microphones that are the rows of the sound; all of the definition's unless given. The feeds must
        be among them.

    Raises
    ------
    Error
        The definition or the rate is not allowed.
    ValueError
        A feed is not among the microphones.
    """

    def __init__(self, definition: Union[Definition, str], sample_rate: float = 48000.0,
                 mics: Optional[Sequence[str]] = None) -> None:
        if isinstance(definition, str):
            definition = Definition(definition)
        room = ffi.new("TaborRoom **")
        check(lib.tabor_room_create, definition._c, sample_rate, ffi.NULL, room)
        self._c = ffi.gc(room[0], lib.tabor_room_destroy)
        self._lock = threading.Lock()
        names = definition.mics
        self._mics = chosen(names, mics)
        self._places = [names.index(name) for name in self._mics]
        first, second = self.info.feed
        self._feeds = (names[first], names[second])
        missing = sorted(set(self._feeds) - set(self._mics))
        if missing:
            raise ValueError(f"the room hears the drum by its microphone {missing[0]!r}, which is not among "
                             f"{', '.join(self._mics)}")

    def __repr__(self) -> str:
        info = self.info
        size = f", {info.length:g} x {info.width:g} x {info.height:g} m, {info.decay:.2g} s" if info.length else ""
        return f"<tabor.Room {info.kind}{size}, mics {', '.join(self._mics)}>"

    @property
    def mics(self) -> Tuple[str, ...]:
        """Names of the microphones that are the rows of the sound."""
        return self._mics

    @property
    def feeds(self) -> Tuple[str, str]:
        """Names of the two microphones that it hears the drum by; may be the same."""
        return self._feeds

    @property
    def info(self) -> RoomInfo:
        """Facts: its size and how long it sounds."""
        facts: Dict[str, Any] = fields("TaborRoomInfo", RoomInfo._fields, lib.tabor_room_info, self._c)
        facts.update(kind=_KINDS[facts["kind"]], feed=(facts["feed"][0], facts["feed"][1]))
        return RoomInfo(**facts)

    def process(self, dry: ArrayLike) -> NDArray[np.float32]:
        """Adds what the room sends back.

        Parameters
        ----------
        dry : array_like of float32, shape (len(mics), frames)
            The next block of what the drum's microphones hear.

        Returns
        -------
        ndarray of float32, shape (len(mics), frames)
            The drum in its room. The sound does not depend on the division into blocks.

        Raises
        ------
        KeyboardInterrupt
            Ctrl-C ends the call after some milliseconds of sound; the room can be used, and has heard the block's beginning.
        """
        sound = np.array(dry, np.float32, order="C", ndmin=2)
        if sound.ndim != 2 or len(sound) != len(self._mics):
            raise ValueError(f"dry: an array of shape ({len(self._mics)}, frames) is needed, not {sound.shape}")
        self._add(sound)
        return sound

    def _add(self, sound: NDArray[np.float32]) -> None:
        """As `process`, in place, for rows that are contiguous."""
        with self._lock:
            for piece in pieces(sound.shape[1], ()):
                places = self._placed(sound[:, piece.start:piece.start + piece.frames])
                lib.tabor_room_process(self._c, ffi.cast("const float *const *", places), places, piece.frames)

    def _add_tail(self, sound: NDArray[np.float32], weights: NDArray[np.float32]) -> None:
        """Adds what still sounds, times a weight for each frame; it hears nothing."""
        tail = np.zeros(sound.shape, np.float32)
        with self._lock:
            lib.tabor_room_process(self._c, ffi.NULL, self._placed(tail), sound.shape[1])
        sound += weights * tail

    def _placed(self, sound: NDArray[np.float32]) -> Any:
        """Pointers to the rows, each at the place of its microphone."""
        rows, places = pointers(sound), ffi.new("float *[]", int(lib.TABOR_MAX_MICS))
        for row, place in enumerate(self._places):
            places[place] = rows[row]
        return places

    @property
    def is_silent(self) -> bool:
        """True once everything has died away."""
        with self._lock:
            return bool(lib.tabor_room_is_silent(self._c))

    @property
    def energy(self) -> float:
        """Mean square of the late sound at a microphone of gain 1, in units of full scale."""
        with self._lock:
            return float(lib.tabor_room_energy(self._c))

    def reset(self) -> None:
        """Brings the room to rest."""
        with self._lock:
            lib.tabor_room_reset(self._c)

    def save(self) -> bytes:
        """Saves the state of the room.

        Returns
        -------
        bytes
            For `load` of a room like this one.
        """
        with self._lock:
            return saved_state(self._c, lib.tabor_room_state_size, lib.tabor_room_state_save)

    def load(self, state: bytes) -> None:
        """Goes on from a saved state, with the same bits.

        Parameters
        ----------
        state : bytes
            What `save` gave.

        Raises
        ------
        Error
            The bytes are damaged, or of another room; the room then stays as it is.
        """
        with self._lock:
            if lib.tabor_room_state_load(self._c, state, len(state)) != lib.TABOR_OK:
                raise Error("the saved state is damaged, or of another room than this one", "state")


class RoomFade:
    """A room whose sound a silence fades out over 15 ms, as in the program (host/sound/room_mix.h).

    What is played from then on sounds in another room like it, which is at rest.
    """

    def __init__(self, definition: Definition, sample_rate: float, mics: Sequence[str]) -> None:
        self._room = Room(definition, sample_rate, mics)
        self._fading = Room(definition, sample_rate, mics)
        self._fade = int(_FADE * sample_rate)
        self._left = 0  # frames of the fade that are left

    @property
    def energy(self) -> float:
        """As of a `Room`."""
        return self._room.energy

    def add(self, sound: NDArray[np.float32], silences: List[int]) -> None:
        """Adds the room to a block of shape (mics, frames), with silences at these frames."""
        start = 0
        for frame in silences:
            self._play(sound[:, start:frame])
            self._silence()
            start = frame
        self._play(sound[:, start:])

    def _silence(self) -> None:
        if self._room.is_silent:
            return  # an earlier fade goes on
        self._room, self._fading = self._fading, self._room
        self._left = self._fade
        self._room.reset()

    def _play(self, sound: NDArray[np.float32]) -> None:
        if sound.shape[1] == 0:
            return
        self._room._add(sound)
        frames = min(self._left, sound.shape[1])
        if frames > 0:
            left = np.arange(self._left, self._left - frames, -1, dtype=np.float32)
            weights = (left / np.float32(self._fade + 1)).astype(np.float32)
            self._fading._add_tail(sound[:, :frames], weights)
        self._left -= frames
