# SPDX-License-Identifier: MIT
"""Levels of a sound in third octaves. Used by compare-qualities and compare-reference."""
from python_packages import Module

np = Module("numpy")

FADE = 0.004  # [s]: a sound cut off clicks, louder than what most drums have left at 16 kHz
POINTS = 1 << 17  # of a spectrum


def faded(sound, rate, begins):
    """A piece of a sound without the clicks of where it was cut: its end, and its start unless it begins there."""
    length = int(FADE * rate)
    rise = 0.5 - 0.5 * np.cos(np.pi * (np.arange(length) + 0.5) / length)
    window = np.ones(sound.size)
    window[-length:] = rise[::-1]
    if not begins:
        window[:length] *= rise
    return sound * window


def third_octaves(sound, rate, centres):
    """Levels [dB] of the energy around these frequencies; the same sound has the same levels at every rate."""
    frequency = np.fft.rfftfreq(POINTS, 1.0 / rate)
    density = np.abs(np.fft.rfft(sound, POINTS) / rate) ** 2
    edge = 2.0 ** (1.0 / 6.0)
    power = [density[(frequency >= f / edge) & (frequency < f * edge)].sum() * rate / POINTS for f in centres]
    return 10.0 * np.log10(np.maximum(np.array(power), 1e-30))
