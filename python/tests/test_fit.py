# SPDX-License-Identifier: MIT
"""Fitting recorded drums. The recordings here are simulated, so that the truth is known."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
import soundfile

import tabor
from tabor.fit import Settings, fit, read_request
from tabor.fit.__main__ import _doubt, main
from tabor.fit.comparison import best_speed, partial_differences
from tabor.fit.features import BANDS, LABELS, features, make_noise, noise_of
from tabor.fit.inference import infer
from tabor.fit.journal import Journal
from tabor.fit.modal_fit import fit_partials
from tabor.fit.parameters import space_of, unit_of
from tabor.fit.partials import find_partials
from tabor.fit.recordings import Stroke, checked, from_stroke
from tabor.fit.search import objective_of, search
from tabor.fit.simulation import Plan

RATE = 48000
BASE = {"room.kind": "studio", "mic.top.response": "flat"}
TRUTH = {"batter.tension": 1650.0, "resonant.tension": 1500.0, "batter.damping_0": 8.0}
REQUEST = """
[drum]
name = "found"
preset = "tom-10"
[known]
"room.kind" = "studio"
"mic.top.response" = "flat"
[strokes]
top = "stroke-*.wav"
"""


def struck(speeds, seed=0, preset="tom-10", **changes):
    random = np.random.default_rng(seed)
    model = tabor.Model(tabor.Definition(preset, {**BASE, **TRUTH, **changes}), RATE)
    sounds = [tabor.render(model, [tabor.strike(0.02, velocity=speed)], 1.2)[0].astype(float) for speed in speeds]
    return [sound + 3e-4 * np.abs(sound).max() * random.standard_normal(len(sound)) for sound in sounds]


@pytest.fixture(scope="module")
def recorded():
    return [checked(f"stroke {i}", sound[None], RATE) for i, sound in enumerate(struck([1.0, 2.2, 5.0]))]


@pytest.fixture
def folder(tmp_path):
    for i, sound in enumerate(struck([1.5, 5.0])):
        soundfile.write(tmp_path / f"stroke-{i}.wav", sound, RATE, subtype="FLOAT")
    (tmp_path / "drum.toml").write_text(REQUEST)
    return tmp_path


def test_damped_sines_are_found():
    time = np.arange(RATE) / RATE
    truth = [(180.0, 6.0, 1.0), (271.0, 9.0, 0.5), (402.0, 12.0, 0.4), (530.0, 20.0, 0.6)]
    sound = sum(size * np.exp(-decay * time) * np.cos(2 * np.pi * frequency * time) for frequency, decay, size in truth)
    found = find_partials([checked("sines", sound[None], RATE)])
    np.testing.assert_allclose(found.frequency, [row[0] for row in truth], rtol=1e-4)
    np.testing.assert_allclose(found.decay_rate, [row[1] for row in truth], rtol=0.02)


def test_noise_has_the_level_that_was_measured():
    random = np.random.default_rng(1)
    sound = 1e-3 * random.standard_normal(RATE)
    sound[0] = 1.0
    noise = noise_of(sound, RATE)
    expected = 1e-6 / (RATE / 2)  # white noise: its mean square, over the bandwidth
    assert abs(10 * np.log10(np.median(noise[8:]) / expected)) < 1
    made = make_noise(np.full(len(BANDS), expected), RATE, RATE, random)
    assert np.std(made) == pytest.approx(1e-3, rel=0.03)


def test_features_are_levels_of_bands():
    time = np.arange(RATE) / RATE
    described = features(np.sin(2 * np.pi * 1000 * time)[None], RATE)
    early = described[:len(BANDS)]
    assert len(described) == len(LABELS) and abs(early[BANDS.index(1000.0)]) < 0.1
    louder = features(10 * np.sin(2 * np.pi * 1000 * time)[None], RATE)
    np.testing.assert_allclose(described, louder, atol=1e-5)  # gains do not count


def test_intervals_of_a_linear_description_hold_the_truth_in_nine_of_ten():
    random, held, count = np.random.default_rng(2), [], 6
    low, high = -np.ones(count), np.ones(count)
    for _ in range(30):
        slopes = random.normal(size=(40, count)) * [3, 3, 0.5, 0.5, 0.1, 0.0]
        points, truth = random.uniform(low, high, (60, count)), random.uniform(low, high, count)
        found = infer(points, points @ slopes.T + random.normal(size=(60, 40)),
                      slopes @ truth + random.normal(size=40), low, high, random)
        ends = np.quantile(found.samples, [0.05, 0.95], axis=0)
        held.append((ends[0] <= truth) & (truth <= ends[1]))
    assert 0.84 < np.mean(held) < 0.96
    assert ends[1, 0] - ends[0, 0] < 0.4  # what is described is known
    assert ends[1, -1] - ends[0, -1] > 1.6  # what is not keeps its limits


def test_the_first_stage_finds_the_tension_over_density_of_the_batter_head(recorded):
    space = space_of(tabor.Definition("tom-10", BASE), {}, {}, 3)
    found = fit_partials(space, find_partials(recorded))
    values = space.values(found.point)
    ratio = values["batter.tension"] / values["batter.surface_density"]
    assert ratio == pytest.approx(TRUTH["batter.tension"] / space.base["batter.surface_density"], rel=0.03)


def test_a_fit_finds_the_drum_and_goes_on_where_it_was(folder):
    request = read_request(folder / "drum.toml")
    settings = Settings(counts=(30, 30), generations=2, quality="draft")
    found = fit(request, str(folder / "whole"), settings)
    by_key = {one.key: one for one in found.estimates}
    ratio = by_key["batter.tension/batter.surface_density"]
    assert ratio.determined
    assert ratio.value == pytest.approx(TRUTH["batter.tension"] / request.space.base["batter.surface_density"], rel=0.03)
    assert ratio.low <= ratio.value <= ratio.high
    # A journal that was cut off within a line gives the same result.
    (folder / "cut").mkdir()
    lines = (folder / "whole/journal.jsonl").read_bytes().splitlines(keepends=True)
    (folder / "cut/journal.jsonl").write_bytes(b"".join(lines[:50]) + lines[50][:100])
    assert fit(request, str(folder / "cut"), settings).estimates == found.estimates
    assert (folder / "cut/journal.jsonl").read_bytes() == (folder / "whole/journal.jsonl").read_bytes()


def test_the_objective_is_one_if_all_differ_by_their_floors():
    plan = Plan(None, RATE, ("top",), (0.2, 1.0), True, (), ((0, 0), (1, 0), (2, 0)), "draft")
    groups = plan.groups()
    assert len(groups) == 3 + 3 + 1 + 2 * len(LABELS)
    objective = objective_of(np.zeros(len(groups)), groups, np.full(len(LABELS), 2.0))
    assert objective.floor[0] == pytest.approx(np.log(2) * 10 / 1200) and objective.floor[-1] == 2.0
    assert objective.of(objective.floor) == pytest.approx(1)
    assert objective.of(10 * objective.floor) == pytest.approx(3 * (20 - 3))  # along a line
    lost = objective.floor.copy()
    lost[0] = np.nan
    assert objective.of(lost) == pytest.approx(1 + (9 - 1) / 3 / 7)  # seven groups count alike


def test_a_search_finds_the_lowest_place():
    low, high, truth = -np.ones(4), np.ones(4), np.array([0.3, -0.2, 0.6, 0.9])
    slopes = 10 * np.random.default_rng(4).normal(size=(len(LABELS), 4))
    groups = Plan(None, RATE, ("top",), (1.0,), False, (), (), "draft").groups()
    objective = objective_of(slopes @ truth, groups, np.full(len(LABELS), 0.05))  # an objective of 1 is near enough
    found = search(objective, np.zeros(4), np.full(4, 0.5), low, high, lambda points, done: [slopes @ point for point in points],
                   60, 1, lambda text: None)
    np.testing.assert_allclose(found.point, truth, atol=0.01)
    assert found.objective == objective.of(slopes @ found.point) <= 1
    assert len(found.points) < 60 * 16  # strokes are no nearer to each other: it ends


def test_a_search_follows_straight_lines():
    random, count = np.random.default_rng(5), 20
    low, high, truth = -np.ones(count), np.ones(count), random.uniform(-0.7, 0.7, count)
    slopes = 10 * random.normal(size=(len(LABELS), count))
    groups = Plan(None, RATE, ("top",), (1.0,), False, (), (), "draft").groups()
    observed = slopes @ truth
    observed[:5] += 100  # as no drum is; these draw the lowest place 0.06 away
    objective = objective_of(observed, groups, np.full(len(LABELS), 2.0))

    def describe(points, _):
        simulated = np.array(points) @ slopes.T
        simulated[:, -3:][random.uniform(size=(len(points), 3)) < 0.5] = np.nan
        return list(simulated)

    found = search(objective, np.zeros(count), np.full(count, 0.5), low, high, describe, 10, 1, lambda text: None)
    np.testing.assert_allclose(found.point, truth, atol=0.1)  # without lines it is 0.5 to 0.7 away then


def test_strokes_are_sorted_from_soft_to_hard(tmp_path):
    for name, sound in zip(("stroke-10", "stroke-2"), struck([1.5, 5.0])):
        soundfile.write(tmp_path / f"{name}.wav", sound, RATE, subtype="FLOAT")
    for normalized, first in ((False, "stroke-10"), (True, "stroke-2")):  # by their levels; by their names
        (tmp_path / "drum.toml").write_text(REQUEST + f"[recording]\nnormalized = {str(normalized).lower()}\n")
        names = [stroke.recordings[0].name for stroke in read_request(tmp_path / "drum.toml").strokes]
        assert names[0].endswith(f"{first}.wav")


def test_noise_before_a_stroke_is_not_its_onset():
    sound = struck([4.0])[0]
    noisy = sound + 0.01 * np.abs(sound).max() * np.random.default_rng(5).standard_normal(len(sound))
    assert np.argmax(np.abs(noisy) > 0.03 * np.abs(noisy).max()) < 0.015 * RATE  # a click of the noise is above 3 %
    begins = [len(one) - len(from_stroke(one, RATE)) for one in (sound, noisy)]
    assert begins[0] > 0.02 * RATE and abs(begins[0] - begins[1]) < 0.0005 * RATE


def test_a_speed_is_found_by_spectrum_and_level(recorded):
    model = tabor.Model(tabor.Definition("tom-10", {**BASE, **TRUTH}), RATE)
    strokes = [Stroke((one,)) for one in recorded]
    for hardest in (None, (strokes[2], 5.0)):
        assert best_speed(model, ["top"], strokes[1], hardest) == pytest.approx(2.2, rel=0.1)


EXAMPLES = sorted((Path(__file__).parents[2] / "examples/fit").glob("*.toml"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_a_request_of_the_examples_is_right(example, tmp_path):
    text = example.read_text()
    sound = 0.5 * struck([4.0])[0] / np.abs(struck([4.0])[0]).max()
    names = [name.replace("*", "01") for name in re.findall(r'"([^"]*\.flac)"', text)]
    for name in names:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        soundfile.write(tmp_path / name, sound, RATE, subtype="PCM_24")
    (tmp_path / example.name).write_text(text)
    request = read_request(tmp_path / example.name)
    assert (len(request.strokes) + len(request.kept)) * len(request.mics) == len(names)


def test_units_are_those_of_preset_files():
    for key, unit in (("batter.tension", "N/m"), ("striker.stick.mass", "kg"), ("mic.top.height", "m"), ("room.level", ""),
                      ("speed", "m/s"), ("batter.loss", "1/s"), ("batter.tension/batter.surface_density", "m2/s2")):
        assert unit_of(key) == unit


def test_a_journal_of_another_task_is_refused(tmp_path):
    path = str(tmp_path / "journal.jsonl")
    Journal(path, "one", 1).close()
    with pytest.raises(tabor.Error, match="another request"):
        Journal(path, "other", 1)
    (tmp_path / "journal.jsonl").write_text("no journal\n")
    with pytest.raises(tabor.Error, match="no journal"):
        Journal(path, "one", 1)


def music(seconds):
    random = np.random.default_rng(3)
    time = np.arange(int(seconds * RATE)) / RATE
    return sum(np.sin(2 * np.pi * random.uniform(100, 900) * time) * (np.floor(4 * time) % 3 == part) for part in range(3))


@pytest.mark.parametrize("sound, complaint", [
    (np.zeros(2 * RATE), "no sound"),
    (struck([4.0])[0][:RATE // 1000 + 1000], "it lasts"),
    (np.clip(20 * struck([4.0])[0] / np.abs(struck([4.0])[0]).max(), -1, 1), "clipped"),
    (music(3.0), "not one stroke"),
    (np.concatenate([struck([4.0])[0][:RATE // 4], struck([4.0])[0]]), "not one stroke"),
])
def test_what_is_no_stroke_is_refused(sound, complaint):
    with pytest.raises(tabor.Error, match=complaint) as refused:
        checked("it.wav", sound[None], RATE)
    assert str(refused.value).startswith("it.wav: ") and "\n" not in str(refused.value)


def at_once(one, other):
    """Strokes on two drums, as loud as each other."""
    return [a / np.abs(a).max() + b / np.abs(b).max() for a, b in zip(one, other)]


def test_two_drums_at_once_are_refused_in_a_line(folder, capsys):
    speeds = [1.5, 5.0]
    for i, sound in enumerate(at_once(struck(speeds), struck(speeds, preset="floor-tom-16"))):
        soundfile.write(folder / f"stroke-{i}.wav", sound, RATE, subtype="FLOAT")
    assert main([str(folder / "drum.toml"), "-o", str(folder / "out"), "-q"]) == 1
    said = capsys.readouterr().err
    assert "is it the only one that sounds?" in said and said.count("\n") == 1
    assert not (folder / "out").exists()


def test_partials_of_another_drum_are_named():
    speeds, model = [1.5, 5.0], tabor.Model(tabor.Definition("tom-10", {**BASE, **TRUTH}), RATE)
    doubts = []
    for sounds in (struck(speeds), at_once(struck(speeds), struck(speeds, preset="tom-12", **{"batter.tension": 900.0}))):
        strokes = [Stroke((checked("both", sound[None], RATE),)) for sound in sounds]
        doubts.append(_doubt(1.0, partial_differences(model, ["top"], strokes, speeds)))
    assert doubts[0] == "" and "lacks the partials at" in doubts[1] and "one drum alone" in doubts[1]
    assert "is far from the recordings" in _doubt(6.0, [])


@pytest.mark.parametrize("line, complaint", [
    ("[drums]", "no table [drums]"),
    ("[drum]\nname = \"my/tom\"", "drum.name = 'my/tom'"),
    ("[known]\nroom.kind = \"studio\"", "the key in quotes"),
    ("[known]\n\"batter.tension\" = 3000\n[range]\n\"batter.tension\" = [1, 2]", "one of them"),
    ("[batter]\nmil = 10\ncoated = \"no\"", "batter.coated = 'no'"),
    ("[recording]\nnormalized = \"false\"", "recording.normalized"),
    ("[strokes]\ntop = [\"none.wav\"]", "no file"),
    ("[drum]\nsize = 3", "[drum] has no size"),
    ("[drum]\ndiameter = -8", "drum.diameter = -8"),
    ("[drum]\nsnares = \"on\"", "0 wires"),
    ("[batter]\nplies = 2", "lacks mil"),
    ("[known]\n\"batter.mass\" = 3", "batter.mass"),
    ("[strokes]\ntop = \"a.wav\"\n[range]\n\"batter.tension\" = [3000, 1000]", "batter.tension: 3000 to 1000"),
    ("[strokes]\ntop = \"a.wav\"\n[range]\n\"batter.unevenness\" = [0.1, 9]", "batter.unevenness"),
    ("[strokes]\nabove = \"a.wav\"", "no such microphone"),
    ("[strokes]\ntop = \"none-*.wav\"", "no such file"),
    ("", "names no recordings"),
    ("[drum", "drum.toml"),
])
def test_a_wrong_request_is_refused_in_a_line(tmp_path, capsys, line, complaint):
    soundfile.write(tmp_path / "a.wav", struck([4.0])[0], RATE, subtype="FLOAT")
    (tmp_path / "drum.toml").write_text(line)
    assert main([str(tmp_path / "drum.toml"), "-o", str(tmp_path / "out")]) == 2
    said = capsys.readouterr().err
    assert complaint in said and said.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_the_command_writes_a_preset_and_a_table(folder, capsys):
    assert main([str(folder / "drum.toml"), "-o", str(folder / "out"), "--rounds", "30", "--generations", "0", "-q", "--json"]) == 0
    preset = tabor.Definition.load(folder / "out/found.ini")
    assert preset["shell.radius"] == tabor.Definition("tom-10")["shell.radius"]
    rows = (folder / "out/parameters.csv").read_text().splitlines()
    assert rows[0].startswith("parameter,value,low,high") and any(row.startswith("batter.tension,") for row in rows)
    said = capsys.readouterr()
    facts = json.loads(said.out)
    assert said.err == "" and facts["name"] == "found" and len(facts["fitted"]) == 2
    assert f"{facts['parameters'][0]['value']:.5g}" == rows[1].split(",")[1]
    report = (folder / "out/report.html").read_text()
    assert report.count("<audio") == 4 and report.count("<img") == 4 and "batter.tension" in report  # two strokes
    assert "http" not in report  # it needs no other file
    first = json.loads((folder / "out/journal.jsonl").read_text().splitlines()[0])
    assert list(first) == ["task"]
