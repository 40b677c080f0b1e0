# SPDX-License-Identifier: MIT
import numpy as np
import pytest

import tabor
import tabor.rendering


def test_strokes_sound_as_the_program_renders_them(program_sound):
    sound = tabor.render(tabor.Definition("tabor", {"wires.tension": 8}),
                         [tabor.strike(0.1, 4, radius=0.02), tabor.strike()], duration=0.3)
    expected = program_sound("tabor", "--duration", "0.3", "--set", "wires.tension=8",
                             "--strike", "time=0.1,velocity=4,radius=0.02", "--strike", "time=0")
    assert sound.dtype == np.float32 and sound.shape == (1, 14400)
    np.testing.assert_array_equal(sound, expected)
    assert np.abs(sound).max() > 0.01


def test_a_model_has_its_rate_and_quality(snare):
    assert tabor.render(snare, duration=0.01).shape == (1, 480)
    assert tabor.render("tabor", duration=0.01, sample_rate=44100, quality="draft").shape == (1, 441)
    with pytest.raises(ValueError, match="48000 Hz, not for 44100 Hz"):
        tabor.render(snare, sample_rate=44100)
    with pytest.raises(ValueError, match="quality 'draft', not 'live'"):
        tabor.render(snare, quality="live")


def test_no_events_are_silence(snare):
    assert (tabor.render(snare, [], duration=0.01) == 0).all()
    assert tabor.render(snare, [], duration=0).shape == (1, 0)


def test_wrong_durations_are_refused(snare):
    for wrong in (-1, 1e9, float("nan"), float("inf"), 10**400):
        with pytest.raises(ValueError, match="duration"):
            tabor.render(snare, [], duration=wrong)


@pytest.mark.parametrize("arguments", [
    ["tabor", "--quality", "draft"], ["frame-drum", "--set", "room.kind=hall"], ["timpani-26"]])
def test_a_sound_rings_out_as_the_programs(program_sound, arguments):
    changes = dict(pair.split("=") for pair in arguments[2:] if "=" in pair)
    drum = tabor.Definition(arguments[0], changes)
    quality = "draft" if "draft" in arguments else None
    sound = tabor.render(drum, [tabor.strike(), tabor.strike(0.1, 2)], quality=quality)
    expected = program_sound(*arguments, "--strike", "time=0", "--strike", "time=0.1,velocity=2")
    assert sound.shape == expected.shape and sound.shape[1] > 28800
    np.testing.assert_array_equal(sound, expected)
    np.testing.assert_array_equal(sound[:, :4800], tabor.render(drum, duration=0.1, quality=quality))


def test_a_sound_ends_between_half_a_second_and_20_s_after_the_last_event(monkeypatch, snare):
    assert tabor.render(snare, []).shape[1] == 24064  # whole blocks of 256 frames
    assert tabor.render(snare, [tabor.strike(), tabor.silence(1.0)]).shape[1] == 72192
    assert tabor.rendering._MOST_TIME == 20
    monkeypatch.setattr(tabor.rendering, "_MOST_TIME", 0.6)
    assert tabor.render(snare, [tabor.strike(0, 9)]).shape[1] == 28800
    with pytest.raises(ValueError, match="strike: 3601 s is outside of 3600 s"):
        tabor.render(snare, [tabor.strike(3601)])
