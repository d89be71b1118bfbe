"""The code of docs/PYTHON.md runs, from its first line to its last."""

import pathlib
import re

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "PYTHON.md"


def test_the_tutorial_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = PAGE.read_text()
    found = re.finditer(r"```python\n(.*?)```", text, re.S)
    blocks = [(match.start(), match.group(1)) for match in found]
    assert len(blocks) >= 8
    names = {}
    for start, code in blocks:
        line = text[:start].count("\n") + 1
        exec(compile("\n" * line + code, str(PAGE), "exec"), names)
