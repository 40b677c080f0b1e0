# SPDX-License-Identifier: MIT
"""Plays a plugin in DawDreamer and compares it with the program.

dawdreamer_host.py PLUGIN PROGRAM [INSTANCES]

PLUGIN is what DawDreamer loads: the path of the VST3 bundle, or the URI of an LV2 plugin. Notes are on whole frames: 50
frames a tick. DawDreamer reads an automation at the beginning of each of its blocks.
"""

import subprocess
import sys

import dawdreamer
import mido
import numpy
from pedalboard.io import AudioFile

RATE, SECONDS, TICK = 48000, 1.0, 50
FRAMES = int(RATE * SECONDS)
TURN = 25600  # frame at which a control turns: the beginning of a block of 64 and of 512 frames

plugin, program = sys.argv[1:3]
instances = int(sys.argv[3]) if len(sys.argv) > 3 else 20

NOTES = [(480, mido.Message("note_on", note=38, velocity=100, channel=9)),
         (640, mido.Message("note_on", note=38, velocity=90, channel=9))]
SNARES_OFF = [(TURN // TICK, mido.Message("control_change", control=20, value=0, channel=9))]


def write_song(name, song):
    track, last = mido.MidiTrack(), 0
    for tick, message in sorted(song, key=lambda pair: pair[0]):
        track.append(message.copy(time=tick - last))
        last = tick
    mido.MidiFile(ticks_per_beat=480, tracks=[track]).save(name)


def rendered(song):
    """What the program makes of the song, a row for each channel."""
    write_song("wanted.mid", song)
    subprocess.run([program, "render", "--humanize", "0.5", "--midi-file", "wanted.mid", "--rate", str(RATE), "--duration", str(SECONDS),
                    "--format", "float", "-q", "-o", "wanted.wav", "--stereo"], check=True)
    with AudioFile("wanted.wav") as file:
        return file.read(file.frames)


class Host:
    """An engine with one instance."""

    def __init__(self, block):
        self.engine = dawdreamer.RenderEngine(RATE, block)
        self.plugin = self.engine.make_plugin_processor("tabor", plugin)
        self.plugin.load_midi("notes.mid", clear_previous=True, beats=False, all_events=True)
        self.engine.load_graph([(self.plugin, [])])

    def parameter(self, name):
        names = [parameter["name"] for parameter in self.plugin.get_parameters_description()]
        return names.index(name)

    def automate(self, name, before, after):
        values = numpy.full(FRAMES, before, dtype=numpy.float32)
        values[TURN:] = after
        self.plugin.set_automation(self.parameter(name), values)

    def sound(self):
        self.engine.render(SECONDS)
        return self.engine.get_audio()[:, :FRAMES]


def first_difference(one, other):
    apart = (one != other).any(0)
    return int(apart.argmax()) if apart.any() else None


def same(what, wanted, sound):
    if not wanted.any():
        sys.exit(f"{what}: the program is silent")
    if not numpy.array_equal(wanted, sound):
        sys.exit(f"{what}: {numpy.abs(wanted - sound).max()} apart, first at frame {first_difference(wanted, sound)}")


def check_blocks(wanted):
    for block in (1, 64, 1000, 8192):
        same(f"notes in blocks of {block}", wanted, Host(block).sound())


def check_automation(wanted):
    without_snares = rendered(NOTES + SNARES_OFF)
    for block in (64, 512):
        host = Host(block)
        host.automate("Strainer", 1.0, 0.0)
        same(f"the strainer in blocks of {block}", without_snares, host.sound())
    host = Host(64)
    pitch = host.parameter("Batter head pitch")
    now = host.plugin.get_parameter(pitch)
    host.automate("Batter head pitch", now, now + 0.1)
    turned = first_difference(wanted, host.sound())
    assert turned is not None and TURN <= turned < TURN + 1000, turned


def check_instances():
    engine = dawdreamer.RenderEngine(RATE, 512)
    made = [engine.make_plugin_processor(f"tabor{number}", plugin) for number in range(instances)]
    assert len(made) == instances


write_song("notes.mid", NOTES)
notes = rendered(NOTES)
check_blocks(notes)
check_automation(notes)
check_instances()
