# SPDX-License-Identifier: MIT
"""Plays the VST3 plugins in pedalboard and compares them with the program.

pedalboard_host.py BUNDLE PROGRAM

Notes, controllers and pressures are on whole frames: 50 frames a tick. pedalboard puts a controller at the beginning of
its block, so in blocks of 50 frames each is where the program has it. Of Tabor Multi and Tabor Kit it can only list the
parameters: it gives an instrument no buffers for more than one output. So $VST3_HOST plays these.
"""

import os
import subprocess
import sys
import threading
import time

import mido
import numpy
import pedalboard
from pedalboard.io import AudioFile

RATE, SECONDS, TICK = 48000, 0.6, 50 / 48000
LONGEST_WAIT = 300  # [s] for a model, on a machine that does much else
STEREO = ["--stereo"]

bundle, program = sys.argv[1:]


def note(tick, velocity, key=38):
    return tick, mido.Message("note_on", note=key, velocity=velocity, channel=9)


def controller(tick, number, value):
    return tick, mido.Message("control_change", control=number, value=value, channel=9)


NOTES = [note(100, 100), note(160, 33), note(261, 120), note(350, 77, 37)]
PRESSURE = [(300, mido.Message("polytouch", note=38, value=90, channel=9)),
            (400, mido.Message("aftertouch", value=50, channel=9))]
# A host's values are fractions; many, so that one would be found that is rounded the wrong way.
CONTROLLERS = [pair for i in range(16) for pair in (controller(20 + 30 * i, 16, 8 * i + 1), note(20 + 30 * i, 60 + i))]
CONTROLLERS += [controller(510, 20, 31), controller(520, 7, 93), note(520, 110)]


def load(name):
    # At its beginning pedalboard plays a note that no drum has, and waits in vain for its sound.
    return pedalboard.load_plugin(bundle, plugin_name=name, initialization_timeout=0.1)


def rendered(song, options):
    """What the program makes of the song, a row for each channel."""
    track, last = mido.MidiTrack(), 0
    for tick, message in song:
        track.append(message.copy(time=tick - last))
        last = tick
    mido.MidiFile(ticks_per_beat=480, tracks=[track]).save("song.mid")
    subprocess.run([program, "render", "--humanize", "0.5", "--midi-file", "song.mid", "--rate", str(RATE), "--duration", str(SECONDS),
                    "--format", "float", "-q", "-o", "song.wav", *options], check=True)
    with AudioFile("song.wav") as file:
        return file.read(file.frames)


def played(plugin, song, block):
    """What the plugin makes of it, once its model is there."""
    messages = [message.copy(time=tick * TICK) for tick, message in song]
    end = time.monotonic() + LONGEST_WAIT
    while True:
        sound = plugin(messages, duration=SECONDS, sample_rate=RATE, buffer_size=block)
        if sound.any() or time.monotonic() > end:
            return sound


def settled(plugin, song, block, wanted):
    """Waits for the model of a control that was turned, and returns the last sound."""
    end = time.monotonic() + LONGEST_WAIT
    while True:
        sound = played(plugin, song, block)
        if numpy.array_equal(sound, wanted) or time.monotonic() > end:
            return sound
        time.sleep(0.1)


def same(what, wanted, sound):
    if not wanted.any():
        sys.exit(f"{what}: the program is silent")
    if not numpy.array_equal(wanted, sound):
        sys.exit(f"{what}: {numpy.abs(wanted - sound).max()} apart, first at frame {(wanted != sound).any(0).argmax()}")


def check_parameters():
    names = pedalboard.VST3Plugin.get_plugin_names_for_file(bundle)
    assert names == ["Tabor", "Tabor Multi", "Tabor Kit", "Tabor Rattle"], names
    for name, count in (("Tabor", 26), ("Tabor Multi", 19), ("Tabor Kit", 26)):
        plugin = load(name)
        own = [key for key in plugin.parameters if key != "midi_controller"]
        assert plugin.is_instrument and len(own) == count, own
        assert ("room" in own) == (name != "Tabor Multi"), own


def check_sound():
    plugin = load("Tabor")
    for what, song, blocks in (("notes", NOTES, (1, 50, 1000, 8192)), ("pressure", NOTES + PRESSURE, (50,)),
                               ("controllers", CONTROLLERS, (50,))):
        song = sorted(song, key=lambda pair: pair[0])
        wanted = rendered(song, STEREO)
        for block in blocks:
            same(f"{what} in blocks of {block}", wanted, played(plugin, song, block))


def hosted(name, wanted, block, channels):
    """What the instrument makes of one stroke in $VST3_HOST, a row for each channel."""
    sound = subprocess.run([os.environ["VST3_HOST"], bundle, name, "12000", str(wanted.shape[1]), block], check=True,
                           capture_output=True).stdout
    return numpy.frombuffer(sound, "<f4").reshape(-1, channels).T


def check_multi():
    microphones = ["left", "right", "top", "bottom", "near", "far", "inside"]
    wanted = rendered([note(240, 100)], [word for name in microphones for word in ("--mic", name)])
    for block in ("64", "4096"):
        same(f"Tabor Multi in blocks of {block}", wanted, hosted("Tabor Multi", wanted, block, len(microphones)))


def check_kit():
    wanted = rendered([note(240, 100)], ["--kit", "standard"])
    for block in ("64", "4096"):
        same(f"Tabor Kit in blocks of {block}", wanted, hosted("Tabor Kit", wanted, block, 18)[:2])


def check_threads():
    """Two instances at once, each in a thread, where pedalboard does not reset them; a third one by itself."""
    plugins, sounds = [load("Tabor") for _ in range(3)], {}
    for plugin in plugins:
        played(plugin, NOTES, 1000)

    def play(number):
        messages = [message.copy(time=tick * TICK) for tick, message in NOTES]
        sounds[number] = plugins[number](messages, duration=SECONDS, sample_rate=RATE, buffer_size=64, reset=False)

    threads = [threading.Thread(target=play, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    play(2)
    for number in range(2):
        same(f"instance {number} of two", sounds[2], sounds[number])


def check_state():
    plugin, other = load("Tabor"), load("Tabor")
    plugin.room, plugin.gain, plugin.quality = "None", "-6 dB", "Draft"
    options = ["--quality", "draft", "--set", "room.kind=none", "--mic", "left", "--mic", "right", "--gain", "6"]
    wanted = rendered(NOTES, options)
    same("controls", wanted, settled(plugin, NOTES, 1000, wanted))
    other.raw_state = plugin.raw_state
    assert other.room == plugin.room and other.quality == plugin.quality, (other.room, other.quality)
    same("a restored state", wanted, settled(other, NOTES, 1000, wanted))


check_parameters()
check_sound()
check_multi()
check_kit()
check_threads()
check_state()
