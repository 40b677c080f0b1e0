# SPDX-License-Identifier: MIT
"""What tools/compare-cymbals measures of a stroke on a cymbal, and how it stands to recorded ones.

Sound is mono at 48 kHz, high-passed at 100 Hz, from 0.5 ms before it first exceeds 2 % of its peak. Levels are in dB, times in ms,
frequencies in Hz. Windows are those of WINDOWS; one that the sound does not fill to six tenths gives nothing.

    to_W_F            power of the third octave around F in window W, over all from 200 Hz to 18 kHz
    cent_W, share_W   centroid of that power; its part from 6 to 16 kHz
    lev_W             mean power of window W over that of the loudest
    bloom             the largest share from b to e, less that of a
    t60_F, tmax_F     of the octave around F: 60 dB decay by the fall from 5 to 30 dB below its loudest 10 ms; when that is
    line_4, line_9    97th percentile over median of the spectrum from 3.5 to 8 and from 8 to 15 kHz, 100 to 300 ms; noise: 7 to 8
    tonal4            part of the four strongest partials, +-10 Hz each, of 200 Hz to 6 kHz, 300 to 1300 ms
    click             peak of the first 3 ms over the mean from 10 to 100 ms
    dur20, dur40      when the sound has fallen by so much for good
"""
import math

from python_packages import Module

np = Module("numpy")
soundfile = Module("soundfile")
signal = Module("scipy.signal")

RATE = 48000
WINDOWS = {"a": (0.0, 0.01), "b": (0.01, 0.03), "c": (0.03, 0.1), "d": (0.1, 0.3), "e": (0.3, 1.0), "f": (1.0, 2.0)}
THIRDS = [200.0 * 2.0**(i / 3.0) for i in range(20)]
OCTAVES = (500, 1000, 2000, 4000, 8000, 14000)
FRAME = RATE // 100


def decibels(ratio):
    return float(10.0 * np.log10(ratio))


def load(path):
    """The stroke in a file, as it is measured."""
    sound, rate = soundfile.read(path, always_2d=True)
    sound = sound[:, :2].mean(axis=1)
    if rate != RATE:
        common = math.gcd(rate, RATE)
        sound = signal.resample_poly(sound, RATE // common, rate // common)
    sound = signal.sosfilt(signal.butter(2, 100.0, "high", fs=RATE, output="sos"), sound)
    onset = np.flatnonzero(np.abs(sound) > 0.02 * np.abs(sound).max())[0]
    return sound[max(0, onset - FRAME // 20):]


def spectrum(piece, size):
    power = np.abs(np.fft.rfft(piece * np.hanning(len(piece)), size))**2
    return power, np.fft.rfftfreq(size, 1.0 / RATE)


def frames(sound):
    """Power of each 10 ms [dB]."""
    whole = sound[:len(sound) // FRAME * FRAME].reshape(-1, FRAME)
    return 10.0 * np.log10((whole**2).mean(axis=1) + 1e-20)


def windows(sound):
    """Window, its piece of the sound."""
    for name, (begin, end) in WINDOWS.items():
        if len(sound) / RATE - begin >= 0.6 * (end - begin):
            yield name, sound[round(begin * RATE):round(end * RATE)]


def spectral(sound):
    found, mean = {}, {}
    for name, piece in windows(sound):
        power, frequency = spectrum(piece, 1 << 16)
        heard = (frequency > 200.0) & (frequency < 18000.0)
        whole = power[heard].sum() + 1e-30
        mean[name] = decibels((piece**2).mean() + 1e-20)
        found[f"cent_{name}"] = float((power[heard] * frequency[heard]).sum() / whole)
        found[f"share_{name}"] = decibels(power[(frequency > 6000.0) & (frequency < 16000.0)].sum() / whole + 1e-12)
        for third in THIRDS:
            if name == "a" and third < 400.0:
                continue
            inside = (frequency > third / 2.0**(1 / 6)) & (frequency < third * 2.0**(1 / 6))
            found[f"to_{name}_{third:.0f}"] = decibels(power[inside].sum() / whole + 1e-9)
    found |= {f"lev_{name}": level - max(mean.values()) for name, level in mean.items()}
    late = [found[f"share_{name}"] for name in "bcde" if f"share_{name}" in found]
    if late:
        found["bloom"] = max(late) - found["share_a"]
    return found


def decay(octave):
    """When an octave's frames are loudest, and its 60 dB decay if it falls for long enough [ms]."""
    peak = int(octave[:150].argmax())
    noise = float(np.median(octave[-max(5, len(octave) // 12):])) if len(octave) > 60 else -200.0

    def falls_below(start, by):
        while start < len(octave) and octave[start] > max(octave[peak] - by, noise + 6.0):
            start += 1
        return start

    begin = falls_below(peak, 5.0)
    end = falls_below(begin, 30.0)
    slope = np.polyfit(np.arange(begin, end) * 10.0, octave[begin:end], 1)[0] if end - begin > 7 else None
    return 10.0 * peak, None if slope is None else float(-60.0 / slope)


def decays(sound):
    found = {}
    for octave in OCTAVES:
        edges = [octave / 2.0**0.5, min(octave * 2.0**0.5, 19000.0)]
        levels = frames(signal.sosfilt(signal.butter(4, edges, "band", fs=RATE, output="sos"), sound))
        if len(levels) < 12:
            continue
        found[f"tmax_{octave}"], t60 = decay(levels)
        if t60 is not None:
            found[f"t60_{octave}"] = t60
    return found


def lines(sound):
    if len(sound) <= 0.3 * RATE:
        return {}
    power, frequency = spectrum(sound[RATE // 10:3 * RATE // 10], RATE // 5)
    found = {}
    for name, low, high in (("line_4", 3500.0, 8000.0), ("line_9", 8000.0, 15000.0)):
        part = power[(frequency > low) & (frequency < high)]
        part = part / np.convolve(part, np.ones(101) / 101.0, "same")
        found[name] = decibels(np.percentile(part, 97) / np.median(part))
    return found


def tones(sound):
    if len(sound) <= RATE:
        return {}
    piece = sound[3 * RATE // 10:min(13 * RATE // 10, len(sound))]
    power, frequency = spectrum(piece, 1 << 16)
    power = power * ((frequency > 200.0) & (frequency < 6000.0))
    whole, share = power.sum(), 0.0
    for _ in range(4):
        partial = np.abs(frequency - frequency[power.argmax()]) < 10.0
        share += power[partial].sum()
        power = power * ~partial
    return {"tonal4": decibels(share / whole)}


def course(sound):
    found = {"click": 2.0 * decibels(np.abs(sound[:144]).max() / np.sqrt((sound[480:4800]**2).mean() + 1e-20))}
    levels = frames(sound)
    for by in (20, 40):
        over = np.flatnonzero(levels > levels.max() - by)
        if over[-1] < len(levels) - 2:
            found[f"dur{by}"] = float(10 * (over[-1] + 1))
    return found


def features(sound):
    return spectral(sound) | decays(sound) | lines(sound) | tones(sound) | course(sound)


def slack(name, value):
    """By how much a feature may lie outside of the recorded spread: 3 dB; a quarter of times and frequencies."""
    if name.startswith(("tmax_", "dur")):
        return max(0.25 * abs(value), 20.0)
    return 0.25 * abs(value) if name.startswith(("cent_", "t60_")) else 3.0


def judge(found, spread):
    """Names of the features inside and outside of the spread of a class."""
    names = [name for name in spread if name in found and math.isfinite(found[name])]
    inside = [name for name in names
              if spread[name][1] - slack(name, found[name]) <= found[name] <= spread[name][3] + slack(name, found[name])]
    return inside, [name for name in names if name not in inside]
