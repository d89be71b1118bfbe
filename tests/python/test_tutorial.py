"""The code of docs/PYTHON.md runs, from its first line to its last, and makes its picture."""

import pathlib
import re

from aomd.pytest_plugin import Pictures

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "PYTHON.md"


def run(text):
    """What the names of the page stand for in the end."""
    found = re.finditer(r"```python\n(.*?)```", text, re.S)
    blocks = [(match.start(), match.group(1)) for match in found]
    assert len(blocks) >= 8
    names = {}
    for start, code in blocks:
        line = text[:start].count("\n") + 1
        exec(compile("\n" * line + code, str(PAGE), "exec"), names)
    return names


def test_the_tutorial_runs_and_makes_its_picture(tmp_path, monkeypatch, request):
    monkeypatch.chdir(tmp_path)
    text = PAGE.read_text()
    names = run(text)
    update = request.config.getoption("--aomd-update", default=False)
    for shown in re.findall(r"!\[.*?\]\(pictures/(\w+)\.png\)", text, re.S):
        Pictures(PAGE.parent / "pictures", tmp_path, update).check(names[shown], shown)
