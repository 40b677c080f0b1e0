# SPDX-License-Identifier: MIT
import copy
import json
import math
import os
import pickle
from pathlib import Path

import numpy as np
import pytest

import tabor

PRESETS = Path(__file__).resolve().parents[2] / "presets"


def test_values_have_their_types():
    drum = tabor.Definition("snare-14x5.5", {"batter.tension": np.float32(4000), "wires.count": np.int64(12)})
    assert drum["batter.tension"] == 4000.0
    assert (drum["wires.count"], drum["wires.head"]) == (12, "resonant")
    assert math.isnan(drum["wire.1.tension"])
    assert drum.copy({"wires.count": 8.0})["wires.count"] == 8
    with pytest.raises(tabor.Error, match="wires.count = '8.5' is not a whole number"):
        drum["wires.count"] = 8.5
    with pytest.raises(TypeError, match="a key is a string, not 3"):
        drum[3] = 1


def test_a_definition_is_a_mapping():
    drum = tabor.Definition("tom-12")
    assert dict(drum)["drum.name"] == "tom-12"
    assert len(drum) == len(list(drum))
    assert "batter.tension" in drum and "batter.tensoin" not in drum
    assert drum.get("batter.tensoin") is None


def test_equal_definitions_are_equal():
    drum = tabor.Definition("snare-14x5.5")
    assert drum == tabor.Definition(None, dict(drum)) == drum.copy()
    assert drum != drum.copy({"batter.tension": 4321})
    assert drum["batter.tension"] != 4321


@pytest.mark.parametrize("name", ["frame-drum", "snare-14x5.5"])
@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy, lambda drum: pickle.loads(pickle.dumps(drum))])
def test_definitions_can_be_copied_and_pickled(name, duplicate):
    drum = tabor.Definition(name, {"mic.side.height": 0.3})
    other = duplicate(drum)
    assert other == drum and other.mics == drum.mics and other.strikers == drum.strikers
    other["batter.tension"] = 4321
    assert other != drum


def test_a_pitch_becomes_a_tension():
    drum = tabor.Definition("snare-14x5.5", {"batter.pitch": "A3"})
    assert drum["batter.pitch"] == 220.0
    drum.tune()
    assert drum["batter.pitch"] == 0.0
    assert drum.pitch() == pytest.approx(220, rel=1e-4)
    with pytest.raises(tabor.UnknownNameError):
        tabor.Definition("frame-drum").pitch("resonant")
    with pytest.raises(tabor.Error, match="unknown head 'upper'"):
        drum.pitch("upper")


def test_a_new_microphone_comes_with_its_first_key():
    drum = tabor.Definition("frame-drum", {"mic.side.height": 0.3})
    assert drum.mics[-1] == "side"
    assert "side" not in tabor.Definition("frame-drum").mics


def test_a_refused_change_changes_nothing():
    drum = tabor.Definition("tabor")
    before = drum.copy()
    with pytest.raises(tabor.Error) as refused:
        drum.update({"batter.damping_0": 1, "batter.tension": 1e9})
    error = refused.value
    assert (error.key, error.value, error.minimum, error.maximum) == ("batter.tension", "1e9", 100, 20000)
    assert error.status == "range"
    assert drum == before


@pytest.mark.parametrize("wrong, status, key", [
    (lambda: tabor.Definition("nonesuch"), "name", ""),
    (lambda: tabor.Definition("tabor")["batter.tensoin"], "key", "batter.tensoin"),
    (lambda: tabor.Definition("tabor", {"mic.none such.gain": 1}), "key", "mic.none such.gain"),
    (lambda: tabor.Definition("tabor", {"batter.tension": "tight"}), "value", "batter.tension"),
    (lambda: tabor.Definition("tabor", {"batter.tension": math.nan}), "value", "batter.tension"),
    (lambda: tabor.Definition("tabor", {"drum.name": "a\0b"}), "value", ""),
    (lambda: tabor.Definition("tabor", {"strike.striker": "mace"}).validate(), "name", "strike.striker"),
])
def test_errors_name_the_key(wrong, status, key):
    with pytest.raises(tabor.Error) as refused:
        wrong()
    assert (refused.value.status, refused.value.key) == (status, key)
    assert isinstance(refused.value, KeyError) == (status in ("name", "key"))
    assert "\n" not in str(refused.value)


def test_presets_are_listed(program):
    expected = json.loads(program("presets", "--json"))["presets"]
    assert [preset.name for preset in tabor.presets()] == [row["name"] for row in expected]


def test_the_table_of_parameters():
    row = next(row for row in tabor.parameters() if (row.section, row.key) == ("batter", "tension"))
    assert (row.unit, row.minimum, row.maximum, row.live) == ("N/m", 100, 20000, False)
    row = next(row for row in tabor.parameters() if (row.section, row.key) == ("resonant", "damping_k"))
    assert (row.unit, row.minimum, row.maximum, row.live) == ("m/s", 0, 5, False)
    row = next(row for row in tabor.parameters() if (row.section, row.key) == ("room", "kind"))
    assert row.choices == ("none", "booth", "studio", "hall")


@pytest.mark.parametrize("name", [preset.name for preset in tabor.presets()])
def test_preset_files_are_read_and_written(name):
    drum = tabor.Definition.from_ini((PRESETS / f"{name}.ini").read_text(encoding="utf-8"))
    assert drum == tabor.Definition(name)
    assert tabor.Definition.from_ini(drum.to_ini()) == drum


def test_the_program_reads_what_is_written(program, tmp_path):
    drum = tabor.Definition("snare-14x5.5", {"batter.tension": 4321.0, "wire.3.tension": 4.5})
    (tmp_path / "mine.ini").write_text(drum.to_ini(), encoding="utf-8")
    shown = program("show", os.fspath(tmp_path / "mine.ini")).decode()
    assert tabor.Definition.from_ini(shown) == drum


@pytest.mark.parametrize("ini, said", [
    ("[batter]\ntension", "line 2"), ("tension = 3", "line 1"), ("[better]\n", "line 1: .*better"),
    ("[batter]\ntension = 1e9\n", "line 2: batter.tension"), ("[batter]\n[batter]\n", "line 2: .*twice"),
    ("[batter]\n tension = 3000\n", "line 2: .*indented"), ("[batter]\ntension = 3000", "line 2: .*cut off"),
    ("[batter]\nx = \0\n", "line 2: a control character"), ("", "no section")])
def test_a_wrong_preset_file_is_refused(ini, said):
    with pytest.raises(tabor.Error, match=said):
        tabor.Definition.from_ini(ini)


def test_an_error_of_a_file_names_file_and_line(tmp_path):
    (tmp_path / "mine.ini").write_text("[batter]\n\ntensoin = 3000\n", encoding="utf-8")
    with pytest.raises(tabor.UnknownNameError, match=r"mine\.ini:3: .*tension") as raised:
        tabor.Definition.load(tmp_path / "mine.ini")
    assert raised.value.key == "batter.tensoin"
    assert (raised.value.line, raised.value.column) == (3, 1)


@pytest.mark.parametrize("name", [preset.name for preset in tabor.presets()])
def test_a_saved_definition_is_loaded_again(name, tmp_path, program):
    drum = tabor.Definition(name, {"batter.tension": 3456.7, "drum.name": "Trommel für Änne = 1"})
    drum.save(tmp_path / "mine.ini")
    assert tabor.Definition.load(os.fspath(tmp_path / "mine.ini")) == drum
    assert tabor.Definition.from_ini(program("show", str(tmp_path / "mine.ini")).decode()) == drum


def test_a_file_is_replaced_whole_or_not_at_all(tmp_path, monkeypatch):
    path, drum = tmp_path / "mine.ini", tabor.Definition("tabor")
    path.write_text("before")
    path.chmod(0o640)
    drum.save(path)
    assert tabor.Definition.load(path) == drum and path.stat().st_mode & 0o777 == 0o640
    before = path.read_text()
    def fail(*_):
        raise OSError("disk full")
    for wrong in ({"drum.comment": "one ; two"}, {"drum.comment": " one"}, {"strike.striker": "mace"}):
        with pytest.raises(tabor.Error) as refused:
            drum.copy(wrong).save(path)
        assert refused.value.key == list(wrong)[0]
    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(OSError, match="disk full"):
        drum.copy({"batter.tension": 4000}).save(path)
    assert path.read_text() == before and list(tmp_path.iterdir()) == [path]
    with pytest.raises(OSError):
        drum.save(tmp_path / "none" / "mine.ini")


def test_a_definition_says_what_it_is():
    assert repr(tabor.Definition("tabor")) == (
        "<tabor.Definition 'tabor', 300 mm, 1 head, 1 wire, strikers stick, mics top, bottom, far, left, right>")
    assert ", 356 mm, 2 heads, 20 wires, strikers stick" in repr(tabor.Definition("snare-14x5.5"))
