# SPDX-License-Identifier: MIT
"""A sample library in the sampler sfizz: run by test_library_sampler.sh as library_sampler.py FOLDER NAME.

Every velocity of every key must sound as its stroke does, but for one factor of the sampler's that is the
same for all, and the takes must come in turn.
"""

import json
import sys
import wave
from pathlib import Path

import numpy as np
import pysfizz

RATE = 48000
MOST_DELAY = 8  # of the sampler [frames]
LEVEL_TOLERANCE = 1e-3  # of the factor, which float and 24 bits keep to 1e-5
ENDS = 480  # frames at both ends, where the sampler smooths
SHAPE_TOLERANCE = 5e-3  # of what is heard between them against the file; takes differ by 2e-2


def recorded(path):
    """Samples of a 24-bit WAV file of one channel."""
    with wave.open(str(path)) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 3, RATE), path
        data = np.frombuffer(file.readframes(file.getnframes()), np.uint8).reshape(-1, 3)
    padded = np.zeros((len(data), 4), np.uint8)
    padded[:, 1:] = data
    return padded.view("<i4")[:, 0] / 2.0**31


def compare(heard, sound):
    """How much louder it is heard than it is recorded, and how unlike that is, in parts."""
    found = []
    for delay in range(MOST_DELAY):
        part = heard[delay + ENDS:delay + ENDS + len(sound)]
        factor = float(np.dot(part, sound) / np.dot(sound, sound))
        found.append((float(np.linalg.norm(part - factor * sound) / np.linalg.norm(part)), factor))
    unlike, factor = min(found)
    return factor, unlike


def main():
    """Plays every layer in turn, with its lowest velocity but one and its highest."""
    folder, name = Path(sys.argv[1]), sys.argv[2]
    sounds = json.loads(sys.stdin.read())["sounds"]
    synth = pysfizz.Synth(RATE, 256)
    assert synth.load_sfz_file(folder / f"{name}.sfz"), "sfizz does not load it"
    assert synth.playable_keys == sorted({sound["key"] for sound in sounds}), synth.playable_keys
    takes = max(sound["take"] for sound in sounds)
    factors = []
    for first in range(0, len(sounds), takes):
        # sfizz rounds: 18 may fall into a layer that ends at 17, so the lowest but one is played
        for velocity in (sounds[first]["low"] + 1, sounds[first]["high"]):
            for sound in sounds[first:first + takes]:
                samples = recorded(folder / sound["file"])
                seconds = (len(samples) + MOST_DELAY) / RATE
                heard = synth.render_note(sound["key"], velocity, 0.01, seconds)[0]
                factor, unlike = compare(heard, samples[ENDS:-ENDS])
                assert unlike < SHAPE_TOLERANCE, (sound, velocity, unlike)
                factors.append(factor)
    spread = max(factors) / min(factors) - 1
    print(f"{len(sounds)} sounds, {len(factors)} notes: factor {factors[0]:.6f}, spread {spread:.1e}")
    assert spread < LEVEL_TOLERANCE


main()
