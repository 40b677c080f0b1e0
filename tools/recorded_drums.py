# SPDX-License-Identifier: MIT
"""Sets the features of a sound beside those of recorded drums (tests/reference/recorded_drums.json).

The file has, for each class such as `snare/top` and each feature, the number of instruments, the 10th
percentile, the median and the 90th percentile over them."""
import json
import math
import pathlib
from fractions import Fraction
from statistics import fmean
from typing import NamedTuple

import sound_features

FILE = pathlib.Path(__file__).resolve().parent.parent / "tests/reference/recorded_drums.json"
LINES = FILE.with_name("recorded_lines.json")  # likewise, of the drums whose sound is known
FEWEST = 5  # instruments that a class needs, or its percentiles mean little
WIDER_LEVEL = 3.0  # [dB] by which ranges of levels are widened on both sides
WIDER_SHARE = 0.25  # by which ranges of times and frequencies are
ASKED = 0.7  # the share of a group's features that lie inside the widened range
ASKED_STRICTLY = Fraction(95, 100)  # the same in the strict gate
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

# Of the strict gate alone. hf_flat of the texture is blind to lines that are closer than its pieces of 23 ms tell apart.
STRICT_GROUPS = GROUPS | {
    "lines": (*(f"flat95_{low}" for low, _ in sound_features.LINES), "components_4800"),
}


def classes():
    """Features by class: {class: {feature: (instruments, p10, median, p90)}}; lines where any are known."""
    with open(FILE, encoding="utf-8") as file, open(LINES, encoding="utf-8") as more:
        lines = json.load(more)["classes"]
        return {name: facts["features"] | lines.get(name, {}) for name, facts in json.load(file)["classes"].items()}


def is_level(feature):
    return not (feature.startswith(("components_", "d20_", "d40_", "te_", "t20_", "t40_", "hf_t", "centmag", "rise"))
                or feature in ("f1", "f1_t60"))


def widened(feature, low, high):
    if is_level(feature):
        return low - WIDER_LEVEL, high + WIDER_LEVEL
    return low * (1.0 - WIDER_SHARE), high * (1.0 + WIDER_SHARE)


def beyond(feature, value, low, high):
    """How far [dB or ratio] a value lies outside a range: 0 inside, NaN where the sound does not have the feature."""
    if math.isnan(value):
        return math.nan
    if low <= value <= high:
        return 0.0
    limit = low if value < low else high
    return value - limit if is_level(feature) else value / limit


def outside(feature, value, spread):
    """How far [dB or ratio] a value lies outside the widened range of `spread`."""
    return beyond(feature, value, *widened(feature, spread[1], spread[3]))


def is_inside(feature, value, spread):
    return outside(feature, value, spread) == 0.0  # NaN is not


def count_inside(group, values, recorded):
    """How many features of a group lie inside, how many must, and of how many."""
    names = [name for name in GROUPS[group] if name in recorded]
    inside = sum(is_inside(name, values[name], recorded[name]) for name in names)
    return inside, math.floor(ASKED * len(names)), len(names)


def typical_share(instruments):
    """Share of the instruments themselves whose value of a feature lies from its 10th to its 90th percentile.

    Among n sorted values, counted from 0, the percentiles lie at places (n - 1)/10 and 9 (n - 1)/10, between values
    as a rule; whole places between them are values inside: three of 5, four of 6, five of 7, eight of 12."""
    first, last = -(-(instruments - 1) // 10), 9 * (instruments - 1) // 10
    return Fraction(last - first + 1, instruments)


class Strict(NamedTuple):
    """What the strict gate finds of one group."""
    plain: int  # features from the 10th to the 90th percentile
    plain_asked: int
    wide: int  # features inside the widened range
    wide_asked: int
    count: int
    outside: dict  # of features outside the plain range: by how much [dB or ratio]

    @property
    def passes(self):
        return self.plain >= self.plain_asked and self.wide >= self.wide_asked


def judge_strictly(group, values, recorded):
    names = [name for name in STRICT_GROUPS[group] if name in recorded and name in values]
    share = typical_share(max((recorded[name][0] for name in names), default=1))
    away = {name: beyond(name, values[name], recorded[name][1], recorded[name][3]) for name in names}
    return Strict(plain=sum(value == 0.0 for value in away.values()), plain_asked=math.floor(share * len(names)),
                  wide=sum(is_inside(name, values[name], recorded[name]) for name in names),
                  wide_asked=math.floor(ASKED_STRICTLY * len(names)), count=len(names),
                  outside={name: value for name, value in away.items() if value != 0.0})


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
