# SPDX-License-Identifier: MIT
import numpy as np
import pytest

import tabor


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
    for wrong in (-1, 1e9, float("nan")):
        with pytest.raises(ValueError, match="duration"):
            tabor.render(snare, [], duration=wrong)
