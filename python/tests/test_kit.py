# SPDX-License-Identifier: MIT
"""Kits of drums that hear each other."""

import os
import wave

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
    assert kit.drums == ("bodhran", "frame-drum", "string-bodhran", "tabor", "splash")
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


def write_wave(path, sides, rate):
    with wave.open(os.fspath(path), "wb") as file:
        file.setnchannels(len(sides))
        file.setsampwidth(2)
        file.setframerate(rate)
        file.writeframes(np.round(np.array(sides).T * 32767).astype("<i2").tobytes())


@pytest.fixture
def hats(tmp_path):
    """A kit file with a drum and two sounds, one of another rate."""
    noise = np.random.default_rng(1).uniform(-0.2, 0.2, (2, 3000))
    write_wave(tmp_path / "hat.wav", noise[:1], 44100)
    write_wave(tmp_path / "open.wav", noise, 48000)
    (tmp_path / "hats.ini").write_text(
        "[drum.tabor]\npreset = tabor\nhead = 45\n[note.42]\nsample = hat.wav\nchoke = 1\n"
        "[note.46]\nsample = open.wav\ngain = -6\nchoke = 1\n", encoding="utf-8")
    return tmp_path / "hats.ini"


def test_sounds_of_notes_are_those_of_the_program(hats, program_sound, tmp_path):
    track = bytes((0, 0x99, 46, 127, 60, 0x99, 42, 90, 0, 0x99, 45, 100, 0, 0xFF, 0x2F, 0))
    song = tmp_path / "song.mid"
    song.write_bytes(b"MThd\0\0\0\6\0\0\0\1\1\xe0MTrk" + len(track).to_bytes(4, "big") + track)
    theirs = program_sound("--kit", str(hats), "--midi-file", str(song), "--quality", "draft", "--duration", "0.2",
                           channels=2)
    kit = tabor.Kit(hats, quality="draft")
    assert list(kit.samples) == [42, 46] and kit.samples[42] == os.fspath(hats.parent / "hat.wav")
    events = kit.midi_events(song)
    assert [name for name, _ in events] == ["note.46", "note.42", "tabor"]
    assert np.array_equal(kit.render(song, 0.2), theirs)
    assert np.abs(theirs[:, :1000]).max() > 0.01


def test_a_sound_may_come_from_anywhere(hats):
    kit = tabor.Kit(hats, {"kit.coupling": "off"}, quality="draft")
    kit.set_sample(46, np.full(100, 0.5), kit.sample_rate)
    mix = kit.process(200, [("note.46", tabor.strike(0, velocity=0.5))])
    assert np.allclose(mix[:, :100], 0.5 * 0.25 * 10 ** -0.3, atol=1e-6) and not mix[:, 100:].any()
    with pytest.raises(ValueError, match="shape"):
        kit.set_sample(46, np.zeros((3, 10)), 48000)
    with pytest.raises(tabor.Error, match="sample rate"):
        kit.set_sample(46, np.zeros(10), 1)
    with pytest.raises(KeyError, match="no note"):
        kit.process(10, [("note.128", tabor.strike(0))])
    with pytest.raises(ValueError, match="struck and silenced"):
        kit.process(10, [("note.46", tabor.gain(0, 1))])


def test_a_file_that_is_gone_is_said(hats):
    (hats.parent / "hat.wav").unlink()
    with pytest.warns(UserWarning, match="note 42 is silent"):
        kit = tabor.Kit(hats, quality="draft")
    assert not kit.process(100, [("note.42", tabor.strike(0, velocity=1))]).any()


def test_held_notes_are_those_of_the_program(program_sound, tmp_path):
    (tmp_path / "held.ini").write_text(
        "[drum.tabor]\npreset = tabor\nhead = 45\nbuzz = 47\n[drum.frame]\npreset = frame-drum\nx = 0.6\n"
        "striker.brush.kind = brush\nhead = 48\nsweep = 50\n", encoding="utf-8")
    track = bytes((0, 0x99, 47, 100, 30, 0x99, 50, 80, 20, 0xA9, 47, 90, 10, 0xB9, 16, 100, 20, 0xB9, 17, 30,
                   60, 0x89, 47, 0, 20, 0x89, 50, 0, 0, 0xFF, 0x2F, 0))
    song = tmp_path / "song.mid"
    song.write_bytes(b"MThd\0\0\0\6\0\0\0\1\1\xe0MTrk" + len(track).to_bytes(4, "big") + track)
    theirs = program_sound("--kit", str(tmp_path / "held.ini"), "--midi-file", str(song), "--quality", "draft", "--duration",
                           "0.4", channels=2)
    kit = tabor.Kit(tmp_path / "held.ini", quality="draft")
    kinds = [event.kind for _, event in kit.midi_events(song)]
    assert {"strike", "press", "move", "release"} <= set(kinds)
    assert np.array_equal(kit.render(song, 0.4), theirs)
