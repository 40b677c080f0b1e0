# SPDX-License-Identifier: MIT
"""A parameter sweep, plotted: what the batter head's tension does to a drum.

    python tension_sweep.py [-o tension.png] [--preset tom-12]

Left the modes of the lower octaves, from the model alone; right the spectra of a stroke at each tension.
"""

from __future__ import annotations

import argparse
from typing import List

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

import tabor

MODES = 6
HIGHEST = 2000  # Hz


def models(preset: str, tensions: NDArray[np.float64]) -> List[tabor.Model]:
    """The drum at each tension [N/m]."""
    return [tabor.Model(tabor.Definition(preset, {"batter.tension": float(tension)}), quality="draft")
            for tension in tensions]


def spectrum(sound: NDArray[np.float32]) -> NDArray[np.float64]:
    """Level in dB over frequency, the strongest partial at 0."""
    power = np.abs(np.fft.rfft(sound * np.hanning(len(sound) * 2)[len(sound):]))
    level: NDArray[np.float64] = 20 * np.log10(power / power.max() + 1e-6)
    return level


def main() -> None:
    """Reads the command line, computes and draws."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="tension.png", help="the picture (%(default)s)")
    parser.add_argument("--preset", default="tom-12", help="the drum (%(default)s)")
    parser.add_argument("--steps", type=int, default=9, help="tensions to try (%(default)s)")
    options = parser.parse_args()

    usual = float(tabor.Definition(options.preset)["batter.tension"])
    tensions = usual * np.geomspace(0.5, 2.0, options.steps)
    drums = models(options.preset, tensions)

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    left.plot(tensions, [drum.modes["frequency"][:MODES] for drum in drums], "o-")
    left.set(xlabel="batter.tension [N/m]", ylabel="frequency [Hz]", title=f"{options.preset}: modes")
    spectra = np.array([spectrum(tabor.render(drum, duration=0.5)[0]) for drum in drums])
    frequencies = np.fft.rfftfreq(24000, 1 / 48000)
    shown = frequencies < HIGHEST
    picture = right.pcolormesh(tensions, frequencies[shown], spectra[:, shown].T, vmin=-60, shading="nearest")
    right.set(xlabel="batter.tension [N/m]", title="a stroke")
    figure.colorbar(picture, label="level [dB]")
    figure.savefig(options.output)


if __name__ == "__main__":
    main()
