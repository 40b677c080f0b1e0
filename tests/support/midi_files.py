# SPDX-License-Identifier: MIT
"""41 small MIDI files, right and wrong ones, of our own making: midi_files.py FOLDER. For test_midi_files.sh."""

import sys
from pathlib import Path

END = b"\xff\x2f\x00"
KICK, SNARE = b"\x99\x24\x64", b"\x99\x26\x50"  # notes 36 and 38
QUARTER = 96  # ticks


def chunk(name, content, length=None):
    return name + (len(content) if length is None else length).to_bytes(4, "big") + content


def header(kind=0, tracks=1, division=QUARTER):
    return chunk(b"MThd", b"".join(value.to_bytes(2, "big") for value in (kind, tracks, division)))


def events(*rows):
    """Each row is a time in ticks, up to 127 or as bytes, and an event."""
    return b"".join((bytes([time]) if isinstance(time, int) else time) + event for time, event in rows)


def track(*rows, end=END):
    return chunk(b"MTrk", events(*rows, *([(0, end)] if end else [])))


def file(*rows, end=END, **head):
    return header(**head) + track(*rows, end=end)


def tempo(microseconds, length=3):
    return bytes([0xFF, 0x51, length]) + microseconds.to_bytes(length, "big")


def riff(content, kind=b"RMID", name=b"data"):
    held = kind + b"LIST" + (4).to_bytes(4, "little") + b"INFO" + name + len(content).to_bytes(4, "little") + content
    return b"RIFF" + len(held).to_bytes(4, "little") + held


BEAT = ((0, KICK), (12, SNARE))
PLAIN = file(*BEAT)
FILES = {
    # formats, divisions, containers, chunks
    "format_0": PLAIN,
    "format_1": header(1, 2) + track((0, tempo(400000)), (24, tempo(200000))) + track(*BEAT, (24, SNARE)),
    "format_1_controllers_act_first": header(1, 2) + track((0, SNARE), (12, KICK)) + track((12, b"\xb9\x10\x7f"), (0, SNARE)),
    "format_2": file(*BEAT, kind=2),
    "film_24": file(*BEAT, division=0xE808),
    "film_29": file(*BEAT, division=0xE350),
    "film_of_26_frames": file(*BEAT, division=0xE608),
    "film_without_ticks": file(*BEAT, division=0xE800),
    "no_ticks": file(*BEAT, division=0),
    "rmid": riff(PLAIN),
    "riff_of_sound": riff(PLAIN, kind=b"WAVE"),
    "rmid_without_data": riff(PLAIN, name=b"none"),
    "another_chunk": header() + chunk(b"XFIH", b"\x01\x02") + track(*BEAT),
    "junk_between_chunks": header() + b"\0\0\1" + track(*BEAT),
    "junk_at_the_end": PLAIN + b"\x1a\x00",
    "long_header": chunk(b"MThd", header()[8:] + b"\0\0") + track(*BEAT),
    "short_header": chunk(b"MThd", header()[8:-2]) + track(*BEAT),
    "nothing": b"",
    "more_tracks_than_announced": header(1, 1) + track(*BEAT) + track((6, SNARE)),
    "no_track": header(),
    "empty_track": header(1, 2) + chunk(b"MTrk", b"") + track(*BEAT),
    # tracks
    "track_breaks_off_in_a_note": file(*BEAT, (6, b"\x99\x26"), end=None),
    "track_breaks_off_in_a_controller": file(*BEAT, (6, b"\xb9\x07"), end=None),
    "file_breaks_off": PLAIN[:-6],
    "events_behind_the_end": header() + chunk(b"MTrk", events(*BEAT, (0, END), (6, SNARE))),
    "no_end_of_track": file(*BEAT, end=None),
    "time_of_5_bytes": file((0, KICK), (b"\x80\x80\x80\x80\x0c", SNARE)),
    "time_of_9_bytes": file((0, KICK), (b"\x80" * 8 + b"\x0c", SNARE)),
    # running status
    "running_status": file((0, KICK), (12, SNARE[1:]), (12, KICK[1:])),
    "running_status_after_meta_and_sysex": file((0, KICK), (0, b"\xff\x01\x01x"), (12, SNARE[1:]),
                                                (0, b"\xf0\x02\x01\xf7"), (12, KICK[1:])),
    "no_status": file((0, SNARE[1:])),
    "real_time_and_song_position": file((0, KICK), (3, b"\xf8"), (3, b"\xf2\x01\x02"), (6, SNARE)),
    # data and meta events
    "data_over_127_in_a_note": file((0, KICK), (12, b"\x99\x26\x80")),
    "data_over_127_in_a_controller": file((0, KICK), (6, b"\xb9\x07\xc8"), (6, SNARE)),
    "tempo_0": file((0, KICK), (6, tempo(0)), (6, SNARE)),
    "tempo_of_4_bytes_and_short_meta": file((0, KICK), (6, tempo(250000, 4)), (0, b"\xff\x58\x02\x04\x02"), (6, SNARE)),
    "slowest_and_fastest_tempo": file((0, KICK), (0, tempo(1)), (96, SNARE), (0, tempo(0xFFFFFF)), (1, KICK)),
    "text_longer_than_its_track": file((0, KICK), (0, b"\xff\x01\x7fx")),
    # what messages do
    "controller_121": file((0, b"\xb9\x0b\x28"), (0, b"\xd9\x50"), (0, KICK), (6, b"\xb9\x79\x00"), (6, SNARE)),
    "double_trigger_and_note_off": file((0, SNARE), (1, b"\x99\x26\x20"), (1, b"\x89\x26\x40"), (6, b"\x99\x26\x00"), (6, KICK)),
    "a_warning_and_no_stroke": file((0, b"\x99\x64\x40"), (6, b"\xb9\x07\xc8")),
}


def main():
    """Writes the files."""
    folder = Path(sys.argv[1])
    for name, content in FILES.items():
        (folder / f"{name}.mid").write_bytes(content)


if __name__ == "__main__":
    main()
