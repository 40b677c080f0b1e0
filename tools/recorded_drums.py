# SPDX-License-Identifier: MIT
"""Sets the features of a sound beside those of recorded drums (tests/reference/recorded_drums.json).

The file has, for each class such as `snare/top` and each feature, the number of instruments, the 10th
percentile, the median and the 90th percentile over them."""
import json
import math
import pathlib
from statistics import fmean

import sound_features

FILE = pathlib.Path(__file__).resolve().parent.parent / "tests/reference/recorded_drums.json"
FEWEST = 5  # instruments that a class needs, or its percentiles mean little
WIDER_LEVEL = 3.0  # [dB] by which ranges of levels are widened on both sides
WIDER_SHARE = 0.25  # by which ranges of times and frequencies are
ASKED = 0.7  # the share of a group's features that lie inside the widened range
NORMAL_RANGE = 2.56  # standard deviations from the 10th to the 90th percentile of a normal distribution
CLASSES = ("snare/top", "tom/top", "floortom/top", "kick/in", "crossstick/top")  # of the nearest-class test

_TOS = [f"to_{window}_{round(f)}" for window in sound_features.WINDOWS
        for f in sound_features.THIRD_OCTAVES if f > 90.0]
GROUPS = {
    "spectrum": (*_TOS, *(f"{name}_{window}" for window in sound_features.WINDOWS for name in (
        *(f"b_{band}" for band in sound_features.BANDS), "hfbody", "centmag"))),
    "decay": (*(f"{depth}_{octave}" for depth in ("d20", "d40") for octave in sound_features.OCTAVES),
              *(f"te_{octave}" for octave in sound_features.OCTAVES[:-1]), "t20_ms", "t40_ms", "f1_t60"),
    "attack": ("hf_t10_ms", "hf_t50_ms", "hf_t90_ms", "hf_click_vs_body", "rise_ms", "crest300"),
    "texture": ("hf_mod_db", "hf_flat", "tonal4"),
}


def classes():
    """Features by class: {class: {feature: (instruments, p10, median, p90)}}."""
    with open(FILE, encoding="utf-8") as file:
        return {name: facts["features"] for name, facts in json.load(file)["classes"].items()}


def is_level(feature):
    return not (feature.startswith(("d20_", "d40_", "te_", "t20_", "t40_", "hf_t", "centmag", "rise"))
                or feature in ("f1", "f1_t60"))


def widened(feature, low, high):
    if is_level(feature):
        return low - WIDER_LEVEL, high + WIDER_LEVEL
    return low * (1.0 - WIDER_SHARE), high * (1.0 + WIDER_SHARE)


def outside(feature, value, spread):
    """How far [dB or ratio] a value lies outside the widened range of `spread`: < 0 below, > 0 above, 0 inside."""
    low, high = widened(feature, spread[1], spread[3])
    if math.isnan(value):
        return math.nan
    if low <= value <= high:
        return 0.0
    limit = low if value < low else high
    return value - limit if is_level(feature) else value / limit


def is_inside(feature, value, spread):
    return outside(feature, value, spread) == 0.0  # NaN is not


def count_inside(group, values, recorded):
    """How many features of a group lie inside, how many must, and of how many."""
    names = [name for name in GROUPS[group] if name in recorded]
    inside = sum(is_inside(name, values[name], recorded[name]) for name in names)
    return inside, math.floor(ASKED * len(names)), len(names)


def distance(values, recorded):
    """Mean over the groups of the mean squared deviation from the medians, in standard deviations squared."""
    means = []
    for names in GROUPS.values():
        squares = [((values[name] - spread[2]) / ((spread[3] - spread[1]) / NORMAL_RANGE)) ** 2
                   for name, spread in ((name, recorded[name]) for name in names if name in recorded)
                   if math.isfinite(values[name])]
        means.append(fmean(squares))
    return fmean(means)


def nearest(values, recorded):
    """Distances by class of the nearest-class test, the nearest first."""
    found = {name: distance(values, recorded[name]) for name in CLASSES}
    return dict(sorted(found.items(), key=lambda item: item[1]))
