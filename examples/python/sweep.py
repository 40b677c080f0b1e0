# SPDX-License-Identifier: MIT
"""A study of parameters, or a library of sounds, computed by a Dask cluster.

    python sweep.py snare-14x5.5 --vary batter.tension=3000:6000:7 --vary velocity=1,4 -o study/
    python sweep.py tom-12 --vary midi=1,64,127 --vary radius=0%,40%,80% --takes 4 -o tom/

Every combination of the values is a job: a definition, a stroke, and a seed. What a job is decides what it
is called, FOLDER/HASH.wav, so nothing is computed twice, and a sweep that was ended goes on where it was. A
job whose worker dies is done again by another. FOLDER/index.csv says what the files are; it comes last.

Without --scheduler the workers are processes of this machine. The workers of any other cluster need the
program `tabor` and nothing else: sounds come back through Dask, no folder has to be shared.
"""

from __future__ import annotations

import argparse
import contextlib
import csv
import hashlib
import io
import itertools
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple, Sequence, Tuple

import dask
from distributed import Client, LocalCluster, as_completed, get_worker
from distributed.scheduler import KilledWorker

STROKE_FIELDS = ("velocity", "midi", "radius", "angle", "striker")

Job = Dict[str, Any]  # plain data, so that it has a hash and travels


class Refused(Exception):
    """A wrong request: to be said, not to be tried again."""


class Variation(NamedTuple):
    """A parameter or a field of the stroke, and the values it takes."""

    key: str
    values: Tuple[str, ...]


# ---- what there is to do ----


def variation(text: str) -> Variation:
    """Reads KEY=VALUE,VALUE,... or KEY=FIRST:LAST:COUNT, which is evenly spaced."""
    key, equals, values = text.partition("=")
    if not equals or not values or ("." not in key and key not in STROKE_FIELDS):
        raise argparse.ArgumentTypeError(
            f"'{text}': allowed: KEY=VALUES, KEY a parameter or one of {', '.join(STROKE_FIELDS)}")
    if values.count(":") != 2:
        return Variation(key, tuple(values.split(",")))
    try:
        first, last, count = (convert(part) for convert, part in zip((float, float, int), values.split(":")))
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"'{text}': {error}") from error
    if count < 2:
        raise argparse.ArgumentTypeError(f"'{text}': a count of at least 2")
    return Variation(key, tuple(f"{first + (last - first) * i / (count - 1):.12g}" for i in range(count)))


def make_jobs(options: argparse.Namespace, version: str) -> List[Job]:
    """Every combination of the varied values, take by take."""
    preset = options.preset
    is_file = "/" in preset or preset.endswith(".ini")
    common = {
        "version": version,
        "preset": None if is_file else preset,
        "text": Path(preset).read_text(encoding="utf-8") if is_file else None,
        "options": [f"--{name}={value}" for name, value in (
            ("quality", options.quality), ("rate", options.rate), ("duration", options.duration),
            ("format", options.format), ("humanize", options.humanize)) if value is not None]
        + [f"--mic={name}" for name in options.mic],
    }
    combinations = itertools.product(*([(row.key, value) for value in row.values] for row in options.vary))
    return [dict(common, values=dict(values), seed=options.seed + take)
            for values in combinations for take in range(options.takes)]


def name_of(job: Job) -> str:
    """What a job is called: a hash of all that it consists of."""
    return hashlib.sha256(json.dumps(job, sort_keys=True).encode()).hexdigest()[:24]


# ---- on a worker ----


def said(program: str, *arguments: str) -> str:
    """Standard output of the program, or an exception with what it says."""
    run = subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                         stdin=subprocess.DEVNULL, encoding="utf-8", errors="replace")
    if run.returncode == 2:
        raise Refused(run.stderr.strip())
    if run.returncode != 0:
        raise RuntimeError(f"{program} ended with status {run.returncode}: {run.stderr.strip()}")
    return run.stdout


def perform(job: Job, program: str) -> Tuple[str, bytes]:
    """Renders a job: what was refused, or "", and the bytes of the sound file."""
    with tempfile.TemporaryDirectory(dir=get_worker().local_directory) as folder:  # goes with the worker
        preset = job["preset"]
        if preset is None:
            preset = os.path.join(folder, "drum.ini")
            Path(preset).write_text(job["text"], encoding="utf-8")
        settings = [f"--set={key}={value}" for key, value in job["values"].items() if "." in key]
        fields = [f"{key}={value}" for key, value in job["values"].items() if "." not in key]
        sound = os.path.join(folder, "sound.wav")
        try:
            version = json.loads(said(program, "--version", "--json"))["version"]
            if version != job["version"]:
                raise Refused(f"a worker has tabor {version}, not {job['version']}")
            said(program, "render", preset, "-q", "-o", sound, *job["options"], *settings,
                 f"--seed={job['seed']}", *([f"--strike={','.join(fields)}"] if fields else []))
        except Refused as refusal:
            return str(refusal), b""
        return "", Path(sound).read_bytes()


# ---- here ----


def write(path: Path, content: bytes) -> None:
    """The file appears complete or not at all."""
    with tempfile.NamedTemporaryFile(dir=path.parent, prefix=".tabor-", delete=False) as file:
        try:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
            os.chmod(file.name, 0o666 & ~umask())
            os.replace(file.name, path)
        except BaseException:
            os.unlink(file.name)
            raise


def umask() -> int:
    """What new files may not have, which can be read by changing it only."""
    mask = os.umask(0)
    os.umask(mask)
    return mask


def results(client: Client, jobs: Dict[str, Job], options: argparse.Namespace) -> Iterator[Tuple[str, bytes]]:
    """Name and sound of every job, in the order in which they are finished."""
    futures = [client.submit(perform, job, options.program, key=f"tabor-{name}", retries=options.retries)
               for name, job in jobs.items()]
    for future in as_completed(futures):
        refusal, sound = future.result()
        if refusal:
            client.cancel(futures)
            raise Refused(refusal)
        name = future.key[len("tabor-"):]
        future.release()
        yield name, sound


def compute(client: Client, jobs: Dict[str, Job], options: argparse.Namespace) -> None:
    """Does the jobs and writes their sounds."""
    start = time.monotonic()
    for done, (name, sound) in enumerate(results(client, jobs, options), 1):
        write(options.output / f"{name}.wav", sound)
        if sys.stderr.isatty():
            left = (time.monotonic() - start) / done * (len(jobs) - done)
            print(f"\r{done} of {len(jobs)} done - about {left:.0f} s left ", end="", file=sys.stderr)
    workers = len(client.scheduler_info()["workers"])
    print(f"{len(jobs)} jobs in {time.monotonic() - start:.2f} s, {workers} workers at the end",
          file=sys.stderr)


@contextlib.contextmanager
def connect(options: argparse.Namespace) -> Iterator[Client]:
    """A client of the cluster that is named, or of one on this machine, whose workers leave nothing behind."""
    with contextlib.ExitStack() as stack:
        cluster = options.scheduler
        if not cluster:
            folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="tabor-"))
            stack.enter_context(dask.config.set({"distributed.scheduler.allowed-failures": options.retries,
                                                 "temporary-directory": folder}))
            cluster = stack.enter_context(LocalCluster(
                n_workers=options.workers, threads_per_worker=1, host="127.0.0.1", dashboard_address=None))
        yield stack.enter_context(Client(cluster))


def index(jobs: Dict[str, Job], vary: Sequence[Variation]) -> bytes:
    """What the files are: a row a job."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["file", *(row.key for row in vary), "seed"])
    for name, job in jobs.items():
        table.writerow([f"{name}.wav", *job["values"].values(), job["seed"]])
    return text.getvalue().encode()


def read_options(arguments: Sequence[str]) -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("preset", help="a drum of the program's, or a file")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FOLDER")
    parser.add_argument("--vary", type=variation, action="append", required=True, metavar="KEY=VALUES",
                        help="a parameter, or velocity, midi, radius, angle or striker of the stroke; "
                        "VALUES as 1,2,5 or FIRST:LAST:COUNT (repeatable)")
    parser.add_argument("--takes", type=int, default=1, help="of each, with seeds of their own (%(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="of the first take (%(default)s)")
    parser.add_argument("--humanize", type=float, help="how much takes differ (0.3 if there are several)")
    for name in ("quality", "rate", "duration", "format"):
        parser.add_argument(f"--{name}", help="as of 'tabor render'")
    parser.add_argument("--mic", action="append", default=[], help="as of 'tabor render'")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a cluster, as tcp://host:8786")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="here, without --scheduler")
    parser.add_argument("--retries", type=int, default=3, help="of a job that fails (%(default)s)")
    parser.add_argument("--program", default="tabor", help="what the workers call (%(default)s)")
    options = parser.parse_args(arguments)
    for name in ("takes", "workers"):
        if getattr(options, name) < 1:
            parser.error(f"--{name} {getattr(options, name)}: allowed: 1 or more")
    if len({row.key for row in options.vary}) < len(options.vary):
        parser.error("--vary: a key is given twice")
    if options.takes > 1 and options.humanize is None:
        options.humanize = 0.3
    return options


def terminate(number: int, frame: object) -> None:
    """A termination ends the workers and removes their folders, as an interrupt does."""
    sys.exit(128 + number)


def main() -> int:
    """Does what of the sweep is not there yet."""
    options = read_options(sys.argv[1:])
    signal.signal(signal.SIGTERM, terminate)
    try:
        version = json.loads(said(options.program, "--version", "--json"))["version"]
        jobs = {name_of(job): job for job in make_jobs(options, version)}
        options.output.mkdir(exist_ok=True)
        missing = {name: job for name, job in jobs.items() if not (options.output / f"{name}.wav").exists()}
        if missing:
            with connect(options) as client:
                compute(client, missing, options)
        write(options.output / "index.csv", index(jobs, options.vary))
    except Refused as refusal:
        print(refusal, file=sys.stderr)
        return 2
    except (OSError, RuntimeError, UnicodeDecodeError, KilledWorker) as error:
        print(f"sweep.py: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
