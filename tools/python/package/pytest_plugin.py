"""A plugin of pytest: pictures of meshes that are to stay what they are, one line each.

    def test_part(aomd_picture):
        aomd_picture.check(aomd.read("part.ply"), "part")

The baseline is `baselines/part.png` beside the test. `pytest --aomd-update` makes those that are
missing or that the pictures are not any more. Where pip has installed aomd, pytest finds this by
itself; else `pytest -p aomd.pytest_plugin`, or `pytest_plugins = ["aomd.pytest_plugin"]` in
conftest.py.
"""

from __future__ import annotations

import inspect
import pathlib

import numpy as np
import pytest

import aomd

#: What `judge_pictures` takes; all else that `check` is given is for `render`.
_LIMITS = {name for name, parameter in inspect.signature(aomd.judge_pictures).parameters.items()
           if parameter.kind is parameter.KEYWORD_ONLY}


class Pictures:
    """The baselines of one file of tests."""

    def __init__(self, folder: pathlib.Path, results: pathlib.Path, update: bool):
        """Baselines are in `folder`; pictures that are not as theirs go to `results`."""
        self._folder, self._results, self._update = folder, results, update

    def check(self, mesh: aomd.Mesh | np.ndarray, name: str, **options) -> None:
        """Fails unless a mesh looks as its baseline says, NAME.png.

        mesh: or a picture of shape (height, width, 4). Options are those of `aomd.render`, such as
        size, camera and color, and the limits of `aomd.judge_pictures`. What fails leaves
        NAME.result.png and NAME.diff.png in the temporary folder of the test.
        """
        limits = {key: options.pop(key) for key in _LIMITS & options.keys()}
        drawn = aomd.render(mesh, **options) if isinstance(mesh, aomd.Mesh) else mesh
        self._hold(drawn, self._folder / f"{name}.png", limits)

    def _hold(self, drawn: np.ndarray, baseline: pathlib.Path, limits: dict) -> None:
        if baseline.exists():
            old = aomd.read_png(baseline)
            verdict = aomd.judge_pictures(old, drawn, **limits)
            if verdict["same"]:
                return
            if not self._update:
                pytest.fail(f"{baseline}: {verdict['why']}: {self._kept(old, drawn, baseline)}",
                            pytrace=False)
        elif not self._update:
            pytest.fail(f"{baseline}: there is no such baseline: pytest --aomd-update makes it",
                        pytrace=False)
        baseline.parent.mkdir(parents=True, exist_ok=True)
        aomd.write_png(baseline, drawn)

    def _kept(self, old: np.ndarray, drawn: np.ndarray, baseline: pathlib.Path) -> str:
        """What came instead, and where: files for people."""
        result = self._results / f"{baseline.stem}.result.png"
        difference = self._results / f"{baseline.stem}.diff.png"
        result.parent.mkdir(parents=True, exist_ok=True)
        aomd.write_png(result, drawn)
        aomd.write_png(difference, aomd.difference_picture(old, drawn))
        return f"{result}, {difference.name}"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Adds --aomd-update."""
    parser.getgroup("aomd").addoption(
        "--aomd-update", action="store_true",
        help="make the baselines of pictures that are missing or not what they were")


@pytest.fixture
def aomd_picture(request: pytest.FixtureRequest, tmp_path: pathlib.Path) -> Pictures:
    """Holds pictures of meshes to their baselines: aomd_picture.check(mesh, "name")."""
    return Pictures(request.path.parent / "baselines", tmp_path,
                    request.config.getoption("--aomd-update"))
