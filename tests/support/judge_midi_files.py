# SPDX-License-Identifier: MIT
"""Compares the program and the Python package on MIDI files: judge_midi_files.py FOLDER VERDICTS.JSON.

Both say the same of each file, and what is played has the same bits, on a drum and on a kit. VERDICTS.JSON gets what Python
says and the events, for the web page's reader. The environment variable TABOR names the program. For test_midi_files.sh.
"""

import json
import os
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np

import tabor

DRUM, KIT = "tom-12", "frame-drums"
QUALITY, DURATION, RATE = "draft", 0.2, 48000
FRAMES = round(DURATION * RATE)


class Player:
    """A drum or a kit of the package, and the arguments that name it for the program."""

    def __init__(self, *arguments):
        self.arguments = arguments

    def rendered(self, path):
        """What the program says of a file, and its sound or None."""
        command = [os.environ["TABOR"], "render", *self.arguments, "--midi-file", str(path), "--quality", QUALITY,
                   "--duration", str(DURATION), "--format", "float", "-q", "-o", "-"]
        ended = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        said = [line.replace("tabor: ", "", 1) for line in ended.stderr.decode().splitlines()]
        if ended.returncode == 2:
            return said, None
        start = int.from_bytes(ended.stdout[4:8], "big")
        return said, np.frombuffer(ended.stdout[start:], ">f4").reshape(-1, self.channels).T


class DrumPlayer(Player):
    channels = 1

    def __init__(self):
        super().__init__(DRUM)
        self.model = tabor.Model(DRUM, quality=QUALITY)

    def events(self, path):
        return [(0, event) for event in tabor.midi_events(path, self.model)]

    def sound(self, path):
        heard = [event for _, event in self.events(path) if round(event.time * RATE) < FRAMES]
        return tabor.render(self.model, heard, DURATION)


class KitPlayer(Player):
    channels = 2

    def __init__(self):
        super().__init__("--kit", KIT)
        self.kit = tabor.Kit(KIT, quality=QUALITY)

    def events(self, path):
        return [(self.kit.drums.index(drum), event) for drum, event in self.kit.midi_events(path)]

    def sound(self, path):
        return self.kit.render(path, DURATION)


def judged(player, path):
    """What Python says of a file, and its events or None."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            events, refused = player.events(path), []
        except tabor.Error as error:
            events, refused = None, [str(error)]
    return [f"warning: {one.message}" for one in caught] + refused, events


def row(drum, event):
    return {"frame": round(event.time * RATE), "drum": drum, "kind": event.kind, **event.fields}


def verdict(player, path):
    """What both say of a file, without its name, and the events; complains where they differ."""
    (theirs, heard), (ours, events) = player.rendered(path), judged(player, path)
    if theirs != ours:
        sys.exit(f"{path.name}: the program says {theirs}, Python says {ours}")
    if (heard is None) != (events is None):
        sys.exit(f"{path.name}: refused by one of both")
    if events is not None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            if not heard.any() or not np.array_equal(player.sound(path), heard):
                sys.exit(f"{path.name}: {player.arguments} sounds otherwise in Python")
    said = [line.replace(f"{path}: ", "") for line in ours]
    return {"said": said, "events": None if events is None else [row(*pair) for pair in events]}


def main():
    """Judges the files."""
    folder, verdicts = map(Path, sys.argv[1:])
    players = {"drum": DrumPlayer(), "kit": KitPlayer()}
    paths = sorted(folder.glob("*.mid"))
    judgements = {path.name: {name: verdict(player, path) for name, player in players.items()} for path in paths}
    verdicts.write_text(json.dumps({"drum": DRUM, "kit": KIT, "rate": RATE, "files": judgements}), encoding="utf-8")
    drums = [judgement["drum"] for judgement in judgements.values()]
    print(f"{len(paths)} files: {sum(one['events'] is None for one in drums)} refused, "
          f"{sum(bool(one['said']) and one['events'] is not None for one in drums)} played with warnings")


if __name__ == "__main__":
    main()
