# SPDX-License-Identifier: MIT
"""Kits of drums that hear each other."""

import numpy as np
import pytest

import tabor


@pytest.fixture(scope="module")
def kit():
    return tabor.Kit("frame-drums", quality="draft")


STROKES = [("tabor", tabor.strike(0.01, velocity=4)), ("bodhran", tabor.strike(0.05)), (None, tabor.silence(0.15))]


def test_kits_are_listed():
    assert "standard" in [row.name for row in tabor.kits()]
    assert all(row.comment for row in tabor.kits())


def test_settings_of_drums_that_are_not_there():
    with pytest.raises(tabor.UnknownNameError, match="no drum 'snar'"):
        tabor.Kit("standard", {"drum.snar.batter.pitch": "A3"})
    added = tabor.Kit("frame-drums", {"drum.high.preset": "tom-10", "drum.high.x": 1}, quality="draft")
    assert added.drums[-1] == "high"


def test_facts(kit):
    assert kit.drums == ("bodhran", "frame-drum", "string-bodhran", "tabor")
    assert kit.sample_rate == 48000
    assert kit.models["tabor"].mics[-1] == "kit"
    assert "frame-drums" in repr(kit)


def test_sound_and_counters(kit):
    sound = kit.render(STROKES, 0.2)
    assert sound.shape == (2, 9600) and sound.dtype == np.float32
    assert np.abs(sound).max() > 1e-3 and np.abs(sound).max() < 2
    assert kit.statistics("tabor").strikes == 1
    assert kit.statistics("frame-drum").strikes == 0
    assert kit.ledger("tabor").injected > 0


def test_blocks_and_states_change_no_bit(kit):
    whole = kit.render(STROKES, 0.2)
    kit.reset()
    first = kit.process(4000, STROKES[:2])
    state = kit.save()
    other = tabor.Kit("frame-drums", quality="draft")
    other.load(state)
    silence = [(None, tabor.silence(0.15 - 4000 / 48000))]
    assert np.array_equal(np.hstack((first, other.process(5600, silence))), whole)
    with pytest.raises(tabor.Error):
        other.load(state[:-1])


def test_the_program_says_the_same(kit, program_sound, tmp_path):
    track = bytes((0, 0x99, 45, 127, 0, 0xFF, 0x2F, 0))  # velocity 127 is 10 m/s
    song = tmp_path / "song.mid"
    song.write_bytes(b"MThd\0\0\0\6\0\0\0\1\1\xe0MTrk" + len(track).to_bytes(4, "big") + track)
    theirs = program_sound("--kit", "frame-drums", "--midi-file", str(song), "--quality", "draft", "--duration", "0.2",
                           channels=2)
    assert np.array_equal(kit.render([("tabor", tabor.strike(0, velocity=10))], 0.2), theirs)


def test_what_is_refused(kit, tmp_path):
    (tmp_path / "drum.ini").write_text("\n[drum]\nname = x\n", encoding="utf-8")
    with pytest.raises(tabor.Error, match=r"drum\.ini:2: a kit has no section 'drum'"):
        tabor.Kit(tmp_path / "drum.ini")
    with pytest.raises(tabor.Error, match="did you mean"):
        tabor.Kit("standart")
    with pytest.raises(tabor.Error, match="kit has no key"):
        tabor.Kit("frame-drums", {"kit.colour": "red"})
    with pytest.raises(KeyError, match="no drum is called"):
        kit.process(10, [("snare", tabor.strike())])
    with pytest.raises(ValueError, match="outside"):
        kit.process(10, [("tabor", tabor.strike(1.0))])
    with pytest.raises(ValueError, match="stay"):
        kit.process(10, [("tabor", tabor.replace(0, kit.models["bodhran"]))])
