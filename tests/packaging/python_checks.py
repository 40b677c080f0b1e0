# SPDX-License-Identifier: MIT
"""What the Python package gives, against what the program says: run by test_python.sh."""

import inspect
import json
import math
import os
import subprocess
import unittest

import numpy as np

import tabor

PROGRAM = os.environ["TABOR"]


def program(*arguments):
    """Standard output of the program."""
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, check=True).stdout


def program_sound(*arguments):
    """What `tabor render` renders, as floats: AU has a header of its own length and big numbers first."""
    said = program("render", *arguments, "--format", "float", "-q", "-o", "-")
    start = int.from_bytes(said[4:8], "big")
    return np.frombuffer(said[start:], ">f4")


class Sounds(unittest.TestCase):
    def test_strokes_sound_as_the_program_renders_them(self):
        strokes = [tabor.Stroke(0.1, velocity=4, radius=0.02), tabor.Stroke()]
        sound = tabor.render(tabor.Definition("tabor", {"wires.tension": 8}), strokes, duration=0.3,
                             quality="live")
        expected = program_sound("tabor", "--quality", "live", "--duration", "0.3", "--set", "wires.tension=8",
                                 "--strike", "time=0.1,velocity=4,radius=0.02", "--strike", "time=0")
        self.assertEqual(sound.dtype, np.float32)
        np.testing.assert_array_equal(sound[0], expected)
        self.assertGreater(np.abs(sound).max(), 0.01)

    def test_microphones_are_rows(self):
        both = tabor.render("frame-drum", duration=0.05, quality="draft", mics=["far", "top"])
        self.assertEqual(both.shape, (2, 2400))
        np.testing.assert_array_equal(both[1:], tabor.render("frame-drum", duration=0.05, quality="draft"))
        with self.assertRaisesRegex(ValueError, "no microphone is called 'nowhere'"):
            tabor.render("frame-drum", mics=["nowhere"])
        with self.assertRaisesRegex(ValueError, "twice"):
            tabor.render("frame-drum", mics=["top", "top"])

    def test_strokes_outside_are_refused(self):
        with self.assertRaisesRegex(ValueError, "2 s is outside of 1 s"):
            tabor.render("frame-drum", [tabor.Stroke(2)], duration=1, quality="draft")

    def test_blocks_make_no_difference(self):
        model = tabor.Model("tabor", quality="draft")
        whole = tabor.Drum(model).process(1000, [tabor.strike(3), tabor.strike(700, striker="stick")])
        drum = tabor.Drum(model)
        blocks = [drum.process(300, [tabor.strike(3)]), drum.process(300),
                  drum.process(400, [tabor.strike(100, striker="stick")])]
        np.testing.assert_array_equal(whole, np.concatenate(blocks, axis=1))

    def test_a_saved_drum_goes_on(self):
        model = tabor.Model("tabor", quality="draft")
        drum, other = tabor.Drum(model), tabor.Drum(model)
        drum.process(500, [tabor.strike()])
        other.load(drum.save())
        np.testing.assert_array_equal(drum.process(500), other.process(500))
        with self.assertRaises(ValueError):
            other.load(drum.save()[:-1])

    def test_a_ringing_drum_can_become_another(self):
        draft = {"quality": "draft"}
        drum = tabor.Drum(tabor.Model("tabor", **draft))
        for preset in ("frame-drum", "tom-12"):
            drum.process(500, [tabor.strike()])
            drum.swap(tabor.Model(preset, **draft))
            self.assertGreater(np.abs(drum.process(4800)).max(), 0)
            self.assertEqual(drum.model.definition["drum.name"], preset)
        drum.swap(tabor.Model(tabor.Definition("tom-12", {"batter.tension": 2500}), **draft))
        drum.process(10)
        del drum  # while the swap may still be under way

    def test_a_buzz_bounces_until_it_is_released(self):
        drum = tabor.Drum(tabor.Model("tabor", quality="draft"))
        buzz = tabor.strike(velocity=1, technique="buzz", pressure=0.3, id=7)
        path = drum.trace(9600, [buzz, tabor.release(9000, id=7)])
        touches = np.diff((path["striker_force"] > 0).astype(int)) > 0
        self.assertGreater(touches.sum(), 3)
        self.assertTrue(np.isnan(path["striker"][-1]))
        self.assertRaises(ValueError, tabor.strike, technique="shout")

    def test_the_ledger_closes(self):
        drum = tabor.Drum(tabor.Model("tabor", quality="draft"))
        drum.process(4800, [tabor.strike(velocity=3), tabor.damp(2000), tabor.release(4000),
                            tabor.parameter("wires.strainer", 0.5, 4500)])
        ledger = drum.ledger()
        spent = sum(ledger[name] for name in ledger if name not in ("injected", "control", "high_band"))
        self.assertAlmostEqual(ledger["injected"] + ledger["control"], spent, delta=1e-9 * ledger["injected"])
        self.assertEqual(drum.statistics()["strikes"], 1)
        self.assertEqual(drum.statistics()["dropped_events"], 0)
        drum.reset()
        self.assertTrue(drum.silent)


class Facts(unittest.TestCase):
    def test_presets(self):
        expected = json.loads(program("presets", "--json"))["presets"]
        self.assertEqual([preset.name for preset in tabor.presets()], [row["name"] for row in expected])

    def test_modes(self):
        expected = json.loads(program("modes", "tom-12", "--quality", "draft", "--json"))["modes"]
        modes = tabor.Model("tom-12", quality="draft").modes
        self.assertEqual(len(modes), len(expected))
        for name in ("frequency", "decay_rate"):
            np.testing.assert_allclose(modes[name], [row[name] for row in expected], rtol=1e-9)
        self.assertEqual(list(modes["part"]), [row["head"] for row in expected])

    def test_trace(self):
        program("render", "tabor", "--quality", "draft", "--duration", "0.02", "-q", "-o", "traced.wav",
                "--trace", "trace.csv")
        expected = np.genfromtxt("trace.csv", delimiter=",", skip_header=1)
        trace = tabor.trace("tabor", duration=0.02, quality="draft")
        self.assertEqual(len(trace), 960)
        for column, name in enumerate(tabor.TRACE.names):
            np.testing.assert_allclose(trace[name], expected[:, column], rtol=1e-5, atol=1e-12)
        self.assertGreater(np.nanmax(trace["striker_force"]), 1)

    def test_versions(self):
        self.assertEqual(program("--version").decode().split()[1], tabor.__version__)


class Definitions(unittest.TestCase):
    def test_values_have_their_types(self):
        drum = tabor.Definition("snare-14x5.5", {"batter.tension": 4000, "wires.count": np.int64(12)})
        self.assertEqual(drum["batter.tension"], 4000.0)
        drum["batter.pitch"] = "A3"
        self.assertEqual(drum["batter.pitch"], 220.0)
        drum.tune()
        self.assertEqual(drum["batter.pitch"], 0.0)
        self.assertLess(drum["batter.tension"], 4000.0)
        drum["batter.tension"] = 4000
        self.assertEqual(drum["wires.count"], 12)
        self.assertEqual(drum["wires.head"], "resonant")
        self.assertTrue(math.isnan(drum["wire.1.tension"]))
        self.assertEqual(tabor.Definition(None, drum.as_dict()).as_dict(), drum.as_dict())

    def test_errors_say_what_is_allowed(self):
        drum = tabor.Definition("tabor")
        before = drum.as_dict()
        with self.assertRaises(tabor.Error) as refused:
            drum.update({"batter.damping_0": 1, "batter.tension": 1e9})
        self.assertEqual((refused.exception.key, refused.exception.maximum), ("batter.tension", 20000))
        self.assertEqual(drum.as_dict(), before)
        for wrong in (lambda: tabor.Definition("nonesuch"), lambda: drum["batter.tensoin"],
                      lambda: tabor.Model("tabor", rate=1), lambda: tabor.Model("tabor", quality="best")):
            self.assertRaises(ValueError, wrong)

    def test_parameters(self):
        row = next(row for row in tabor.parameters() if (row.section, row.key) == ("batter", "tension"))
        self.assertEqual((row.unit, row.minimum, row.maximum), ("N/m", 100, 20000))
        with self.assertRaisesRegex(ValueError, "swap"):
            tabor.parameter("batter.tension", 4000)


class Documentation(unittest.TestCase):
    def test_everything_public_is_described_and_typed(self):
        for name in tabor.__all__:
            thing = getattr(tabor, name)
            if not (inspect.isclass(thing) or inspect.isfunction(thing)):
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            methods = inspect.getmembers(thing, inspect.isfunction) if inspect.isclass(thing) else [(name, thing)]
            for method, function in methods:
                if method.startswith("_") or not function.__module__.startswith("tabor"):
                    continue
                self.assertTrue(inspect.getdoc(function), f"{name}.{method}")
                self.assertIn("return", function.__annotations__, f"{name}.{method}")


if __name__ == "__main__":
    unittest.main()
