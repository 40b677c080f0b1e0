# SPDX-License-Identifier: MIT
"""Measures one drum stroke: the features by which `compare-recordings` sets renders beside recorded drums.

Every feature is a number with the name that it has in tests/reference/recorded_drums.json. A sound is
resampled to 44.1 kHz, begins 0.5 ms before its first sample above 3 % of its peak, and is high-passed at
25 Hz. `e50` is what sounds from 0 to 50 ms, `m200` from 50 to 200 ms. Levels are in dB, times in ms,
frequencies in Hz."""
from math import gcd

from python_packages import Module

np = Module("numpy")
signal = Module("scipy.signal")

RATE = 44100
WINDOWS = {"e50": (0.0, 0.05, 0.0), "m200": (0.05, 0.2, 0.1)}  # start and end [s], part that fades in
FADE_OUT = 0.2  # the part of a window that fades out
WHOLE = (40.0, 16000.0)  # [Hz]: levels are relative to the energy between these
THIRD_OCTAVES = [1000.0 * 2.0 ** (i / 3.0) for i in range(-12, 13)]  # centres, 62.5 Hz to 16 kHz
OCTAVES = (125, 250, 500, 1000, 2000, 4000, 8000)
BANDS = {"low": (100, 300), "mid": (300, 1000), "him": (1000, 3000), "pres": (3000, 8000), "air": (8000, 16000)}
TREBLE = (2000.0, 12000.0)
TREBLE_TEXTURE = (2000.0, 10000.0)
BODY = (100.0, 600.0)
FRAME = 0.005  # [s]: levels of decays are means over frames
LATE = (0.15, 0.7)  # [s]: what is heard between these is late
LATE_OCTAVES = (500, 1000, 2000, 4000)
LINES = ((3500, 8000), (8000, 15000))  # [Hz]
EARLY_LINES, LATE_LINES = (0.012, 0.1), (0.1, 0.3)  # [s]
COMPONENTS = 4800.0  # [Hz]
NOISE_FRAMES, ABOVE_NOISE, FEWEST_FRAMES = 40, 12.0, 25  # the last frames are noise; [dB]
SHORTEST = 0.6  # [s]: a shorter sound is followed by silence
SPECTRUM_SIZE = 1 << 16


def decibel(power):
    return 10.0 * np.log10(np.maximum(power, 1e-30))


def prepared(sound, rate):
    """The sound as every feature wants it; see the top of this file."""
    sound = np.asarray(sound, dtype=float)
    if rate != RATE:
        common = gcd(int(rate), RATE)
        sound = signal.resample_poly(sound, RATE // common, int(rate) // common)
    size = np.abs(sound)
    if size.max() == 0.0:
        raise ValueError("the sound is silent")
    onset = int(np.argmax(size > 0.03 * size.max()))
    sound = sound[max(0, onset - round(0.0005 * RATE)):]
    sound = np.pad(sound, (0, max(0, int(SHORTEST * RATE) - sound.size)))
    return signal.sosfilt(signal.butter(2, 25.0, "high", fs=RATE, output="sos"), sound)


def band_passed(sound, low, high, order=4, both_ways=False):
    sections = signal.butter(order, (low, min(high, 0.499 * RATE)), "band", fs=RATE, output="sos")
    return signal.sosfiltfilt(sections, sound) if both_ways else signal.sosfilt(sections, sound)


def octave_band(sound, centre):
    return band_passed(sound, centre / np.sqrt(2.0), centre * np.sqrt(2.0))


# ---- spectrum ------------------------------------------------------------------------------------


def windowed(sound, start, end, fade_in):
    piece = sound[int(start * RATE):int(end * RATE)].copy()

    def rise(part):
        count = int(part * piece.size)
        return 0.5 - 0.5 * np.cos(np.pi * (np.arange(count) + 0.5) / max(count, 1))

    fading = rise(fade_in)
    piece[:fading.size] *= fading
    fading = rise(FADE_OUT)
    piece[piece.size - fading.size:] *= fading[::-1]
    return piece


def power_spectrum(piece):
    return np.fft.rfftfreq(SPECTRUM_SIZE, 1.0 / RATE), np.abs(np.fft.rfft(piece, SPECTRUM_SIZE)) ** 2


def energy(frequency, power, low, high):
    return power[(frequency >= low) & (frequency < high)].sum()


def spectral(sound):
    found = {}
    edge = 2.0 ** (1.0 / 6.0)
    for window, limits in WINDOWS.items():
        frequency, power = power_spectrum(windowed(sound, *limits))
        whole = energy(frequency, power, *WHOLE)
        found |= {f"to_{window}_{round(f)}": decibel(energy(frequency, power, f / edge, f * edge) / whole)
                  for f in THIRD_OCTAVES}
        found |= {f"b_{name}_{window}": decibel(energy(frequency, power, *edges) / whole)
                  for name, edges in BANDS.items()}
        found[f"hfbody_{window}"] = decibel(energy(frequency, power, *TREBLE) / energy(frequency, power, *BODY))
        heard = (frequency >= WHOLE[0]) & (frequency < WHOLE[1])
        amplitude = np.sqrt(power[heard])
        found[f"centmag_{window}"] = (frequency[heard] * amplitude).sum() / amplitude.sum()
    return found


# ---- decay ---------------------------------------------------------------------------------------


def frame_levels(sound):
    """Levels [dB] of frames of 5 ms, one after the other."""
    edges = np.round(np.arange(0.0, sound.size / RATE, FRAME) * RATE).astype(int)
    sums = np.concatenate(([0.0], np.cumsum(sound ** 2)))
    return decibel(np.diff(sums[edges]) / np.diff(edges))


def fall_time(levels, depth):
    """Time [ms] from the highest frame until all later ones lie `depth` dB below; NaN if that is never."""
    highest = int(levels.argmax())
    last = highest + int(np.flatnonzero(levels[highest:] > levels[highest] - depth)[-1])
    return 1e3 * FRAME * (last + 1 - highest) if last + 1 < levels.size else np.nan


def backward_decay_time(sound):
    """60 dB decay time [ms] from the backward integral between -1 and -15 dB; the last tenth is its noise."""
    power = sound ** 2
    noise = power[int(0.9 * power.size):].mean()
    left = np.cumsum((power - noise)[::-1])[::-1]
    level = decibel(left / left[0])
    first, last = int(np.argmax(level < -1.0)), int(np.argmax(level < -15.0))
    if last <= first + 1:
        return np.nan
    return -60e3 / np.polyfit(np.arange(first, last) / RATE, level[first:last], 1)[0]


def decays(sound):
    levels = frame_levels(sound)
    found = {"t20_ms": fall_time(levels, 20.0), "t40_ms": fall_time(levels, 40.0)}
    for octave in OCTAVES:
        band = octave_band(sound, octave)
        levels = frame_levels(band)
        found[f"d20_{octave}"] = fall_time(levels, 20.0)
        found[f"d40_{octave}"] = fall_time(levels, 40.0)
        if octave <= 4000:
            found[f"te_{octave}"] = backward_decay_time(band)
    return found


def late_decay_time(band):
    """60 dB time [ms] of a line through the levels from LATE on, until they are near the noise; NaN if that is soon."""
    levels = frame_levels(band)
    first, last = (round(limit / FRAME) for limit in LATE)
    noisy = np.flatnonzero(levels[first:] < np.median(levels[-NOISE_FRAMES:]) + ABOVE_NOISE)
    count = min(last - first, noisy[0] if noisy.size else levels.size - first)
    if count < FEWEST_FRAMES:
        return np.nan
    slope = np.polyfit(FRAME * np.arange(count), levels[first:first + count], 1)[0]
    return -60e3 / slope if slope < 0.0 else np.nan


def late_decays(sound, rate):
    """How what is heard after 0.15 s dies away: late_decay_time() by octave."""
    sound = prepared(sound, rate)
    return {octave: float(late_decay_time(octave_band(sound, octave))) for octave in LATE_OCTAVES}


# ---- attack, texture, partials -------------------------------------------------------------------


def rise_time(sound):
    """From 10 to 90 % of the largest level [ms]; levels are means over 0.5 ms."""
    count = int(0.0005 * RATE)
    level = np.sqrt(np.convolve(sound ** 2, np.ones(count) / count))
    return 1e3 * (np.argmax(level > 0.9 * level.max()) - np.argmax(level > 0.1 * level.max())) / RATE


def attack(sound):
    treble = band_passed(sound, *TREBLE)
    delivered = np.cumsum(treble[:int(0.3 * RATE)] ** 2)
    found = {f"hf_t{part}_ms": 1e3 * np.searchsorted(delivered, 0.01 * part * delivered[-1]) / RATE
             for part in (10, 50, 90)}
    peak = np.abs(sound).max()
    found["hf_click_vs_body"] = 2.0 * decibel(np.abs(treble[:int(0.003 * RATE)]).max() / peak)
    found["crest300"] = decibel(peak ** 2 / (sound[:int(0.3 * RATE)] ** 2).mean())
    found["rise_ms"] = rise_time(sound)
    return found


def treble_modulation(sound):
    """Scatter [dB] of 2 ms frames from 10 to 150 ms around a parabola through their levels."""
    band = band_passed(sound, *TREBLE_TEXTURE)[int(0.01 * RATE):int(0.15 * RATE)]
    size = int(0.002 * RATE)
    count = band.size // size
    levels = decibel((band[:count * size] ** 2).reshape(count, size).mean(axis=1))
    time = np.arange(count)
    return (levels - np.polyval(np.polyfit(time, levels, 2), time)).std()


def treble_flatness(sound):
    """Geometric over arithmetic mean of the spectrum from 20 to 200 ms, averaged over pieces of 23 ms [dB]."""
    frequency, power = signal.welch(sound[int(0.02 * RATE):int(0.2 * RATE)], RATE, nperseg=1024)
    power = np.maximum(power[(frequency >= TREBLE_TEXTURE[0]) & (frequency <= TREBLE_TEXTURE[1])], 1e-30)
    return decibel(np.exp(np.log(power).mean()) / power.mean())


# ---- lines ---------------------------------------------------------------------------------------


def hann_spectrum(sound, start, end, padded=True):
    """Frequencies, and the power spectrum of a piece of the sound [s] under a Hann window, padded to a power of two."""
    piece = sound[int(start * RATE):int(end * RATE)]
    size = 1 << (piece.size - 1).bit_length() if padded else piece.size
    window = signal.windows.hann(piece.size)
    return np.fft.rfftfreq(size, 1.0 / RATE), np.abs(np.fft.rfft(piece * window, size)) ** 2


def line_excess(frequency, power, low, high, flat):
    """97th percentile over median of the spectrum in a band [dB]; flat: of what lies over the median of the third octave
    around it, so that a band that falls off does not count as lines. Noise has 7, a comb of tones 15 to 40."""
    inside = (frequency >= low) & (frequency < high)
    level = power[inside]
    if flat:
        edge = 2.0 ** (1.0 / 6.0)
        first, last = np.searchsorted(frequency, (frequency[inside] / edge, frequency[inside] * edge))
        level = level / [np.median(power[a:b]) for a, b in zip(first, last)]
    return decibel(np.percentile(level, 97) / np.median(level))


def component_count(sound):
    """How many lines of equal power make up the critical band around COMPONENTS (Glasberg, Moore 1990): (sum P)^2/sum P^2
    of its spectrum. Noise has half the number of the window's own lines in it, here 54."""
    frequency, power = hann_spectrum(sound, *LATE_LINES, padded=False)
    width = 24.7 * (4.37e-3 * COMPONENTS + 1.0)
    power = power[np.abs(frequency - COMPONENTS) < 0.5 * width]
    return power.sum() ** 2 / (power ** 2).sum()


def lines(sound, rate):
    """Lines in the treble, by name: line95_F plain and flat95_F of the bands of LINES, and the components at 4.8 kHz."""
    sound = prepared(sound, rate)
    frequency, power = hann_spectrum(sound, *EARLY_LINES)
    found = {f"{name}_{low}": line_excess(frequency, power, low, high, name == "flat95")
             for name in ("line95", "flat95") for low, high in LINES}
    return {name: float(value) for name, value in (found | {"components_4800": component_count(sound)}).items()}


def partial_decay_time(sound, frequency):
    """60 dB time [ms] of the partial at this frequency, from its envelope between 50 and 400 ms."""
    envelope = np.abs(signal.hilbert(band_passed(sound, max(20.0, frequency - 20.0), frequency + 20.0, 2, True)))
    part = slice(int(0.05 * RATE), int(0.4 * RATE))
    slope = np.polyfit(np.arange(part.start, part.stop) / RATE, 2.0 * decibel(envelope[part]), 1)[0]
    return -60e3 / slope if slope < 0.0 else np.nan


def partials(sound):
    """`tonal4`: the share of the four strongest partials in 60 to 1500 Hz; `f1`, `f1_t60`: the strongest one."""
    piece = sound[int(0.02 * RATE):int(0.27 * RATE)]
    size = 2 * SPECTRUM_SIZE
    frequency = np.fft.rfftfreq(size, 1.0 / RATE)
    part = (frequency >= 60.0) & (frequency <= 1500.0)
    frequency, power = frequency[part], np.abs(np.fft.rfft(piece, size))[part] ** 2
    peaks = signal.find_peaks(power, distance=int(30.0 / (frequency[1] - frequency[0])))[0]
    strongest = peaks[np.argsort(-power[peaks])][:4]
    near = np.any(np.abs(frequency[:, None] - frequency[strongest][None, :]) <= 10.0, axis=1)
    first = float(frequency[strongest[0]])
    return {"tonal4": decibel(power[near].sum() / power.sum()), "f1": first,
            "f1_t60": partial_decay_time(sound, first)}


def features(sound, rate):
    """Every feature by name; NaN where the sound does not have it (a level that never falls by 40 dB)."""
    sound = prepared(sound, rate)
    found = spectral(sound) | decays(sound) | attack(sound) | partials(sound)
    found |= {"hf_mod_db": treble_modulation(sound), "hf_flat": treble_flatness(sound)}
    return {name: float(value) for name, value in found.items()}
