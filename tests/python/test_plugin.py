"""The plugin of pytest, run by a pytest of its own."""

import os
import pathlib
import subprocess
import sys

import pytest

import aomd

CHECKS = """
import aomd
import pytest

BALL = aomd.sample("sphere")


def test_ball(aomd_picture):
    aomd_picture.check(BALL, "ball", size=(80, 60), color={color!r})


def test_array(aomd_picture):
    aomd_picture.check(aomd.render(BALL, size=(80, 60)), "of/an/array", threshold=1)
"""


@pytest.fixture
def run(tmp_path):
    """Runs pytest on the checks above, in a folder of its own."""

    def once(*options, color="classification"):
        (tmp_path / "test_it.py").write_text(CHECKS.format(color=color))
        return subprocess.run(
            [sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider", "-p",
             "aomd.pytest_plugin", "-q", "--rootdir", tmp_path, "--basetemp", tmp_path / "left",
             tmp_path / "test_it.py", *options],
            capture_output=True, text=True, env={**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"})

    once.folder = tmp_path
    return once


def made(run):
    baselines = run.folder / "baselines"
    return sorted(str(path.relative_to(baselines)) for path in baselines.rglob("*.png"))


def test_baselines_are_made_where_that_is_asked_for(run):
    first = run()
    assert first.returncode == 1 and "2 failed" in first.stdout
    assert "there is no such baseline: pytest --aomd-update makes it" in first.stdout
    assert made(run) == []
    assert run("--aomd-update").returncode == 0
    assert made(run) == ["ball.png", "of/an/array.png"]
    assert run().returncode == 0


def test_another_picture_fails_and_leaves_what_came_instead(run):
    run("--aomd-update")
    before = (run.folder / "baselines/ball.png").read_bytes()
    again = run(color="quality")
    assert again.returncode == 1 and "1 failed, 1 passed" in again.stdout
    expected = aomd.judge_pictures(aomd.read_png(run.folder / "baselines/ball.png"),
                                   aomd.render(aomd.sample("sphere"), size=(80, 60),
                                               color="quality"))
    assert f"baselines/ball.png: {expected['why']}: " in again.stdout
    left = {path.name: path for path in pathlib.Path(run.folder / "left").rglob("*.png")}
    assert sorted(left) == ["ball.diff.png", "ball.result.png"]
    assert aomd.read_png(left["ball.result.png"]).shape == (60, 80, 4)
    assert (run.folder / "baselines/ball.png").read_bytes() == before
    assert run("--aomd-update", color="quality").returncode == 0
    assert run(color="quality").returncode == 0
