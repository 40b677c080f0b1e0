# SPDX-License-Identifier: MIT
import numpy as np
import pytest

import tabor

HALL = {"room.kind": "hall"}


def test_a_room_adds_its_sound_after_the_drums(snare):
    room = tabor.Room(tabor.Definition("tabor", HALL))
    dry = tabor.Drum(snare).process(24000, [tabor.strike()])
    wet = room.process(dry)
    assert wet.shape == dry.shape and wet.dtype == np.float32
    early = 24  # before sound can have gone to a wall and back: 8 cm
    np.testing.assert_array_equal(wet[:, :early], dry[:, :early])
    assert np.abs(wet[:, 12000:] - dry[:, 12000:]).max() > 1e-4
    assert room.energy > 0 and not room.is_silent


def test_facts():
    room = tabor.Room(tabor.Definition("snare-14x5.5", HALL))
    assert (room.info.kind, room.info.length, room.info.height) == ("hall", 20, 9)
    assert room.info.decay == pytest.approx(1.5, rel=0.01)
    assert room.feeds == ("left", "right") == tuple(room.mics[i] for i in room.info.feed)
    assert tabor.Room("snare-14x5.5").info.kind == "studio"
    assert tabor.Room("tom-12").info.kind == "none"


def test_a_saved_room_goes_on(snare):
    definition = tabor.Definition("tabor", HALL)
    room, other = tabor.Room(definition), tabor.Room(definition)
    room.process(tabor.Drum(snare).process(4800, [tabor.strike()]))
    other.load(room.save())
    silence = np.zeros((len(room.mics), 1000), np.float32)
    after = room.process(silence)
    np.testing.assert_array_equal(after, other.process(silence))
    assert np.abs(after).max() > 0
    with pytest.raises(tabor.Error):
        other.load(room.save()[:-1])
    room.reset()
    assert room.is_silent and room.energy == 0


def test_wrong_rooms_are_refused():
    hall = tabor.Definition("snare-14x5.5", HALL)
    with pytest.raises(ValueError, match="'left', which is not among top, right"):
        tabor.Room(hall, mics=["top", "right"])
    with pytest.raises(ValueError, match=r"shape \(2, frames\)"):
        tabor.Room(hall, mics=["left", "right"]).process(np.zeros((3, 10)))
    with pytest.raises(tabor.Error):
        tabor.Room(hall, sample_rate=1)


def test_rendering_adds_the_room_as_the_program_does(program_sound):
    hall = tabor.Definition("frame-drum", HALL)
    sound = tabor.render(hall, duration=0.3, mics=["left", "right"])
    expected = program_sound("frame-drum", "--duration", "0.3", "--set", "room.kind=hall", "--mic", "left", "--mic",
                             "right", channels=2)
    np.testing.assert_array_equal(sound, expected)
    np.testing.assert_array_equal(tabor.render(hall, duration=0.3, mics=["right"])[0], expected[1])
    assert (sound != tabor.render("frame-drum", duration=0.3, mics=["left", "right"])).any()


def test_a_room_says_what_it_is():
    room = tabor.Room(tabor.Definition("snare-14x5.5", HALL), mics=["left", "right"])
    assert repr(room) == "<tabor.Room hall, 20 x 15 x 9 m, 1.5 s, mics left, right>"
    assert repr(tabor.Room("tabor")) == "<tabor.Room none, mics top, bottom, far, left, right>"
