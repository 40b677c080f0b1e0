#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/compare-takes, tools/docs/compare-synthesizers, tools/docs/compare-qualities and tools/docs/compare-reference: what they measure
# of sounds that are known, what they write, and what they say of a program that is not there.
#
# test_compare_tools.sh SOURCE-FOLDER

# shellcheck source=tests/support/find_python.sh
. "$(dirname "$0")/../support/find_python.sh"
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
tools=$1/tools

python=$(find_python numpy,scipy,matplotlib,soundfile) ||
  skip "needs python3 python3-numpy python3-scipy python3-matplotlib python3-soundfile"

# Takes of live play differ as recorded ones do; those that nothing scatters do not, and other parameters are heard.
takes() {
  "$python" "$tools/compare-takes" --program "$TABOR" "$@" >"$out" 2>"$err"
  status=$?
}
takes --check
same "takes differ as recorded ones do: $(cat "$out" "$err")" "0 5" "$status $(wc -l <"$out")"
takes --check --humanize 0 --takes 2 tom-12
same "takes that are all the same" "1 tom-12: takes differ by 0.00 dB" "$status $(cat "$out")"
takes --humanize 0 --takes 1 --against quality.losses=1 tom-12
same "the same parameters" "0 tom-12: +0.0 dB from 0 to 50 ms, +0.0 dB from 50 to 200 ms, 60 dB times +0 ms" "$status $(cat "$out")"

# Two decaying sines, one an octave above the other, and a push of 5 ms that comes back later.
check "facts of known sounds" env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$tools:$tools/docs" "$python" - "$tools" <<'PYTHON'
import sys
from importlib.machinery import SourceFileLoader

import numpy as np

tool = SourceFileLoader("compare_qualities", f"{sys.argv[1]}/docs/compare-qualities").load_module()
rate = 48000
time = np.arange(int(0.6 * rate)) / rate
low, high = (np.exp(-6.9078 * time / 0.5) * np.sin(2 * np.pi * f * time) for f in (250.0, 500.0))
assert abs(tool.decay_time(low, rate) - 0.5) < 0.01
assert tool.centroid(low, rate) < tool.centroid(low + high, rate) < tool.centroid(high, rate)
bands = tool.third_octaves(low, rate, tool.BANDS)
twice = np.interp(np.arange(0, 0.6, 0.5 / rate), time, low)  # of twice the rate
assert abs(tool.third_octaves(twice, 2 * rate, [250.0]) - tool.third_octaves(low, rate, [250.0])) < 0.05
assert tool.BANDS[bands.argmax()] == 250.0
assert abs(tool.band_differences(bands + 3.0, bands)["worst_db"] - 3.0) < 1e-9
head = np.where(time < 0.2, np.sin(2 * np.pi * 202.0 * time), np.sin(2 * np.pi * 200.0 * time))
assert abs(tool.glide({"head_m": head}, rate) - 17.2) < 1.5
force = ((time < 0.005) | ((time > 0.02) & (time < 0.03))).astype(float)
assert abs(tool.contact_duration({"time_s": time, "striker_force_n": force}) - 0.005) < 1e-4
PYTHON

check "verdicts of known differences" env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$tools" "$python" - <<'PYTHON'
import comparison_tables as tables

own = {"live": [[0.0, -2.9, 3.1], [4.0, 5.1, -7.0]], "faster": [[0.0, 0.0, 3.2], [0.0, 0.0, 0.0]]}
assert tables.inside("live", {"differences": own}) == ["3 of 6 within 3 dB", "4 within 5 dB", "7.0 dB"]
assert [tables.hertz(1000.0 * 2.0 ** (i / 3.0)) for i in (-10, -9, 0, 5, 12)] == [
    "100 Hz", "125 Hz", "1 kHz", "3.15 kHz", "16 kHz"]
PYTHON

for tool in compare-synthesizers compare-qualities compare-reference; do
  "$python" "$tools/docs/$tool" --program ./none --docs . >"$out" 2>"$err"
  same "$tool without a program" "1 1 $tool: none: no such program" "$? $(wc -l <"$err") $(cat "$err")"
  "$python" "$tools/docs/$tool" --wrong >"$out" 2>"$err"
  same "$tool, a wrong option" "2 1" "$? $(wc -l <"$err")"
done

# Where nothing is on the path Tabor is measured and the others are named.
python=$("$python" -c 'import sys; print(sys.executable)')
PATH=$PWD "$python" "$tools/docs/compare-synthesizers" --program "$TABOR" --print --repeats 1 --seconds 10 \
  --quality draft >"$out" 2>"$err" || complain "compare-synthesizers: $(cat "$err")"
same "those who played" "3" "$(json rows.size)"
same "those who are missing" "3" "$(json missing.size)"
holds "a cost" "$(json rows.1.real_time_factor) > 0"

finish
