# SPDX-License-Identifier: MIT
"""Each song is rendered by the program and by the package, to the same bits."""

import numpy as np
import pytest

import tabor

# Songs of General MIDI have cymbals; a test below asks for the warning of them.
pytestmark = pytest.mark.filterwarnings("ignore:.*notes that play no drum:tabor.MidiWarning")


def number(value):
    """Seven bits a byte, the top bit set in all but the last."""
    rest = bytes([value & 0x7F])
    while value > 0x7F:
        value >>= 7
        rest = bytes([0x80 | value & 0x7F]) + rest
    return rest


def chunk(name, content):
    return name + len(content).to_bytes(4, "big") + content


def song(path, *tracks, division=480, kind=1):
    """Writes a file; a track is a list of (tick, message)."""
    head = b"".join(value.to_bytes(2, "big") for value in (kind, len(tracks), division))
    chunks = [chunk(b"MThd", head)]
    for track in tracks:
        content, now = b"", 0
        for tick, message in sorted(track, key=lambda row: row[0]):
            content += number(tick - now) + message
            now = tick
        chunks.append(chunk(b"MTrk", content + b"\x00\xff\x2f\x00"))
    path.write_bytes(b"".join(chunks))
    return path


def note(tick, key, velocity, channel=9):
    return tick, bytes([0x90 + channel, key, velocity])


def key_pressure(tick, key, value):
    return tick, bytes([0xA0, key, value])


def control(tick, controller, value):
    return tick, bytes([0xB0, controller, value])


def program(tick, preset):
    return tick, bytes([0xC0, preset])


def pressure(tick, value):
    return tick, bytes([0xD0, value])


def tempo(tick, microseconds):
    return tick, b"\xff\x51\x03" + microseconds.to_bytes(3, "big")


NOTES = [note(60 * i, key, velocity) for i, (key, velocity) in enumerate(
    [(36, 100), (37, 90), (38, 1), (39, 80), (40, 127), (41, 19), (43, 20), (45, 21), (47, 64), (48, 99), (50, 3)])]
KIT_SONGS = {
    "a groove": [[note(0, 36, 100), note(0, 42, 80), note(240, 38, 90), note(300, 37, 100), note(360, 40, 110),
                  note(480, 45, 100), note(500, 41, 90), note(520, 50, 64)]],
    "controllers go to all": [[note(0, 38, 80), control(50, 16, 90), control(60, 17, 20), note(100, 38, 80),
                               note(110, 45, 80), control(150, 7, 60), note(160, 36, 80), control(300, 120, 0),
                               note(320, 41, 90)]],
    "hands": [[note(0, 38, 90), note(0, 45, 90), key_pressure(60, 45, 100), note(100, 38, 80),
               pressure(120, 60), note(150, 36, 80), pressure(200, 0),
               key_pressure(220, 45, 0), note(230, 45, 90)]],
    "a prefix is for one note": [[control(0, 88, 64), note(0, 36, 80), note(60, 38, 80), control(100, 88, 99),
                                  note(100, 60, 80), note(120, 38, 80), program(130, 3),
                                  note(140, 38, 80)]]}
SONGS = {
    "every note": [NOTES + [note(700, 60, 99), note(710, 38, 0)]],
    "note-offs do nothing": [[note(0, 38, 80), (50, b"\x80\x26\x40")]],
    "tempos in another track": [[tempo(0, 400000), tempo(200, 123456),
                                 tempo(300, 900001)], NOTES],
    "place of strokes": [[note(0, 38, 80), control(100, 16, 127), note(100, 38, 80), control(200, 17, 33),
                          note(200, 38, 80), note(240, 37, 80), note(260, 36, 80)]],
    "controllers act first": [[note(0, 38, 80)], [control(0, 16, 90), control(0, 1, 100)]],
    "grip, strainer": [[note(0, 38, 80), control(60, 20, 0), note(100, 38, 80), control(130, 20, 100),
                        control(140, 1, 9), note(200, 38, 80)]],
    "gain": [[control(0, 7, 100), note(0, 38, 80), control(100, 11, 50), note(200, 38, 80), control(250, 7, 127)]],
    "fine velocities": [[control(0, 88, 64), note(0, 38, 80), note(200, 38, 80), control(300, 88, 127),
                         note(300, 38, 80, 0)]],
    "hands": [[note(0, 38, 80), pressure(100, 90), note(150, 38, 80),
               pressure(200, 0), key_pressure(220, 38, 1), note(300, 38, 80),
               key_pressure(330, 38, 0), key_pressure(340, 60, 127)]],
    "silences": [[note(0, 38, 120), control(200, 123, 0), control(201, 120, 0), note(202, 38, 80),
                  control(300, 120, 0)]],
    "presets": [[note(0, 38, 80), program(100, 2), note(100, 38, 80),
                 program(200, 99), program(220, 0),
                 program(220, 2), note(240, 40, 80), program(300, 1)]],
    "reset all controllers": [[control(0, 11, 40), control(0, 1, 100), pressure(0, 80), note(0, 38, 80),
                               control(200, 121, 0), note(240, 38, 80)]],
    "other messages": [[note(0, 38, 80), (10, b"\xe0\x63\x40"), (20, b"\xf0\x03\x01\x02\xf7"),
                        control(30, 64, 127)]]}


@pytest.mark.parametrize("name", SONGS)
def test_a_file_sounds_as_the_program_plays_it(name, program_sound, tmp_path):
    path = song(tmp_path / "song.mid", *SONGS[name])
    sound = tabor.render("tabor", path, quality="draft")
    np.testing.assert_array_equal(sound, program_sound("tabor", "--quality", "draft", "--midi-file", str(path)))
    assert np.abs(sound).max() > 0.001


def test_what_comes_after_the_end_is_left_out(program_sound, tmp_path):
    path = song(tmp_path / "song.mid", NOTES)
    theirs = program_sound("tabor", "--quality", "draft", "--midi-file", str(path), "--duration", "0.3")
    np.testing.assert_array_equal(tabor.render("tabor", path, 0.3, quality="draft"), theirs)


def test_a_snare_drum_at_another_rate(program_sound, tmp_path):
    path = song(tmp_path / "song.mid", NOTES, *SONGS["hands"], *SONGS["gain"])
    drum = tabor.Definition("snare-14x5.5", {"strike.radius": 0.05, "wires.strainer": 0.5})
    np.testing.assert_array_equal(
        tabor.render(drum, path, sample_rate=44100),
        program_sound("snare-14x5.5", "--rate", "44100", "--midi-file", str(path), "--set", "strike.radius=0.05",
                      "--set", "wires.strainer=0.5"))


def test_a_room_fades_with_its_drum(program_sound, tmp_path):
    path = song(tmp_path / "song.mid", *SONGS["silences"])
    hall = tabor.Definition("frame-drum", {"room.kind": "hall"})
    sound = tabor.render(hall, str(path), 1.0, quality="draft", mics=["left", "right"])
    np.testing.assert_array_equal(sound, program_sound(
        "frame-drum", "--set", "room.kind=hall", "--quality", "draft", "--midi-file", str(path), "--duration", "1",
        "--mic", "left", "--mic", "right", channels=2))


@pytest.mark.parametrize("division", [96, 0xE728, 0xE250, 0xE3FF])
def test_ticks_are_parts_of_a_quarter_or_of_a_frame_of_film(division, program_sound, tmp_path):
    path = song(tmp_path / "song.mid", NOTES, division=division, kind=0)
    model = tabor.Model("tabor", quality="draft")
    frames = [round(event.time * 48000) for event in tabor.midi_events(path, model)]
    assert frames == sorted(frames) and len(frames) == 11
    np.testing.assert_array_equal(
        tabor.render(model, path), program_sound("tabor", "--quality", "draft", "--midi-file", str(path)))


def test_files_are_takes_of_a_kit_and_can_be_added_to(tmp_path, snare):
    path = song(tmp_path / "song.mid", *SONGS["every note"])
    kit = tabor.render_takes([snare], [path, [tabor.strike()]])
    np.testing.assert_array_equal(kit[0, 0], tabor.render(snare, path))
    events = tabor.midi_events(path, snare)
    assert len(events) == 11 and events[0].kind == "strike"
    assert tabor.render(snare, events + [tabor.strike(1.5)]).shape[1] > 48000
    with pytest.raises(TypeError, match="takes is a sequence"):
        tabor.render_takes([snare], "song.mid")


def test_wrong_files_are_refused(tmp_path, snare):
    whole = song(tmp_path / "song.mid", NOTES).read_bytes()
    wrong = tmp_path / "wrong.mid"
    for said, content in (("byte 0: not a Standard", b""), ("byte 0: not a Standard", b"RIFF" + whole[4:]),
                          ("byte 14: the file ends 9 bytes before", whole[:-9]),
                          ("byte 8: format 2; allowed: 0 and 1", whole[:9] + b"\2" + whole[10:]),
                          ("byte 12: 0 ticks for a quarter", whole[:12] + b"\0\0" + whole[14:]),
                          ("byte 12: 1 ticks in each of 127 frames", whole[:12] + b"\x81\1" + whole[14:])):
        wrong.write_bytes(content)
        with pytest.raises(tabor.Error, match=said):
            tabor.render(snare, wrong)
    song(wrong, [note(0, 60, 99)])
    with pytest.raises(tabor.Error, match="no note in it is a stroke: 1 are not in the map"):
        tabor.render(snare, wrong)
    song(wrong, [note(0, 38, 99), note(480 * 7300, 38, 9)])
    with pytest.raises(tabor.Error, match="its last event comes at 3650 s; allowed: up to 3600"):
        tabor.render(snare, wrong)
    with pytest.raises(FileNotFoundError):
        tabor.render(snare, tmp_path / "none.mid")
    wrong.write_bytes(bytes(16 * 1024 * 1024 + 1))
    with pytest.raises(tabor.Error, match="larger than 16777216 bytes"):
        tabor.render(snare, wrong)


def test_what_touches_no_note_is_a_warning(tmp_path, snare, standard):
    path = song(tmp_path / "song.mid", [note(0, 38, 90), (1, b"\xff\x51\x03\0\0\0"), control(2, 7, 200)])
    with pytest.warns(tabor.MidiWarning) as said:
        events = tabor.midi_events(path, snare)
    assert len(events) == 1 and len(said) == 2 and said[0].filename == __file__
    assert "song.mid: byte 27, track 1: a tempo of 0" in str(said[0].message)
    for refused in (lambda: tabor.midi_events(path, snare, strict=True), lambda: standard.midi_events(path, strict=True)):
        with pytest.raises(tabor.Error, match="a tempo of 0 .* strict=True"):
            refused()
    path = song(tmp_path / "song.mid", [note(0, 38, 90)] + 10 * [control(2, 7, 200)])
    with pytest.warns(tabor.MidiWarning) as said:
        assert len(standard.midi_events(path)) == 1
    assert len(said) == 9 and str(said[8].message).endswith("song.mid: 2 more warnings")


@pytest.fixture(scope="module")
def standard():
    return tabor.Kit("standard", quality="draft")


@pytest.mark.parametrize("name", KIT_SONGS)
def test_a_kit_is_that_of_the_program(name, standard, program_sound, tmp_path):
    path = song(tmp_path / "song.mid", *KIT_SONGS[name])
    theirs = program_sound("--kit", "standard", "--midi-file", str(path), "--quality", "draft", "--duration", "0.7",
                           channels=2)
    assert np.array_equal(standard.render(path, 0.7), theirs)


def test_events_of_a_kit(standard, tmp_path):
    path = song(tmp_path / "song.mid", *KIT_SONGS["a groove"])
    events = standard.midi_events(str(path))
    assert [drum for drum, _ in events][:3] == ["kick", "hihat", "hihat"]  # pedal and stroke
    assert standard.render(path, 0.001).shape == (2, 48)  # what comes later is left out
    with pytest.raises(tabor.Error, match="no note in it plays a drum"):
        standard.midi_events(song(tmp_path / "none.mid", [note(0, 100, 80)]))


MAP_NOTES = [note(60 * i, key, 100 - i) for i, key in enumerate((36, 38, 40, 37, 48, 50, 45, 47, 43, 58, 46, 35))]
MAP_PLACES = [control(0, 16, 100), note(0, 38, 80), control(100, 18, 120), note(100, 48, 80), control(200, 17, 60),
              note(200, 38, 80), note(220, 41, 70), note(240, 43, 90)]


@pytest.mark.parametrize("name", ["roland", "yamaha", "alesis", "superior", "addictive"])
@pytest.mark.parametrize("notes", [MAP_NOTES, MAP_PLACES], ids=["notes", "places"])
def test_maps_by_name_are_those_of_the_program(name, notes, standard, program_sound, tmp_path):
    path = song(tmp_path / "song.mid", notes)
    theirs = program_sound("--kit", "standard", "--midi-file", str(path), "--quality", "draft", "--duration", "0.7",
                           "--map", name, channels=2)
    assert np.array_equal(standard.render(path, 0.7, notes_of=name), theirs)


def test_controllers_of_places(standard, program_sound, tmp_path):
    path = song(tmp_path / "song.mid", MAP_PLACES)
    theirs = program_sound("--kit", "standard", "--midi-file", str(path), "--quality", "draft", "--duration", "0.4",
                           "--map", "roland", "--place-cc", "17,16", channels=2)
    events = standard.midi_events(path, notes_of="roland", place_cc=(17, 16))
    standard.reset()
    assert np.array_equal(standard.process(19200, [row for row in events if row[1].time < 0.4]), theirs)
    with pytest.raises(tabor.UnknownNameError, match="no map is called 'Roland'; there are roland, yamaha"):
        standard.midi_events(path, notes_of="Roland")
    with pytest.raises(ValueError, match="place_cc"):
        standard.midi_events(path, notes_of="roland", place_cc=(120, 18))


def test_a_kit_rings_out(program_sound, tmp_path):
    path = song(tmp_path / "song.mid", *KIT_SONGS["a groove"])
    theirs = program_sound("--kit", "jazz", "--midi-file", str(path), "--quality", "draft", channels=2)
    ours = tabor.Kit("jazz", quality="draft").render(path)
    assert theirs.shape[1] > 24000  # half a second after the last event, at least
    assert np.array_equal(ours, theirs)


def test_notes_that_play_nothing_are_said(tmp_path):
    path = song(tmp_path / "song.mid", [note(0, 38, 90), note(0, 54, 90), note(10, 54, 90), note(10, 27, 90)])
    with pytest.warns(tabor.MidiWarning, match=r"song\.mid: notes that play no drum of the kit: 27 \(1\), 54 tambourine \(2\)$"):
        assert len(tabor.Kit("standard", quality="draft").midi_events(path)) == 1


def test_a_kit_from_a_file(program, program_sound, tmp_path):
    path, file = song(tmp_path / "song.mid", *KIT_SONGS["a groove"]), tmp_path / "mine.ini"
    file.write_bytes(program("show", "--kit", "jazz", "--set", "kit.coupling=3", "--set", "drum.snare.batter.pitch=G3"))
    theirs = program_sound("--kit", str(file), "--midi-file", str(path), "--quality", "draft", "--duration", "0.4",
                           channels=2)
    assert np.array_equal(tabor.Kit(file, quality="draft").render(path, 0.4), theirs)
    with pytest.raises(FileNotFoundError):
        tabor.Kit("none.ini")
    file.write_text("[kit]\nname = x\nwhat\n", encoding="utf-8")
    with pytest.raises(tabor.Error, match=r"mine\.ini:3: .* is neither"):
        tabor.Kit(str(file))
