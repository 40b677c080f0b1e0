#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/compare-cymbals: the page of cymbals says what it finds; what it measures of known sounds.
#
# test_compare_cymbals.sh SOURCE-FOLDER

# shellcheck source=tests/support/find_python.sh
. "$(dirname "$0")/../support/find_python.sh"
tests=$(cd "$(dirname "$0")/.." && pwd)
# shellcheck source=tests/support/host_checks.sh
. "$tests/support/host_checks.sh"
tools=$1/tools
export PYTHONDONTWRITEBYTECODE=1

python=$(find_python numpy,scipy,soundfile) || skip "needs python3 python3-numpy python3-scipy python3-soundfile"

"$python" "$tools/compare-cymbals" --program "$TABOR" --check >"$out" 2>"$err"
same "the page is what it finds: $(cat "$out" "$err")" 0 "$?"

# Noise that dies away by 60 dB in a second, and a tone of 5 kHz that does so.
"$python" - "$tools" >"$out" 2>"$err" <<'END'
import sys

sys.path.insert(0, sys.argv[1])
import numpy as np

import cymbal_features as cymbals

time = np.arange(2 * cymbals.RATE) / cymbals.RATE
fall = 10.0**(-3.0 * time)
noise = cymbals.features(fall * np.random.default_rng(1).standard_normal(len(time)))
tone = cymbals.features(fall * np.sin(2.0 * np.pi * 5000.0 * time))
for octave in cymbals.OCTAVES:
    assert abs(noise[f"t60_{octave}"] - 1000.0) < 80.0, (octave, noise[f"t60_{octave}"])
assert 6.0 < noise["line_4"] < 9.0 and 6.0 < noise["line_9"] < 9.0, noise
assert tone["line_4"] > 30.0 and abs(tone["cent_d"] - 5000.0) < 5.0 and abs(tone["to_d_5080"]) < 0.1, tone
assert abs(noise["dur20"] - 333.0) < 40.0, noise["dur20"]
inside, outside = cymbals.judge({"click": 1.0, "cent_a": 1200.0}, {"click": [1, 4.5, 5.0, 6.0], "cent_a": [1, 1450.0, 0.0, 1600.0]})
assert (inside, outside) == (["cent_a"], ["click"]), (inside, outside)
END
same "measures of known sounds: $(cat "$err")" 0 "$?"

"$python" "$tools/compare-cymbals" --program ./none --check >"$out" 2>"$err"
check "without a program" test "$?" != 0
finish
