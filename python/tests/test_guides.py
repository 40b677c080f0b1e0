# SPDX-License-Identifier: MIT
"""The Python in the guides runs, and gives the shapes and numbers that its comments say."""

import ast
import re
from pathlib import Path

import pytest

import tabor
import tabor.model

TOP = Path(__file__).resolve().parents[2]
GUIDES = [TOP / name for name in ("docs/python.md", "python/README.md")]
SAID = re.compile(r"^(\w.*?) +# (\([\d, ]+\)|\d+)(:|$)")  # a line such as `sound.shape   # (1, 48000): what they are`


@pytest.mark.parametrize("guide", GUIDES, ids=lambda guide: str(guide.relative_to(TOP)))
def test_a_guide_is_right(guide, monkeypatch, tmp_path):
    if not guide.exists():
        pytest.skip(f"there is no {guide}")
    blocks = re.findall(r"^```python\n(.*?)^```", guide.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert blocks
    monkeypatch.setattr(tabor.model, "choice_of", lambda choices, name, what: choices.index("draft"))  # faster
    monkeypatch.chdir(tmp_path)
    Path("mine.ini").write_text(tabor.Definition("tom-12").to_ini(), encoding="utf-8")
    names = {}
    for block in blocks:
        for statement in ast.parse(block).body:
            source = "\n".join(block.splitlines()[statement.lineno - 1:statement.end_lineno])
            said = SAID.match(source)
            if said:
                assert eval(said.group(1), names) == ast.literal_eval(said.group(2)), source
            else:
                exec(source, names)
