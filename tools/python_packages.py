# SPDX-License-Identifier: MIT
"""Packages that Python does not bring along. They are imported when they are first used, so that --help needs none."""
import importlib
import importlib.util
import sys

DEBIAN = {"numpy": "python3-numpy", "scipy": "python3-scipy", "matplotlib": "python3-matplotlib",
          "soundfile": "python3-soundfile", "cmaes": "python3-cmaes", "threadpoolctl": "python3-threadpoolctl"}


class Module:
    """Stands for the module of that name, and imports it once something of it is asked for."""

    def __init__(self, name):
        self._name = name

    def __getattr__(self, attribute):
        return getattr(importlib.import_module(self._name), attribute)


def require(tool, *packages):
    """Ends the tool, and names what is missing, unless all of these are installed."""
    missing = [package for package in packages if importlib.util.find_spec(package) is None]
    if missing:
        sys.exit(f"{tool}: {sys.executable} has no {' and no '.join(missing)}; on Debian and Ubuntu: apt install "
                 f"{' '.join(DEBIAN[package] for package in missing)}, and start it with /usr/bin/python3")
