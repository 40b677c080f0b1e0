# SPDX-License-Identifier: MIT
import json
import pickle

import numpy as np
import pytest

import tabor


def test_modes_are_the_programs(program):
    expected = json.loads(program("modes", "tom-12", "--quality", "draft", "--json"))["modes"]
    modes = tabor.Model("tom-12", quality="draft").modes
    assert modes.dtype == tabor.MODE
    assert len(modes) == len(expected)
    for name in ("frequency", "decay_rate"):
        np.testing.assert_allclose(modes[name], [row[name] for row in expected], rtol=1e-9)
    assert list(modes["part"]) == [row["head"] for row in expected]


def test_shapes_of_modes():
    model = tabor.Model("tom-12", quality="draft")
    row = int(np.flatnonzero((model.modes["m"] == 0) & (model.modes["part"] == "batter"))[0])
    radius = model.definition["shell.radius"]
    shape = model.mode_shape(row, np.linspace(0, radius, 9))
    assert shape.shape == (9,)
    assert abs(shape[0]) == max(abs(shape)) and abs(shape[-1]) < 0.01 * abs(shape[0])
    assert model.mode_shape(row, 0.0) == shape[0]
    for wrong in ((row, 1.1 * radius, 0), (len(model.modes), 0.0, 0), (row, 0.0, 2)):
        with pytest.raises(ValueError, match="has no shape"):
            model.mode_shape(*wrong)


def test_live_unless_asked():
    assert tabor.Model("frame-drum").info.quality == "live"
    assert tabor.Model("frame-drum", quality="definition").info.quality == "studio"
    assert tabor.Model(tabor.Definition("frame-drum", {"quality.level": "draft"}),
                       quality="definition").info.quality == "draft"


def test_facts():
    info = tabor.Model("tabor", sample_rate=44100, quality="draft").info
    assert (info.sample_rate, info.quality, info.wire_count) == (44100, "draft", 1)
    assert info.mode_count > info.mode_rows > 50
    assert info.model_bytes > info.drum_bytes > 1000


def test_a_model_has_tensions_for_pitches_and_keeps_them():
    model = tabor.Model(tabor.Definition("frame-drum", {"batter.pitch": 200}), quality="draft")
    assert model.definition["batter.pitch"] == 0.0
    model.definition["batter.tension"] = 5000  # of a copy
    assert model.definition["batter.tension"] != 5000


@pytest.mark.parametrize("wrong", [
    lambda: tabor.Model("tabor", sample_rate=1), lambda: tabor.Model("tabor", quality="best"),
    lambda: tabor.Model(tabor.Definition("tabor", {"strike.radius": 0.5})), lambda: tabor.Model("nonesuch")])
def test_wrong_models_are_refused(wrong):
    with pytest.raises(tabor.Error):
        wrong()
    with pytest.raises(TypeError, match="the name of a preset is needed, not None"):
        tabor.Model(None)


def test_an_estimate_names_what_to_lower():
    largest = tabor.Definition("snare-14x5.5", {
        "wires.count": 40, "shell.radius": 0.6, "quality.wire_points": 400, "quality.bandwidth": 40000,
        "quality.two_way_bandwidth": 40000})
    estimate = tabor.Model.estimate(largest, sample_rate=192000, quality="reference")
    assert estimate.seconds > 60 and estimate.bytes > 1e9 and estimate.key == "wires.count"
    assert tabor.Model.estimate("tabor").seconds < 1


def test_a_saved_model_plays_the_same_bits():
    built = tabor.Model("bodhran-d-string", quality="draft")
    for loaded in (tabor.Model.load(built.save()), pickle.loads(pickle.dumps(built))):
        assert loaded.info._replace(model_bytes=0) == built.info._replace(model_bytes=0)
        assert loaded.save() == built.save() and repr(loaded) == repr(built)
        sounds = [tabor.Drum(model).process(2400, [tabor.strike()]) for model in (built, loaded)]
        assert np.any(sounds[0]) and np.array_equal(*sounds)


def test_a_path_is_no_saved_model():
    with pytest.raises(TypeError, match="bytes are needed, not 'tom.model'"):
        tabor.Model.load("tom.model")


@pytest.mark.parametrize("wrong", [b"", b"tabor" * 1000, lambda saved: saved[:-1],
                                   lambda saved: saved[:5000] + b"?" + saved[5001:]])
def test_bytes_that_are_no_saved_model_are_refused(wrong):
    if callable(wrong):
        wrong = wrong(tabor.Model("tabor", quality="draft").save())
    with pytest.raises(tabor.Error, match="saved model"):
        tabor.Model.load(wrong)
