# SPDX-License-Identifier: MIT
"""The command line: ``python -m tabor.fit``."""

from __future__ import annotations

import argparse
import csv
import io
import json
import math
import os
import sys
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Sequence, Tuple

from .._library import Error
from ..model import Model
from ..takes import _processors
from .comparison import PartialDifference, StrokeDifference, best_speed, partial_differences, stroke_differences
from .fitting import Fit, Settings, fit
from .parameters import unit_of
from .report import make_report
from .request import Request, read_request

_FAR = 5.0  # objective from which on the drum is doubtful
_LOUD = -10.0  # partials that the drum should have, below the strongest [dB]


def _arguments(given: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tabor fit", description="Find the drum of a recording: a preset, and its parameters with 90 % intervals.",
        epilog="A fit that was ended goes on where it was when it is started again with the same folder.")
    parser.add_argument("request", help="a TOML file that names the recordings and says what is known of the drum")
    parser.add_argument("-o", "--output", metavar="FOLDER", default="fit", help="where all is written (default: fit)")
    parser.add_argument("-j", "--jobs", type=int, default=_processors(), help="threads (default: one for each processor)")
    parser.add_argument("--rounds", default="45,40,40", help="simulations of each round (default: 45,40,40)")
    parser.add_argument("--generations", type=int, default=100,
                        help="of the search where rounds do not follow the recording (default: 100; 0: no search)")
    parser.add_argument("--seed", type=int, default=1, help="of all that is drawn (default: 1)")
    parser.add_argument("--json", action="store_true", help="print facts as JSON on standard output")
    parser.add_argument("-q", "--quiet", action="store_true", help="print nothing but errors and warnings")
    return parser.parse_args(given)


def _counts(text: str) -> List[int]:
    counts = [int(one) if one.strip().isdecimal() else 0 for one in text.split(",")]
    if min(counts) < 1:
        raise Error(f"--rounds {text}: allowed: numbers of simulations, separated by commas")
    return counts


def _table(found: Fit) -> str:
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["parameter", "value", "low", "high", "looked for from", "to", "determined", "unit"])
    for one in found.estimates:
        numbers = [f"{number:.5g}" for number in (one.value, one.low, one.high, one.least, one.most)]
        table.writerow([one.key, *numbers, "yes" if one.determined else "no", unit_of(one.key)])
    return text.getvalue()


def _write(path: str, text: str) -> None:
    """The file appears complete, or what was there stays."""
    with open(f"{path}.part", "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
    os.replace(f"{path}.part", path)


class _Differences(NamedTuple):
    """Between the drum that was found and the recordings."""

    fitted: List[StrokeDifference]
    predicted: List[StrokeDifference]
    partials: List[PartialDifference]


def _compare(found: Fit, model: Model) -> _Differences:
    request = found.request
    hardest = (request.strokes[-1], found.speeds[-1]) if request.are_levels_known else None
    kept = [best_speed(model, request.mics, stroke, hardest) for stroke in request.kept]
    return _Differences(stroke_differences(model, request.mics, request.strokes, found.speeds),
                        stroke_differences(model, request.mics, request.kept, kept),
                        partial_differences(model, request.mics, request.strokes, found.speeds))


def _doubt(objective: float, partials: Sequence[PartialDifference]) -> str:
    """A line where the drum that was found is none of the recordings, empty elsewhere."""
    lacking = [f"{one.frequency:.0f}" for one in partials if math.isnan(one.cents) and one.level > _LOUD]
    if not lacking and objective <= _FAR:
        return ""
    said = f"lacks the partials at {', '.join(lacking)} Hz" if lacking else "is far from the recordings"
    return f"The model {said}: are size and heads right, and is it one drum alone that sounds?"


def _print_text(found: Fit, differences: _Differences, files: Sequence[str]) -> None:
    for one in found.estimates:
        print(f"{one.key:40s} {one.value:10.4g}   {one.low:.4g} to {one.high:.4g} {unit_of(one.key)}"
              f"{'' if one.determined else '   not determined'}")
    print("Third octaves beside the recording, root mean square [dB]: 0-50 ms, 50-200 ms")
    for strokes, kind in ((differences.fitted, "fitted"), (differences.predicted, "predicted")):
        for stroke in strokes:
            print(f"  {stroke.early:5.1f} {stroke.late:5.1f}  {kind} at {stroke.speed:.2f} m/s: {stroke.name}")
    print("Partials of the recording [Hz], the model's beside them [cents], ratio of decay rates")
    for partial in differences.partials:
        print(f"  {partial.frequency:7.1f} {partial.cents:+6.0f} {partial.decay_ratio:6.2f}")
    has_wires = bool(found.definition["wires.count"])
    if doubt := _doubt(found.objective, [] if has_wires else differences.partials):  # wires rattle at all frequencies
        print(doubt)
    print(f"Objective: {found.objective:.2f} (1: as far from the recordings as strokes of the same dynamics are from each other)")
    print(f"Written: {', '.join(files)}")


def _rows(some: Iterable[Any]) -> List[Dict[str, Any]]:
    """Named tuples for JSON, which has no NaN."""
    return [{key: None if value != value else value for key, value in one._asdict().items()} for one in some]


def _print_json(found: Fit, differences: _Differences, files: Sequence[str]) -> None:
    print(json.dumps({"name": found.request.name, "objective": found.objective, "surprise": found.surprise,
                      "parameters": _rows(found.estimates), "fitted": _rows(differences.fitted),
                      "predicted": _rows(differences.predicted), "partials": _rows(differences.partials), "files": list(files)}))


def _read(arguments: argparse.Namespace) -> Tuple[Request, Settings]:
    counts = _counts(arguments.rounds)
    if arguments.jobs < 1:
        raise Error(f"--jobs {arguments.jobs}: allowed: 1 or more")
    if arguments.generations < 0:
        raise Error(f"--generations {arguments.generations}: allowed: 0 or more")
    settings = Settings(tuple(counts), arguments.generations, arguments.jobs, arguments.seed)
    return read_request(arguments.request), settings


def _run(arguments: argparse.Namespace, request: Request, settings: Settings) -> None:
    say = (lambda text: None) if arguments.quiet else (lambda text: print(text, file=sys.stderr, flush=True))
    found = fit(request, arguments.output, settings, say)
    files = [os.path.join(arguments.output, name) for name in (f"{request.name}.ini", "parameters.csv", "report.html")]
    model = Model(found.definition, request.rate, "live")
    differences = _compare(found, model)
    report = make_report(found, model, *differences)
    found.definition.save(files[0])
    _write(files[1], _table(found))
    _write(files[2], report)
    if arguments.json:
        _print_json(found, differences, files)
    elif not arguments.quiet:
        _print_text(found, differences, files)


def main(given: Optional[List[str]] = None) -> int:
    """Runs the command.

    Parameters
    ----------
    given : list of str, optional
        Its arguments; those of the process unless given.

    Returns
    -------
    int
        The exit status: 0; 2 if the request is wrong, 1 after another error, which is said in a line.
    """
    arguments = _arguments(given)
    status = 2
    try:
        request, settings = _read(arguments)
        status = 1
        _run(arguments, request, settings)
    except (Error, OSError) as wrong:
        print(f"tabor.fit: {wrong}", file=sys.stderr)
        return status
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
