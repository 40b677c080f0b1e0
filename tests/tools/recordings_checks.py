# SPDX-License-Identifier: MIT
"""What tools/sound_features.py measures of sounds that are known, how tools/recorded_drums.py judges, and where
recorded clips land in its nearest-class test: run by test_compare_recordings.sh."""
import math
import pathlib
import sys
import unittest
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

sys.path.insert(0, sys.argv.pop(1))

import numpy as np
import soundfile
from scipy import signal

import recorded_drums as drums
import sound_features
from sound_features import features

RATE = 44100
SEED = 7

loader = SourceFileLoader("compare_recordings", str(pathlib.Path(sys.path[0]) / "compare-recordings"))
compare_recordings = module_from_spec(spec_from_loader(loader.name, loader))
loader.exec_module(compare_recordings)
CLIPS = pathlib.Path(__file__).resolve().parent.parent / "reference" / "recordings"


def time(seconds=1.5):
    return np.arange(int(seconds * RATE)) / RATE


def decaying(t60, seconds=1.5):
    return 10.0 ** (-3.0 * time(seconds) / t60)


def tone(frequency, t60=0.5):
    return decaying(t60) * np.sin(2.0 * np.pi * frequency * time())


def noise(t60=0.5):
    return decaying(t60) * np.random.default_rng(SEED).standard_normal(time().size)


class Features(unittest.TestCase):
    def near(self, value, expected, part=0.05):
        self.assertLess(abs(value - expected), part * abs(expected), f"{value} instead of {expected}")

    def test_a_tone_is_in_its_own_bands(self):
        found = features(tone(250.0), RATE)
        self.assertGreater(found["to_e50_250"], -0.5)  # 50 ms are 12 periods
        self.assertGreater(found["b_low_m200"], -0.1)
        self.assertLess(found["b_mid_m200"], -20.0)
        self.assertLess(found["to_m200_1000"], -40.0)
        self.near(found["f1"], 250.0, 0.01)
        self.assertGreater(found["tonal4"], -0.5)

    def test_two_tones_differ_as_they_were_made(self):
        found = features(tone(200.0) + 0.1 * tone(4000.0), RATE)
        self.near(found["hfbody_m200"], -20.0, 0.02)
        self.near(found["to_m200_4000"] - found["to_m200_198"], -20.0, 0.02)
        # Two lines of 10 to 1, each as wide as the window makes it.
        self.near(found["centmag_m200"], (10.0 * 200.0 + 4000.0) / 11.0, 0.1)

    def test_an_exponential_decay_has_one_time(self):
        for t60 in (0.3, 0.6):
            found = features(tone(500.0, t60), RATE)
            for name, expected in (("te_500", 1.0), ("f1_t60", 1.0), ("d20_500", 1.0 / 3.0), ("d40_500", 2.0 / 3.0),
                                   ("t20_ms", 1.0 / 3.0), ("t40_ms", 2.0 / 3.0)):
                self.near(found[name], 1e3 * t60 * expected, 0.06)

    def test_a_late_decay_is_that_of_the_slower_part(self):
        late, hiss = (np.random.default_rng(SEED + i).standard_normal(time().size) for i in (1, 2))
        early, late = noise(0.15), decaying(0.6) * late
        for octave, found in sound_features.late_decays(early + 0.03 * late + 3e-5 * hiss, RATE).items():
            self.near(found, 600.0, 0.1)
        self.assertTrue(math.isnan(sound_features.late_decays(early + 0.03 * hiss, RATE)[1000]))

    def test_what_never_falls_has_no_time(self):
        found = features(np.sin(2.0 * np.pi * 500.0 * time()), RATE)
        self.assertTrue(math.isnan(found["t40_ms"]))

    def test_noise_is_flat_and_arrives_evenly(self):
        found = features(noise(), RATE)
        # Energy e^(-t/tau), tau = t60/(6 ln 10): half of it arrives within tau ln 2.
        half = 1e3 * 0.5 / (6.0 * math.log(10.0)) * math.log(2.0)
        self.near(found["hf_t50_ms"], half, 0.15)
        self.near(found["hf_t90_ms"] / found["hf_t50_ms"], math.log(10.0) / math.log(2.0), 0.1)
        self.assertGreater(found["hf_flat"], -1.0)
        # A frame of 2 ms in a band of 8 kHz is a mean over 2 * 8000 * 0.002 = 32 squares: 4.34 sqrt(2/32) dB.
        self.near(found["hf_mod_db"], 4.34 * math.sqrt(2.0 / 32.0), 0.25)
        self.assertLess(features(noise() + 30.0 * tone(3000.0), RATE)["hf_flat"], -10.0)

    def test_noise_has_no_lines_whatever_its_slope(self):
        """Powers of noise are exponential: the 97th percentile is ln(1/0.03)/ln 2 medians, and (sum P)^2/sum P^2 half their number."""
        even = 10.0 * math.log10(math.log(1.0 / 0.03) / math.log(2.0))
        sloping = signal.sosfilt(signal.butter(4, 2000.0, fs=RATE, output="sos"), noise())
        for sound in (noise(), sloping):
            found = sound_features.lines(sound, RATE)
            self.near(found["flat95_3500"], even, 0.15)
            self.near(found["flat95_8000"], even, 0.15)
            self.near(found["components_4800"], 0.5 * 543.0 * 0.2, 0.3)
        self.near(sound_features.lines(noise(), RATE)["line95_3500"], even, 0.15)
        self.assertGreater(sound_features.lines(sloping, RATE)["line95_3500"], even + 5.0)

    def test_a_comb_has_as_many_components_as_tones(self):
        comb = sum(decaying(0.5) * np.sin(2.0 * np.pi * f * time() + f) for f in np.arange(3600.0, 14900.0, 100.0))
        found = sound_features.lines(comb, RATE)
        self.assertGreater(found["flat95_3500"], 15.0)
        self.assertGreater(found["flat95_8000"], 15.0)
        self.near(found["components_4800"], 1.94 * 543.0 / 100.0, 0.2)  # a line under the window is 1.94 wide

    def test_a_click_before_the_body(self):
        sound = np.zeros(time().size)
        sound[:4] = (0.1, -0.1, 0.1, -0.1)
        body = tone(200.0)
        sound[441:] += body[:-441] * np.minimum(1.0, time()[:-441] / 0.02)
        soft = features(sound, RATE)
        self.assertGreater(soft["rise_ms"], 5.0)
        sound[:4] *= 5.0  # which leaves the peak to the body
        self.near(features(sound, RATE)["hf_click_vs_body"] - soft["hf_click_vs_body"], 20.0 * math.log10(5.0), 0.02)

    def test_crest_of_a_lasting_sine(self):
        self.near(features(np.sin(2.0 * np.pi * 3000.0 * time()), RATE)["crest300"], 10.0 * math.log10(2.0), 0.05)

    def test_level_rate_and_lead_in_do_not_matter(self):
        sound = tone(250.0) + 0.2 * noise()
        first = features(np.concatenate((np.zeros(100), sound)), RATE)
        later = features(np.concatenate((np.zeros(2000), 0.01 * sound)), RATE)
        for name, value in first.items():
            self.assertAlmostEqual(value, later[name], delta=1e-6 * abs(value) + 1e-6, msg=name)
        twice = features(np.repeat(tone(250.0), 2), 2 * RATE)
        self.near(twice["te_250"], first["te_250"], 0.05)
        self.near(twice["f1"], 250.0, 0.01)

    def test_silence_is_refused(self):
        with self.assertRaisesRegex(ValueError, "silent"):
            features(np.zeros(1000), RATE)


class Dynamics(unittest.TestCase):
    def test_trends_are_per_10_db(self):
        levels = [-20.0, -10.0, -5.0]
        layers = [{"centmag_e50": 1000.0 * 2.0 ** (0.02 * level), "hf_click_vs_body": 0.3 * level, "hfbody_e50": 4.0,
                   "t40_ms": math.nan, "te_1000": 100.0 * 2.0 ** (-0.01 * level)} for level in levels]
        found = compare_recordings.trends(levels, layers)
        self.assertEqual(found, {"centmag_e50": 0.2, "hf_click_vs_body": 3.0, "hfbody_e50": 0.0, "t40_ms": None,
                                 "te_1000": -0.1})


class Judgement(unittest.TestCase):
    def setUp(self):
        self.recorded = drums.classes()

    def test_groups_have_every_feature_once(self):
        self.assertEqual([len(names) for names in drums.GROUPS.values()], [60, 23, 6, 3])
        names = [name for group in drums.STRICT_GROUPS.values() for name in group]
        self.assertEqual(len(names), len(set(names)))
        measured = set(features(tone(250.0) + noise(), RATE)) | set(sound_features.lines(noise(), RATE))
        for name in names:
            self.assertIn(name, measured)
            self.assertIn(name, self.recorded["snare/top"])

    def test_ranges_are_widened_by_3_db_or_a_quarter(self):
        self.assertEqual(drums.widened("to_e50_1000", -20.0, -10.0), (-23.0, -7.0))
        self.assertEqual(drums.widened("te_1000", 100.0, 200.0), (75.0, 250.0))
        for name, level in (("hf_mod_db", True), ("tonal4", True), ("crest300", True), ("hf_click_vs_body", True),
                            ("hf_t50_ms", False), ("rise_ms", False), ("centmag_e50", False), ("f1_t60", False)):
            self.assertEqual(drums.is_level(name), level, name)
        spread = (5, 100.0, 150.0, 200.0)
        self.assertEqual(drums.outside("te_1000", 260.0, spread), 260.0 / 250.0)
        self.assertEqual(drums.outside("te_1000", 80.0, spread), 0.0)
        self.assertFalse(drums.is_inside("te_1000", math.nan, spread))

    def test_medians_are_nearest_to_themselves_and_all_inside(self):
        for name in drums.CLASSES:
            medians = {feature: spread[2] for feature, spread in self.recorded[name].items()}
            distances = drums.nearest(medians, self.recorded)
            self.assertEqual(next(iter(distances)), name)
            self.assertEqual(distances[name], 0.0)
            for group in drums.GROUPS:
                inside, asked, count = drums.count_inside(group, medians, self.recorded[name])
                self.assertEqual((inside, asked), (count, math.floor(0.7 * count)))

    def test_a_typical_share_is_that_of_the_recorded_instruments(self):
        for count in range(2, 40):
            values = np.arange(float(count))
            low, high = np.percentile(values, [10, 90])
            share = np.mean((values > low - 1e-9) & (values < high + 1e-9))
            self.assertAlmostEqual(float(drums.typical_share(count)), share, msg=str(count))
        self.assertEqual([round(100 * drums.typical_share(count)) for count in (5, 6, 7, 12)], [60, 67, 71, 67])

    def test_the_strict_gate_asks_for_both_ranges(self):
        recorded = self.recorded["kick/in"]
        values = {feature: spread[2] for feature, spread in recorded.items()}
        names = drums.GROUPS["spectrum"]
        self.assertTrue(drums.judge_strictly("spectrum", values, recorded).passes)

        def moved(count, by):
            return values | {name: recorded[name][3] + by for name in names[:count]}

        result = drums.judge_strictly("spectrum", moved(17, 1.0), recorded)  # seven instruments: 42 of 60
        self.assertEqual((result.plain, result.plain_asked, result.wide, result.wide_asked), (43, 42, 60, 57))
        self.assertTrue(result.passes)
        self.assertEqual(list(result.outside), list(names[:17]))
        self.assertAlmostEqual(result.outside[names[0]], 1.0)
        self.assertFalse(drums.judge_strictly("spectrum", moved(19, 1.0), recorded).passes)
        self.assertTrue(drums.judge_strictly("spectrum", moved(3, 20.0), recorded).passes)
        self.assertFalse(drums.judge_strictly("spectrum", moved(4, 20.0), recorded).passes)

    def test_one_group_cannot_hide_behind_the_others(self):
        values = {feature: spread[2] for feature, spread in self.recorded["snare/top"].items()}
        for name in drums.GROUPS["texture"]:
            values[name] -= 30.0
        self.assertEqual(drums.count_inside("texture", values, self.recorded["snare/top"])[0], 0)
        self.assertEqual(drums.count_inside("spectrum", values, self.recorded["snare/top"])[0], 60)

    def test_the_late_sound_is_the_room_whatever_was_struck(self):
        """Four wooden drums in one room; a shell of aluminium rings on itself."""
        times = {}
        for stroke in ("stroke", "cross-stick"):
            found = []
            for path in CLIPS.glob(f"*/{stroke}-*-top.flac"):
                if "aluminium" in path.parent.name:
                    continue
                sound, rate = soundfile.read(path, always_2d=True)
                found.append(sound_features.late_decays(sound[:, 0], rate)[1000])
            self.assertEqual(len(found), 4)
            self.assertLess(max(found) / min(found), 1.15, found)
            times[stroke] = np.median(found)
        self.assertLess(abs(times["stroke"] / times["cross-stick"] - 1.0), 0.1, times)

    def test_recorded_clips_are_nearest_to_their_own_class(self):
        count = 0
        for pattern, name in (("*/stroke-*-top.flac", "snare/top"), ("*/cross-stick-*-top.flac", "crossstick/top"),
                              ("tom-*/*.flac", "tom/top")):
            for path in CLIPS.glob(pattern):
                sound, rate = soundfile.read(path, always_2d=True)
                nearest = drums.nearest(features(sound[:, 0], rate), self.recorded)
                self.assertEqual(next(iter(nearest)), name, f"{path}: {nearest}")
                count += 1
        self.assertEqual(count, 12)


if __name__ == "__main__":
    print(f"seed {SEED}")
    unittest.main()
