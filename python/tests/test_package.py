# SPDX-License-Identifier: MIT
"""The package as a whole: what it describes is what the library has."""

import doctest
import inspect
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import tabor
from tabor import _library

ENGINE = Path(__file__).resolve().parents[2] / "engine/include"
FUNCTIONS = sorted(name for name in tabor.__all__ if inspect.isfunction(getattr(tabor, name)))
CLASSES = sorted(name for name in tabor.__all__ if inspect.isclass(getattr(tabor, name)))
METHODS = sorted(f"{owner}.{name}" for owner in CLASSES for name, method in vars(getattr(tabor, owner)).items()
                 if not name.startswith("_") and inspect.isfunction(method)
                 and method.__module__.startswith("tabor"))


def thing(path):
    found = tabor
    for name in path.split("."):
        found = getattr(found, name)
    return found


@pytest.mark.parametrize("path", FUNCTIONS + METHODS)
def test_functions_are_described_and_typed(path):
    function, described = thing(path), inspect.getdoc(thing(path))
    assert described and "return" in function.__annotations__
    names = [name for name in inspect.signature(function).parameters if name != "self"]
    section = re.search(r"Parameters\n-+\n(.*?)(\n\n[A-Z]\w+\n-+\n|$)", described, re.DOTALL)
    found = re.findall(r"^(\w[\w, ]*) : ", section.group(1), re.MULTILINE) if section else []
    assert [name for group in found for name in group.split(", ")] == names
    if function.__annotations__["return"] not in ("None", None):
        assert re.search(r"Returns\n-+\n\w+", described)


@pytest.mark.parametrize("name", CLASSES)
def test_classes_and_their_properties_are_described(name):
    described = getattr(tabor, name)
    assert inspect.getdoc(described)
    for key, member in vars(described).items() if inspect.isclass(described) else ():
        if isinstance(member, property) and not key.startswith("_"):
            assert inspect.getdoc(member), key


@pytest.mark.parametrize("struct", ["Ledger", "Statistics", "Probe", "ModelInfo", "RoomInfo"])
def test_tuples_have_the_fields_of_the_structs(struct):
    members = [name for name, _ in _library.ffi.typeof(f"Tabor{struct}").fields]
    assert list(getattr(tabor, struct)._fields) == members


def test_every_kind_of_event_has_a_function():
    from tabor.events import TYPES
    enumerators = _library.ffi.typeof("TaborEventType").elements
    kinds = [kind for kind in TYPES if kind != "pluck"]  # a stroke of its own technique
    assert sorted(TYPES[kind] for kind in kinds) == sorted(enumerators)
    assert set(TYPES) <= set(tabor.__all__)


def test_names_are_those_of_the_library():
    from tabor import model, room
    for words, enum in (((*tabor.TECHNIQUES, "pluck"), "TaborTechnique"), (model._PARTS, "TaborModePart"),
                        (room._KINDS, "TaborRoomKind"), (model._LEVELS[1:], "TaborQuality")):
        said = [name.split("_", 2)[2].lower().replace("_", "-")
                for _, name in sorted(_library.ffi.typeof(enum).elements.items())]
        assert [name for name in said if name != "default"] == list(words)


def test_structs_are_laid_out_as_the_compiler_does(tmp_path):
    """cffi computes sizes and offsets by itself; a C compiler says whether they are right."""
    compiler = shutil.which(os.environ.get("CC", "cc"))
    if not compiler or not ENGINE.exists():
        pytest.skip("there is no C compiler, or no tabor.h")
    ffi = _library.ffi
    lines = ["#include <tabor/tabor.h>", "#include <assert.h>", "#include <stddef.h>"]
    for name in re.findall(r"^typedef struct (\w+) \{", (ENGINE / "tabor/tabor.h").read_text(), re.MULTILINE):
        kind = ffi.typeof(name)
        lines.append(f'static_assert(sizeof({name}) == {ffi.sizeof(name)}, "{name}");')
        lines += [f'static_assert(offsetof({name}, {member}) == {field.offset}, "{name}.{member}");'
                  for member, field in kind.fields]
    assert len(lines) > 200
    source = tmp_path / "layout.c"
    source.write_text("\n".join(lines) + "\n")
    run = subprocess.run([compiler, "-std=c11", "-fsyntax-only", f"-I{ENGINE}", str(source)],
                         stderr=subprocess.PIPE, check=False)
    assert run.returncode == 0, run.stderr.decode()


@pytest.mark.parametrize("module", ["definition", "drum", "rendering", "kit"])
def test_examples_of_docstrings_run(module):
    failed, tried = doctest.testmod(getattr(__import__(f"tabor.{module}"), module), extraglobs={"tabor": tabor})
    assert failed == 0 < tried


def test_versions(program):
    assert program("--version").decode().split()[1] == tabor.__version__ == tabor.version()


def test_a_missing_library_is_an_import_error():
    run = subprocess.run([sys.executable, "-c", "import tabor"], env={**os.environ, "TABOR_LIBRARY": "/none.so"},
                         stderr=subprocess.PIPE, check=False)
    last = run.stderr.decode().strip().splitlines()[-1]
    assert last.startswith("ImportError: the library of the package tabor cannot be opened: ")
    assert "/none.so" in last
