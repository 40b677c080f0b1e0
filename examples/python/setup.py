# SPDX-License-Identifier: MIT
"""What pyproject.toml cannot say: tabor/_header.py is made from tabor.h."""

from setuptools import setup

setup(cffi_modules=["build_header.py:builder"])
