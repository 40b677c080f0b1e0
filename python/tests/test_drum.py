# SPDX-License-Identifier: MIT
import copy
import dataclasses
import gc
import math
import threading

import numpy as np
import pytest

import tabor

RATE = 48000


def rms(sound):
    return np.sqrt(np.mean(np.square(sound, dtype=float)))


def test_blocks_make_no_difference(snare):
    events = [tabor.strike(700 / RATE, striker="stick"), tabor.strike(3 / RATE)]  # in any order
    whole = tabor.Drum(snare).process(1000, events)
    drum = tabor.Drum(snare)
    blocks = [drum.process(300, [tabor.strike(3 / RATE)]), drum.process(300),
              drum.process(400, [tabor.strike(100 / RATE, striker="stick")])]
    assert whole.shape == (len(snare.mics), 1000) and whole.dtype == np.float32
    np.testing.assert_array_equal(whole, np.concatenate(blocks, axis=1))
    assert np.abs(whole).max() > 0.01


def test_every_frame_has_a_time(snare):
    for frame in (0, 1, 1023, 9999):
        sound = tabor.Drum(snare).trace(frame + 2, [tabor.strike(frame / RATE)])["striker"]
        assert np.flatnonzero(~np.isnan(sound))[0] == frame


def test_microphones_are_rows():
    model = tabor.Model("frame-drum", quality="draft")
    every = tabor.Drum(model).process(2000, [tabor.strike()])
    drum = tabor.Drum(model, ["far", "top"])
    assert drum.mics == ("far", "top")
    np.testing.assert_array_equal(drum.process(2000, [tabor.strike()]),
                                  every[[model.mics.index("far"), model.mics.index("top")]])
    with pytest.raises(tabor.UnknownNameError, match="no microphone is called 'nowhere'"):
        tabor.Drum(model, ["nowhere"])
    with pytest.raises(ValueError, match="twice"):
        tabor.Drum(model, ["top", "top"])
    with pytest.raises(TypeError):
        tabor.Drum(model, "top")


def test_a_sound_can_be_written_in_place(snare):
    drum, other = tabor.Drum(snare, ["top"]), tabor.Drum(snare, ["top"])
    sound = np.full((3, 900), 7, np.float32)
    part = sound[1:2, 200:700]
    assert drum.process(500, [tabor.strike()], out=part) is part
    np.testing.assert_array_equal(part, other.process(500, [tabor.strike()]))
    assert (sound[0] == 7).all() and (sound[1, :200] == 7).all() and (sound[1, 700:] == 7).all()
    for wrong in (np.zeros((1, 500)), np.zeros((2, 500), np.float32), np.zeros((1, 1000), np.float32)[:, ::2],
                  np.zeros((1, 400), np.float32)):
        with pytest.raises(ValueError, match="out: "):
            drum.process(500, out=wrong)


def test_events_outside_are_refused(snare):
    drum = tabor.Drum(snare)
    with pytest.raises(ValueError, match="strike: 0.01 s is outside of 0.01 s"):
        drum.process(480, [tabor.strike(0.01)])
    for wrong in (-1, math.nan, math.inf):
        with pytest.raises(ValueError, match="strike: time"):
            tabor.strike(wrong)
    with pytest.raises(ValueError, match="strike: velocity"):
        tabor.strike(0, math.nan)
    with pytest.raises(tabor.UnknownNameError, match="no striker is called 'mace'; there are stick"):
        drum.process(10, [tabor.strike(striker="mace")])
    with pytest.raises(tabor.Error, match="unknown technique 'shout'"):
        tabor.strike(technique="shout")
    assert drum.statistics().frames == 0


def test_an_event_can_come_later():
    assert dataclasses.replace(tabor.strike(0, 3), time=1.5) == tabor.strike(1.5, 3)


def test_a_stroke_is_as_the_definition_says_unless_told():
    drum = tabor.Definition("tabor", {"strike.velocity": 1.25, "strike.radius": 0.07, "strike.technique": "rim"})
    model = tabor.Model(drum, quality="draft")
    np.testing.assert_array_equal(
        tabor.Drum(model).process(500, [tabor.strike()]),
        tabor.Drum(model).process(500, [tabor.strike(0, 1.25, radius=0.07, technique="rim")]))


def test_a_buzz_bounces_until_it_is_released(snare):
    drum = tabor.Drum(snare)
    buzz = tabor.strike(0, 1.0, technique="buzz", pressure=0.3, id=7)
    path = drum.trace(9600, [buzz, tabor.release(6500 / RATE, id=7)])
    touches = np.diff((path["striker_force"] > 0).astype(int)) > 0
    assert touches.sum() > 3
    assert np.isnan(path["striker"][-1])


def test_a_press_makes_a_stroke_bounce(snare):
    def touches(*events):
        force = tabor.Drum(snare).trace(9600, [tabor.strike(0, 1.0, id=3), *events])["striker_force"]
        return (np.diff((force > 0).astype(int)) > 0).sum()
    assert touches(tabor.press(0.002, 0.5, id=3)) > touches() + 2


def test_a_brush_sweeps_where_it_is_sent():
    model = tabor.Model("snare-14x5.5", quality="draft")
    brush = tabor.strike(0, 1.0, striker="brush", technique="sweep", id=1)
    still = tabor.Drum(model, ["top"]).process(9600, [brush])
    moved = tabor.Drum(model, ["top"]).process(9600, [brush, tabor.move(0.1, 0.1, 90, seconds=0.05, id=1)])
    np.testing.assert_array_equal(still[:, :4800], moved[:, :4800])
    assert (still[:, 4900:] != moved[:, 4900:]).any()


def test_a_hand_damps(snare):
    free = tabor.Drum(snare, ["top"]).process(24000, [tabor.strike()])
    held = tabor.Drum(snare, ["top"]).process(24000, [tabor.strike(), tabor.damp(0.1, 20.0)])
    assert rms(held[0, 12000:]) < 0.5 * rms(free[0, 12000:])


def test_a_silence_fades_within_15_ms(snare):
    drum = tabor.Drum(snare, ["top"])
    sound = drum.process(9600, [tabor.strike(), tabor.silence(0.1)])[0]
    assert np.abs(sound[4000:4800]).max() > 1e-3
    assert (sound[4800 + 720 + 1:] == 0).all()
    assert drum.is_silent and drum.statistics().strikes == 1


def test_a_gain_scales_the_sound(snare):
    plain = tabor.Drum(snare, ["top"]).process(4800, [tabor.strike()])
    halved = tabor.Drum(snare, ["top"]).process(4800, [tabor.gain(0, 0.5), tabor.strike()])
    np.testing.assert_allclose(halved, 0.5 * plain, rtol=1e-6, atol=1e-12)
    reached = tabor.Drum(snare, ["top"]).process(4800, [tabor.strike(), tabor.gain(0.05, 0.5)])
    np.testing.assert_allclose(reached[0, 2400 + 241:], 0.5 * plain[0, 2400 + 241:], rtol=1e-6, atol=1e-12)


def test_a_reset_starts_again(snare):
    drum = tabor.Drum(snare)
    drum.process(4800, [tabor.strike(), tabor.reset(0.05)])
    assert drum.is_silent and drum.ledger().injected == 0 and drum.statistics().strikes == 0
    drum.process(100, [tabor.strike()])
    drum.reset()
    assert drum.is_silent


def test_a_live_parameter_changes():
    model = tabor.Model("snare-14x5.5", quality="draft")
    on = tabor.Drum(model, ["bottom"]).process(24000, [tabor.strike()])
    drum = tabor.Drum(model, ["bottom"])
    off = drum.process(24000, [tabor.strike(), tabor.change(0, "wires.strainer", 0)])
    assert rms(off[0, 9600:]) != rms(on[0, 9600:])
    assert drum.ledger().control != 0
    quiet = tabor.Drum(model, ["top", "bottom"])
    top, bottom = quiet.process(24000, [tabor.change(0, "mic.bottom.gain", 0), tabor.strike()])
    assert np.abs(bottom[4800:]).max() < 1e-9 < np.abs(top[4800:]).max()  # its response rings at 44 Hz
    assert bottom[-1] == 0
    with pytest.raises(ValueError, match="swap"):
        tabor.change(0, "batter.tension", 4000)
    with pytest.raises(tabor.UnknownNameError):
        tabor.change(0, "batter.tensoin", 4000)
    with pytest.raises(tabor.UnknownNameError):
        drum.process(10, [tabor.change(0, "mic.nowhere.gain", 1)])


def test_a_swapped_drum_rings_on_and_another_replaces_it():
    models = [tabor.Model(tabor.Definition("frame-drum", {"batter.tension": t}), quality="draft") for t in (2500, 3000)]
    tom = tabor.Model("tom-12", quality="draft")
    drum = tabor.Drum(models[0], ["top", "far"])
    drum.process(4800, [tabor.strike()])
    assert rms(drum.process(9600, [tabor.swap(0.01, models[1])])[:, 4800:]) > 1e-4
    assert drum.model is models[1] and drum.ledger().control > 0
    sound = drum.process(9600, [tabor.replace(0.01, tom), tabor.strike(0.1, 3, striker=tom.definition.strikers[-1])])
    assert (sound[:, 480 + 1440 + 1:4800] == 0).all()  # faded, and the other one is at rest
    assert np.abs(sound[drum.mics.index("top"), 4800:]).max() > 0.01
    assert drum.model is tom and drum.mics == ("top", "far")
    drum.process(10, [tabor.swap(0, tabor.Model("tom-12"))])
    with pytest.raises(tabor.Error):
        drum.process(10, [tabor.swap(0, tabor.Model("tom-12", sample_rate=44100, quality="draft"))])
    with pytest.raises(TypeError, match="swap: a Model is needed, not 'tom-12'"):
        tabor.swap(0, "tom-12")
    del drum  # while the swap may still be under way
    gc.collect()


def test_two_swaps_in_one_block(snare):
    tom, frame = tabor.Model("tom-12", quality="draft"), tabor.Model("frame-drum", quality="draft")
    drum = tabor.Drum(snare, ["top"])
    drum.process(9600, [tabor.swap(0.01, tom), tabor.replace(0.1, frame), tabor.strike(0.15)])
    assert drum.model is frame and drum.statistics().strikes == 1 and drum.statistics().dropped_events == 0


def test_a_saved_drum_goes_on(snare):
    drum, other = tabor.Drum(snare), tabor.Drum(snare)
    drum.process(500, [tabor.strike()])
    state = drum.save()
    other.load(state)
    twin, other_twin = drum.copy(), copy.copy(drum)
    after = drum.process(500)
    np.testing.assert_array_equal(after, other.process(500))
    np.testing.assert_array_equal(after, twin.process(500))
    np.testing.assert_array_equal(after, other_twin.process(500))
    turned = bytes(255 - byte for byte in state[100:108])
    for damaged in (state[:-1], b"", state[:100] + turned + state[108:]):
        with pytest.raises(tabor.Error) as refused:
            other.load(damaged)
        assert refused.value.status == "state"


def test_the_ledger_closes(snare):
    drum = tabor.Drum(tabor.Model("tabor", quality="studio"))
    drum.process(4800, [tabor.strike(0, 3.0), tabor.damp(0.04), tabor.release(0.08),
                        tabor.change(0.09, "wires.strainer", 0.5)])
    ledger = drum.ledger()
    spent = sum(value for name, value in ledger._asdict().items() if name not in ("injected", "control", "high_band"))
    assert ledger.injected + ledger.control == pytest.approx(spent, abs=1e-9 * ledger.injected)
    assert abs(ledger.residual) < 1e-9 * (ledger.injected + abs(ledger.control))
    assert drum.statistics().dropped_events == 0


def test_a_probe_is_the_last_row_of_a_trace(snare):
    drum = tabor.Drum(snare)
    last = drum.trace(100, [tabor.strike()])[-1]
    assert tuple(drum.probe()) == tuple(last)[1:6]
    assert drum.trace(1)["time"][0] == pytest.approx(101 / RATE)


def test_a_trace_is_the_programs(program, tmp_path):
    program("render", "tabor", "--quality", "draft", "--duration", "0.02", "-q", "-o", str(tmp_path / "x.wav"),
            "--trace", str(tmp_path / "x.csv"))
    expected = np.genfromtxt(tmp_path / "x.csv", delimiter=",", skip_header=1)
    trace = tabor.trace("tabor", duration=0.02, quality="draft")
    assert trace.shape == (960,) and trace.dtype == tabor.TRACE
    for column, name in enumerate(tabor.TRACE.names):
        np.testing.assert_allclose(trace[name], expected[:, column], rtol=1e-5, atol=1e-12)
    assert np.nanmax(trace["striker_force"]) > 1


def same_bits(drum, other):
    return drum.save() == other.save() and drum.model is other.model


@pytest.mark.parametrize("wrong", [
    lambda: dataclasses.replace(tabor.strike(), time=9.0), lambda: tabor.strike(striker="mace"),
    lambda: tabor.change(0, "mic.nowhere.gain", 1), lambda: "strike",
    lambda: tabor.swap(0, tabor.Model("tabor", sample_rate=44100, quality="draft"))])
def test_a_refused_call_changes_nothing(snare, wrong):
    drum = tabor.Drum(snare)
    drum.process(500, [tabor.strike()])
    before = drum.copy()
    tom = tabor.Model("tom-12", quality="draft")
    for play in (drum.process, drum.trace):
        with pytest.raises((ValueError, TypeError)):
            play(64, [tabor.swap(0, tom), tabor.strike(), wrong()])
        assert same_bits(drum, before)
    np.testing.assert_array_equal(drum.process(64, [tabor.strike()]), before.process(64, [tabor.strike()]))


def test_an_event_that_was_tampered_with_changes_nothing(snare):
    drum, other = tabor.Drum(snare), tabor.Drum(snare)
    for key, value in (("id", 2**40), ("radius", "30%")):
        event = tabor.strike(0, id=2)
        event.fields[key] = value
        for play in (drum.process, drum.trace):
            with pytest.raises((OverflowError, TypeError)):
                play(64, [tabor.swap(0, tabor.Model("tom-12", quality="draft")), event])
            assert same_bits(drum, other)


@pytest.mark.parametrize("frames, error", [(-1, ValueError), (2**31, ValueError), (1.5, TypeError), (True, TypeError),
                                           ("64", TypeError)])
def test_wrong_numbers_of_frames_are_refused(snare, frames, error):
    drum = tabor.Drum(snare)
    for play in (drum.process, drum.trace):
        with pytest.raises(error, match="frames"):
            play(frames)
    assert drum.process(np.int64(8)).shape == (len(snare.mics), 8)


def test_a_copy_is_from_between_two_calls(monkeypatch, snare):
    """Another thread swaps the drum's model while the copy is made."""
    drum, original = tabor.Drum(snare), tabor.Drum.__init__
    tom = tabor.Model("tom-12", quality="draft")
    def swap_meanwhile(*arguments):
        original(*arguments)
        other_thread = threading.Thread(target=drum.process, args=(64, [tabor.swap(0, tom)]))
        other_thread.start()
        other_thread.join()
    monkeypatch.setattr(tabor.Drum, "__init__", swap_meanwhile)
    copied = drum.copy()
    assert copied.model is snare and drum.model is tom


def test_threads_take_turns(snare):
    drum = tabor.Drum(snare)
    models, done, errors = [tabor.Model("tom-12", quality="draft"), snare], threading.Event(), []
    def play():
        try:
            for i in range(60):
                drum.process(480, [tabor.swap(0, models[i % 2]), tabor.strike()])
        except Exception as error:  # shown by the assertion below
            errors.append(error)
        done.set()
    player = threading.Thread(target=play)
    player.start()
    while not done.is_set():
        assert drum.copy().model in models
        drum.ledger(), drum.probe(), drum.save()
        assert drum.is_silent in (False, True) and "tabor.Drum" in repr(drum)
    player.join()
    assert not errors and drum.statistics().frames > 0


def test_a_drum_says_what_it_is(snare):
    drum = tabor.Drum(snare, ["top"])
    assert repr(drum) == "<tabor.Drum 'tabor', 48000 Hz, draft, mics top, silent after 0.000 s>"
    drum.process(4800, [tabor.strike()])
    assert repr(drum).endswith("sounding after 0.100 s>")


def test_events_act_in_a_call_of_no_frames(snare):
    tom = tabor.Model("tom-12", quality="draft")
    for call in ("process", "trace"):
        drum = tabor.Drum(snare)
        assert getattr(drum, call)(0, [tabor.swap(0, tom), tabor.strike()]).shape[-1] == 0
        assert drum.model is tom and drum.statistics().strikes == 1
