# SPDX-License-Identifier: MIT
"""Ctrl-C ends long calls early, and what was interrupted can be used. The signals come at certain calls of the library,
so that no test depends on time."""

import signal
import threading

import numpy as np
import pytest

import tabor

RATE = 48000
FRAMES = 6000
MOST = 4096  # frames that may be played before Ctrl-C is noticed: a tenth of a second of sound


class Library:
    """The library, but that Ctrl-C is pressed while a function of this name runs for the third time."""

    def __init__(self, lib, name):
        self._lib, self._name, self._calls = lib, name, 0

    def __getattr__(self, name):
        function = getattr(self._lib, name)
        if name != self._name:
            return function

        def called(*arguments):
            function(*arguments)
            self._calls += 1
            if self._calls == 3:
                signal.raise_signal(signal.SIGINT)
        return called


@pytest.fixture
def press_ctrl_c(monkeypatch):
    """Lets Ctrl-C be pressed in the third call of a function that a module of the package calls."""
    return lambda module, name: monkeypatch.setattr(module, "lib", Library(module.lib, name))


def strokes(start=0, end=FRAMES):
    return [tabor.strike((frame - start) / RATE, velocity=3) for frame in range(100, FRAMES, 701) if start <= frame < end]


def test_a_drum_goes_on_after_ctrl_c(snare, monkeypatch, press_ctrl_c):
    whole = tabor.Drum(snare, ["top"]).process(FRAMES, strokes())
    drum, out = tabor.Drum(snare, ["top"]), np.zeros((1, FRAMES), np.float32)
    press_ctrl_c(tabor.drum, "tabor_drum_process")
    with pytest.raises(KeyboardInterrupt):
        drum.process(FRAMES, strokes(), out=out)
    monkeypatch.undo()
    played = drum.statistics().frames
    assert 0 < played < MOST
    assert drum.statistics().strikes == len(strokes(0, played))
    np.testing.assert_array_equal(out[:, :played], whole[:, :played])
    assert not out[:, played:].any()
    np.testing.assert_array_equal(drum.process(FRAMES - played, strokes(played)), whole[:, played:])


def test_swaps_after_ctrl_c_have_not_happened(snare, monkeypatch, press_ctrl_c):
    other = tabor.Model(tabor.Definition("tabor", {"batter.tension": 5000}), quality="draft")
    drum = tabor.Drum(snare)
    press_ctrl_c(tabor.drum, "tabor_drum_process")
    with pytest.raises(KeyboardInterrupt):
        drum.process(FRAMES, [tabor.swap(0.0, other), tabor.swap((FRAMES - 1) / RATE, snare)])
    monkeypatch.undo()
    assert drum.model is other
    drum.process(FRAMES, [tabor.swap(0.0, snare)])
    assert drum.model is snare and not drum._swaps


def test_a_trace_can_be_interrupted(snare, press_ctrl_c):
    drum = tabor.Drum(snare)
    press_ctrl_c(tabor.drum, "tabor_drum_process")
    with pytest.raises(KeyboardInterrupt):
        drum.trace(FRAMES, strokes())
    assert drum.statistics().frames == 3


def test_a_kit_goes_on_after_ctrl_c(monkeypatch, press_ctrl_c):
    def events(start=0):
        return [("tabor", event) for event in strokes(start)]
    kit = tabor.Kit("frame-drums", quality="draft")
    whole = kit.render(events(), FRAMES / RATE)
    press_ctrl_c(tabor.kit, "tabor_kit_process")
    with pytest.raises(KeyboardInterrupt):
        kit.render(events(), FRAMES / RATE)
    monkeypatch.undo()
    played = kit.statistics("tabor").frames
    assert 0 < played < MOST
    np.testing.assert_array_equal(kit.process(FRAMES - played, events(played)), whole[:, played:])
    np.testing.assert_array_equal(kit.render(events(), FRAMES / RATE), whole)


def test_a_room_goes_on_after_ctrl_c(monkeypatch, press_ctrl_c):
    room = tabor.Room(tabor.Definition("frame-drum", {"room.kind": "hall"}))
    dry = np.zeros((len(room.mics), FRAMES), np.float32)
    dry[:, 0] = 1
    whole = room.process(dry)
    press_ctrl_c(tabor.room, "tabor_room_process")
    with pytest.raises(KeyboardInterrupt):
        room.process(dry)
    monkeypatch.undo()
    room.reset()
    np.testing.assert_array_equal(room.process(dry), whole)


@pytest.mark.parametrize("duration", [FRAMES / RATE, None])
def test_a_rendering_can_be_interrupted(snare, duration, press_ctrl_c):
    press_ctrl_c(tabor.drum, "tabor_drum_process")
    with pytest.raises(KeyboardInterrupt):
        tabor.render(snare, duration=duration)


def test_ctrl_c_ends_a_build():
    heard = []

    def press(done):
        heard.append(done)
        signal.raise_signal(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        tabor.Model("snare-14x5.5", progress=press)
    assert len(heard) == 1 and heard[0] < 1


def test_a_build_says_how_far_it_is():
    heard = []
    tabor.Model("tabor", quality="draft", progress=heard.append)
    assert heard == sorted(heard) and 0 <= heard[0] and heard[-1] <= 1
    with pytest.raises(ZeroDivisionError):
        tabor.Model("tabor", progress=lambda done: 1 / 0)


def test_an_interrupt_ends_the_builds_of_other_threads(snare, monkeypatch):
    """The first take is done, and ends all, while the second drum's build is under way and waits for just that."""
    building, given_up, heard = threading.Event(), threading.Event(), []
    original, stop = tabor.takes.model_of, tabor.takes._Jobs.stop

    def model_of(drum, rate, quality, progress):
        def hear(done):
            heard.append(done)
            building.set()
            given_up.wait()
            progress(done)
        return original(drum, rate, quality, progress if drum is snare else hear)

    def stop_and_tell(jobs, error):
        stop(jobs, error)
        given_up.set()

    def interrupt(done, total):
        building.wait()
        raise KeyboardInterrupt
    monkeypatch.setattr(tabor.takes, "model_of", model_of)
    monkeypatch.setattr(tabor.takes._Jobs, "stop", stop_and_tell)
    with pytest.raises(KeyboardInterrupt):
        tabor.render_takes([snare, "snare-14x5.5"], duration=0.01, workers=2, progress=interrupt)
    assert len(heard) == 1
