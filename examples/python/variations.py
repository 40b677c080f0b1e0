# SPDX-License-Identifier: MIT
"""Renders variations of a drum into one NumPy array, in parallel, and says how long it took.

    python variations.py [--count 100] [-o variations.npy]

Tensions of both heads, wires and the stroke are drawn at random, as for a data set.
"""

from __future__ import annotations

import argparse
import sys
import time
from typing import List

import numpy as np

import tabor


def variations(preset: str, count: int, seed: int) -> List[tabor.Definition]:
    """The drum with heads and wires that differ by up to a fifth."""
    random = np.random.default_rng(seed)
    usual = tabor.Definition(preset)
    keys = [key for key in ("batter.tension", "resonant.tension", "wires.tension", "strike.velocity") if key in usual]
    drums = []
    for _ in range(count):
        factors = random.uniform(0.8, 1.2, len(keys))
        drums.append(usual.copy({key: float(usual[key]) * factor for key, factor in zip(keys, factors)}))
    return drums


def main() -> None:
    """Reads the command line, renders and writes."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--preset", default="snare-14x5.5", help="the drum (%(default)s)")
    parser.add_argument("--count", type=int, default=100, help="of variations (%(default)s)")
    parser.add_argument("--duration", type=float, default=0.5, help="of each [s] (%(default)s)")
    parser.add_argument("--workers", type=int, help="threads (as many as there are processors)")
    parser.add_argument("--seed", type=int, default=1, help="of the variations (%(default)s)")
    parser.add_argument("-o", "--output", help="a .npy file: shape (count, takes, microphones, frames)")
    options = parser.parse_args()

    def progress(done: int, total: int) -> None:
        if sys.stderr.isatty():
            print(f"\r{done} of {total}", end="\n" if done == total else "", file=sys.stderr, flush=True)

    drums = variations(options.preset, options.count, options.seed)
    start, used = time.perf_counter(), time.process_time()
    sounds = tabor.render_takes(drums, duration=options.duration, workers=options.workers, progress=progress)
    took, used = time.perf_counter() - start, time.process_time() - used
    peaks = 20 * np.log10(np.abs(sounds).max(axis=(1, 2, 3)))
    print(f"{len(drums)} x {options.duration:g} s of {options.preset}: {took:.1f} s, {used:.1f} s of processor time; "
          f"peaks {peaks.min():.1f} to {peaks.max():.1f} dBFS")
    if options.output:
        np.save(options.output, sounds)


if __name__ == "__main__":
    main()
