# SPDX-License-Identifier: MIT
"""Tabor in Python, from a first stroke to a kit, with plots.

    python tutorial.py [-o FOLDER]

Each function below is a lesson that stands alone, and draws one picture into the folder. docs/python.md is the guide
that goes with it.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

import tabor

RATE = 48000


def first_sound(axes: Axes) -> None:
    """A preset, two strokes, an array: shape (microphones, frames), 1.0 is full scale."""
    sound = tabor.render("snare-14x5.5", [tabor.strike(0, velocity=4.5), tabor.strike(0.5, velocity=1.5)], duration=1.0)
    print(f"first sound: shape {sound.shape}, {sound.dtype}, peak {np.abs(sound).max():.2f}")
    axes.plot(np.arange(sound.shape[1]) / RATE, sound[0], linewidth=0.5)
    axes.set(title="Two strokes on a snare drum", xlabel="time [s]", ylabel="sound pressure [full scale]")


def a_drum_of_your_own(axes: Axes) -> None:
    """A definition is a mapping from keys to values in SI units; a wrong one is refused with its key."""
    usual = tabor.Definition("tom-12")
    tuned = usual.copy({"batter.pitch": "A3", "resonant.pitch": "C#4"})
    try:
        tuned["batter.tension"] = 1e9
    except tabor.Error as error:
        print(f"a drum of your own: {error} (key {error.key!r}, at most {error.maximum:g})")
    for name, drum in (("as it is", usual), ("tuned to A3", tuned)):
        modes = tabor.Model(drum).modes
        axes.plot(modes["frequency"], modes["decay_rate"], ".", label=f"{name}: {drum.pitch():.0f} Hz at a lug")
    axes.set(title="Modes of a tom", xlabel="frequency [Hz]", ylabel="decay rate [1/s]", xlim=(0, 2000), ylim=(0, 200))
    axes.legend()


def what_moves(axes: Axes) -> None:
    """A trace has a row a sample: heights, forces and energy."""
    model = tabor.Model("tabor")
    path = tabor.trace(model, [tabor.strike(0, velocity=3)], duration=0.008)
    milliseconds = 1e3 * path["time"]
    for name in ("head", "wire", "striker"):
        axes.plot(milliseconds, 1e3 * path[name], label=name)
    axes.set(title="Head, gut string and stick of a tabor", xlabel="time [ms]", ylabel="height [mm]", ylim=(-4, 4))
    axes.legend()


def where_the_energy_goes(axes: Axes) -> None:
    """The ledger accounts for every joule; its residual is the error of the numerics."""
    drum = tabor.Drum("snare-14x5.5", mics=["top"])
    drum.process(RATE // 4, [tabor.strike(0, velocity=3)])
    ledger = drum.ledger()
    print(f"where the energy goes: residual {ledger.residual / ledger.injected:.1e} of what the stroke brought")
    shares = {name: value for name, value in ledger._asdict().items()
              if name not in ("injected", "control", "high_band", "residual")}
    axes.barh(list(shares), [100 * value / ledger.injected for value in shares.values()])
    axes.set(title="A quarter of a second after a stroke", xlabel="share of the stroke's energy [%]")


def what_can_happen(axes: Axes) -> None:
    """Events change a drum while it rings: buzzes, hands, parameters, another drum."""
    snare, tom = tabor.Model("snare-14x5.5"), tabor.Model("tom-12")
    drum = tabor.Drum(snare, mics=["left", "right"])
    sound = drum.process(2 * RATE, [
        tabor.strike(0.0, 1.5, technique="buzz", pressure=0.4, id=1), tabor.release(0.3, id=1),
        tabor.strike(0.5, 4.0), tabor.change(0.55, "wires.strainer", 0.0),
        tabor.strike(0.8, 4.0), tabor.damp(0.9, 10.0), tabor.silence(1.1),
        tabor.replace(1.2, tom), tabor.strike(1.2, 4.0), tabor.gain(1.5, 0.25), tabor.strike(1.6, 4.0)])
    print(f"what can happen: {drum.statistics().strikes} strokes, {drum.statistics().dropped_events} events dropped; "
          f"it is now a {drum.model.definition['drum.name']}")
    axes.plot(np.arange(sound.shape[1]) / RATE, sound[0], linewidth=0.5)
    marks = ((0, "buzz"), (0.5, "snares off"), (0.8, "a hand"), (1.1, "silence"), (1.2, "a tom"), (1.5, "gain"))
    for time, name in marks:
        axes.axvline(time, color="grey", linewidth=0.5)
        axes.annotate(name, (time, 0.95), xycoords=("data", "axes fraction"), rotation=90, va="top", fontsize=8)
    axes.set(title="Events", xlabel="time [s]", ylabel="sound pressure [full scale]")


def what_if(axes: Axes) -> None:
    """A drum can be copied while it rings: two futures of one stroke."""
    drum = tabor.Drum("frame-drum", mics=["top"])
    drum.process(RATE // 10, [tabor.strike(0, 4.0)])
    held = drum.copy()
    for name, sound in (("free", drum.process(RATE // 2)),
                        ("under a hand", held.process(RATE // 2, [tabor.damp(0.05, 5.0)]))):
        axes.plot(np.arange(RATE // 2) / RATE, sound[0], linewidth=0.5, label=name)
    axes.set(title="Two futures of a frame drum", xlabel="time [s]", ylabel="sound pressure [full scale]")
    axes.legend()


def rooms(axes: Axes) -> None:
    """`render` adds the room that the definition names."""
    frames = RATE // 100
    for kind in ("none", "booth", "studio", "hall"):
        drum = tabor.Definition("tom-12", {"room.kind": kind})
        sound = tabor.render(drum, duration=1.0, mics=["left"])[0]
        level = 10 * np.log10(np.mean(sound.reshape(-1, frames)**2, axis=1) + 1e-12)
        axes.plot(np.arange(len(level)) * frames / RATE, level, label=kind)
    axes.set(title="A tom in four rooms", xlabel="time [s]", ylabel="level [dBFS]", ylim=(-100, 0))
    axes.legend()


def a_kit(axes: Axes) -> None:
    """Many drums and takes at once, on all processors: shape (drums, takes, microphones, frames)."""
    tensions = np.linspace(1500, 4500, 5)
    drums = [tabor.Definition("tom-12", {"batter.tension": float(tension)}) for tension in tensions]
    takes = [[tabor.strike(0, velocity)] for velocity in (1.0, 3.0, 9.0)]
    kit = tabor.render_takes(drums, takes, duration=0.5, progress=lambda done, total: print(f"a kit: {done} of {total}"))
    spectra: Any = np.abs(np.fft.rfft(kit[:, :, 0], axis=-1))
    frequencies = np.fft.rfftfreq(kit.shape[-1], 1 / RATE)
    below = frequencies < 500
    strongest = frequencies[below][spectra[..., below].argmax(axis=-1)]
    for take, velocity in enumerate((1, 3, 9)):
        axes.plot(tensions, strongest[:, take], "o-", label=f"{velocity} m/s")
    axes.set(title="The strongest partial of a tom", xlabel="batter.tension [N/m]", ylabel="frequency [Hz]")
    axes.legend()


LESSONS = (first_sound, a_drum_of_your_own, what_moves, where_the_energy_goes, what_can_happen, what_if, rooms, a_kit)


def main() -> None:
    """Reads the command line, and gives the lessons."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("tutorial"), help="folder of the plots (%(default)s)")
    folder: Path = parser.parse_args().output
    folder.mkdir(parents=True, exist_ok=True)
    for number, lesson in enumerate(LESSONS, 1):
        figure, axes = plt.subplots(figsize=(8, 4), constrained_layout=True)
        lesson(axes)
        figure.savefig(folder / f"{number}-{lesson.__name__}.png", dpi=120)
        plt.close(figure)


if __name__ == "__main__":
    main()
