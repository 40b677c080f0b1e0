# SPDX-License-Identifier: MIT
import dataclasses
import pickle

import numpy as np
import pytest

import tabor

NUMBERS = [  # an event of a number, the number's key
    (lambda x: tabor.strike(x), "time"), (lambda x: tabor.strike(0, x), "velocity"),
    (lambda x: tabor.strike(radius=x), "radius"), (lambda x: tabor.strike(angle=x), "angle"),
    (lambda x: tabor.strike(pressure=x), "pressure"), (lambda x: tabor.press(0, x), "pressure"),
    (lambda x: tabor.move(0, x), "radius"), (lambda x: tabor.move(0, 0.1, x), "angle"),
    (lambda x: tabor.move(0, 0.1, seconds=x), "seconds"), (lambda x: tabor.damp(0, x), "strength"),
    (lambda x: tabor.damp(0, radius=x), "radius"), (lambda x: tabor.damp(0, angle=x), "angle"),
    (lambda x: tabor.gain(0, x), "factor"), (lambda x: tabor.change(0, "wires.strainer", x), "value"),
    (lambda x: tabor.release(x), "time"), (lambda x: tabor.silence(x), "time"), (lambda x: tabor.reset(x), "time"),
    (lambda x: dataclasses.replace(tabor.strike(), time=x), "time")]
IDS = [lambda x: tabor.strike(id=x), lambda x: tabor.press(0, 1, id=x), lambda x: tabor.move(0, 0.1, id=x),
       lambda x: tabor.damp(0, id=x), lambda x: tabor.release(0, id=x)]


@pytest.mark.parametrize("make, key", NUMBERS)
def test_numbers_are_numbers(make, key):
    for wrong in ("30%", True, np.bool_(True), 1j, [1], np.array([1.0, 2.0])):
        with pytest.raises(TypeError, match=rf"{key} .*: a number is needed"):
            make(wrong)
    for wrong in (float("nan"), float("inf"), -float("inf"), np.float32("nan"), np.float64("inf"), 10**400):
        with pytest.raises(ValueError, match=rf"{key} .*: allowed: ") as refused:
            make(wrong)
        assert refused.value.key == key


@pytest.mark.parametrize("make, key, wrong, allowed", [
    (lambda: tabor.strike(-0.1), "time", "-0.1", "0 or more"),
    (lambda: tabor.strike(0, 0), "velocity", "0", "0.01 to 30"),
    (lambda: tabor.strike(0, 31), "velocity", "31", "0.01 to 30"),
    (lambda: tabor.strike(radius=-0.1), "radius", "-0.1", "0 or more"),
    (lambda: tabor.strike(pressure=1.5), "pressure", "1.5", "0 to 1"),
    (lambda: tabor.press(0, -1), "pressure", "-1", "0 to 1"),
    (lambda: tabor.move(0, 0.1, seconds=61), "seconds", "61", "0 to 60"),
    (lambda: tabor.damp(0, 101), "strength", "101", "0 to 100"),
    (lambda: tabor.gain(0, -1), "factor", "-1", "0 to 1000000"),
    (lambda: tabor.change(0, "wires.strainer", 2), "wires.strainer", "2.0", "0 to 1")])
def test_ranges_are_checked(make, key, wrong, allowed):
    with pytest.raises(tabor.Error) as refused:
        make()
    assert (refused.value.status, refused.value.key, refused.value.value) == ("range", key, wrong)
    assert str(refused.value).endswith(f"{key} {wrong}: allowed: {allowed}")


@pytest.mark.parametrize("make", IDS)
def test_ids_fit(make):
    for wrong in (-1, 2**32, 2**40, 2**70):
        with pytest.raises(ValueError, match=f"id {wrong}: allowed: 0 to 4294967295"):
            make(wrong)
    for wrong in (1.0, "1", True, None):
        with pytest.raises(TypeError, match="id .*: a whole number is needed"):
            make(wrong)
    assert make(np.int64(7)) == make(7) and make(np.uint32(2**32 - 1)) == make(2**32 - 1)


def test_words_are_words():
    for make in (lambda: tabor.strike(striker=3), lambda: tabor.strike(technique=3), lambda: tabor.change(0, 3, 1)):
        with pytest.raises(TypeError, match="(striker|technique|key) 3: a string is needed"):
            make()
    with pytest.raises(TypeError, match="strike has no speed"):
        tabor.Event(0, "strike", {"speed": 3})
    with pytest.raises(tabor.Error, match="unknown event 'shout'"):
        tabor.Event(0, "shout")


def test_numpys_numbers_are_numbers(snare):
    event = tabor.strike(np.float32(0.5), np.int64(3), radius=np.float64(0.02), angle=np.int8(90),
                         pressure=np.float16(0.5), id=np.uint8(3))
    assert event == tabor.strike(0.5, 3, radius=0.02, angle=90, pressure=0.5, id=3)
    assert type(event.time) is float and type(event.fields["velocity"]) is float and type(event.fields["id"]) is int
    assert pickle.loads(pickle.dumps(event)) == event
    np.testing.assert_array_equal(tabor.Drum(snare).process(64, [tabor.strike(np.float32(0), np.float32(3))]),
                                  tabor.Drum(snare).process(64, [tabor.strike(0, 3)]))


def test_events_say_what_they_are(snare):
    assert repr(tabor.strike()) == "tabor.strike(0)"
    event = tabor.strike(0.5, 3, striker="stick", technique="buzz", pressure=0.25, id=7)
    assert repr(event) == "tabor.strike(0.5, velocity=3, striker='stick', technique='buzz', pressure=0.25, id=7)"
    assert repr(tabor.change(1, "wires.strainer", 0)) == "tabor.change(1, key='wires.strainer', value=0)"
    assert repr(tabor.swap(0, snare)) == "tabor.swap(0, model=<tabor.Model 'tabor', 48000 Hz, draft>)"
    for event in (event, tabor.damp(0.1, 3), tabor.move(0.25, 0.1, 30, seconds=1), tabor.release(1, id=2)):
        assert eval(repr(event)) == event


def test_a_pluck_is_the_programs(program_sound):
    """Wires are numbered from 1; the bits are those of `tabor render`."""
    rendered = program_sound("snare-14x5.5", "--quality", "draft", "--duration", "0.2", "--mic", "top",
                             "--set", "room.kind=none", "--strike",
                             "technique=pluck,wire=3,place=0.4,displacement=0.002,pull=0.02")
    drum = tabor.Drum(tabor.Model("snare-14x5.5", quality="draft"), mics=["top"])
    played = drum.process(9600, [tabor.pluck(0, 3, place=0.4, displacement=0.002, pull=0.02)])
    assert drum.statistics().strikes == 1
    assert np.array_equal(rendered, played)


def test_a_pluck_needs_its_wire():
    drum = tabor.Drum(tabor.Model("tom-12", quality="draft"))
    with pytest.raises(tabor.Error, match="wire 1: the drum has 0"):
        drum.process(10, [tabor.pluck()])
    for wrong in ({"wire": 0}, {"wire": 41}, {"place": 1.1}, {"displacement": 0.0}, {"pull": 11}):
        with pytest.raises(tabor.Error):
            tabor.pluck(**wrong)
