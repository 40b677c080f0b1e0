# SPDX-License-Identifier: MIT
"""What the tests share. With the environment variable TABOR, a path of the program, sounds are compared with its."""

import os
import subprocess
from typing import Callable

import numpy as np
import pytest

import tabor


@pytest.fixture(scope="session")
def program() -> Callable[..., bytes]:
    """Runs the program; gives what it writes to standard output."""
    path = os.environ.get("TABOR")
    if not path:
        pytest.skip("TABOR does not name the program")

    def run(*arguments: str) -> bytes:
        return subprocess.run([path, *arguments], stdout=subprocess.PIPE, check=True).stdout
    return run


@pytest.fixture(scope="session")
def program_sound(program):
    """What `tabor render` renders, [microphone, frame]: AU has a header of its own length and big numbers first."""
    def render(*arguments: str, channels: int = 1) -> np.ndarray:
        said = program("render", *arguments, "--format", "float", "-q", "-o", "-")
        start = int.from_bytes(said[4:8], "big")
        return np.frombuffer(said[start:], ">f4").reshape(-1, channels).T
    return render


@pytest.fixture(scope="session")
def snare() -> tabor.Model:
    """The drum of the founding paper, which is quick."""
    return tabor.Model("tabor", quality="draft")
