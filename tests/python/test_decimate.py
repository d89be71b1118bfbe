"""decimate() does what `aomd decimate` does."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import aomd


def by_program(tmp_path, mesh, *options):
    """The bytes that the program makes of the mesh."""
    mesh.write(tmp_path / "in.ply")
    subprocess.run([os.environ["AOMD_PROGRAM"], "decimate", tmp_path / "in.ply",
                    tmp_path / "out.ply", "--quiet", *options], check=True)
    return (tmp_path / "out.ply").read_bytes()


@pytest.mark.parametrize("sample, options, words", [
    ("sphere", {"target_faces": 300}, ["--target-faces", "300"]),
    ("sphere", {"target_faces": "20%", "regularity": 0.2, "no_swap": True},
     ["--target-faces", "20%", "--regularity", "0.2", "--no-swap"]),
    ("bracket", {"strategy": "paper", "factor": 3, "angle": 20},
     ["--strategy", "paper", "--factor", "3", "--angle", "20"]),
    ("sphere", {"spacing": "x < 0 ? 2 * h : 5 * h", "gradation": 0.5},
     ["--spacing", "x < 0 ? 2 * h : 5 * h", "--gradation", "0.5"]),
    ("sphere", {"target_faces": 300, "without": ["placement", "facing"], "max_distance": 1},
     ["--target-faces", "300", "--without", "placement,facing", "--max-distance", "1"]),
])
def test_the_same_bytes_as_the_program(tmp_path, sample, options, words):
    mesh = aomd.sample(sample)
    assert aomd.decimate(mesh, **options).mesh.to_bytes("ply") == by_program(tmp_path, mesh, *words)


def test_the_same_bytes_of_a_volume_with_arrays(tmp_path):
    mesh = aomd.sample("layered-beam")
    mesh.write(tmp_path / "in.vtu")
    subprocess.run([os.environ["AOMD_PROGRAM"], "decimate", tmp_path / "in.vtu",
                    tmp_path / "out.vtu", "--target-tets", "50%", "--quiet"], check=True)
    result = aomd.decimate(aomd.read(tmp_path / "in.vtu"), target_tets="50%")
    assert result.mesh.to_bytes("vtu") == (tmp_path / "out.vtu").read_bytes()
    assert set(result.mesh.attributes()) == set(mesh.attributes())


def test_the_input_stays_as_it_is():
    mesh = aomd.sample("sphere")
    before = mesh.vertices.copy()
    aomd.decimate(mesh, target_faces=100)
    np.testing.assert_array_equal(mesh.vertices, before)
    assert mesh == aomd.sample("sphere")


def test_the_report_and_the_notes():
    result = aomd.decimate(aomd.sample("sphere"), target_faces=300)
    assert result.report["schema"] == 1
    assert result.report["output"]["faces"] == len(result.mesh.faces) == 300
    assert result.report["options"]["target_faces"] == 300
    assert not result.missed and result.notes == []


def test_a_target_that_is_missed():
    mesh = aomd.sample("bracket")
    everything = np.arange(mesh.count("vertices"))
    result = aomd.decimate(mesh, target_faces=10, keep=everything)
    assert result.missed and result.mesh.count("faces") == mesh.count("faces")
    assert result.missed in result.notes and result.mesh.notes == result.notes
    with pytest.raises(aomd.NothingToDo) as error:
        aomd.decimate(mesh, target_faces=10, keep=everything, strict=True)
    assert str(error.value) == result.missed and error.value.exit_code == 1


def test_vertices_that_stay(tmp_path):
    mesh = aomd.sample("sphere")
    listed = tmp_path / "keep.txt"
    listed.write_text("0-49\n")
    by_array = aomd.decimate(mesh, target_faces=300, keep=np.arange(50))
    assert by_array.mesh == aomd.decimate(mesh, target_faces=300, keep=listed).mesh
    kept = {tuple(v) for v in by_array.mesh.vertices}
    assert all(tuple(v) in kept for v in mesh.vertices[:50])
    assert by_array.report["options"]["keep"] == "array"
    with pytest.raises(aomd.UsageError, match="--keep: there is no vertex -1"):
        aomd.decimate(mesh, keep=[-1])


def test_lengths_of_edges(tmp_path):
    mesh = aomd.sample("sphere")
    wanted = np.where(mesh.vertices[:, 0] < 0, 0.2, 0.5)
    listed = tmp_path / "spacing.txt"
    np.savetxt(listed, wanted, fmt="%.17g")
    result = aomd.decimate(mesh, spacing=wanted)
    assert result.mesh == aomd.decimate(mesh, spacing=str(listed)).mesh
    told = result.report["options"]
    assert told["spacing"] == "array" and told["factor"] is None
    with pytest.raises(aomd.UsageError, match="--spacing: 3 lengths for"):
        aomd.decimate(mesh, spacing=[1.0, 1.0, 1.0])
    with pytest.raises(aomd.UsageError, match="--factor excludes --spacing"):
        aomd.decimate(mesh, spacing=wanted, factor=3)
    with pytest.raises(aomd.UsageError, match="--spacing: vertex 0 has no positive length"):
        aomd.decimate(mesh, spacing=-wanted)


def test_what_goes_into_files(tmp_path):
    mesh = aomd.sample("sphere")
    aomd.decimate(mesh, target_faces=300, report=tmp_path / "r.json", journal=tmp_path / "j.aomdj")
    assert (tmp_path / "r.json").stat().st_size > 0
    mesh.write(tmp_path / "in.ply")
    subprocess.run([os.environ["AOMD_PROGRAM"], "replay", tmp_path / "in.ply", tmp_path / "j.aomdj",
                    tmp_path / "out.ply"], check=True, capture_output=True)
    with pytest.raises(aomd.WriteError):
        aomd.decimate(mesh, report=tmp_path / "none" / "r.json")


def test_progress_is_told():
    phases = []
    aomd.decimate(aomd.sample("sphere"), target_faces=300,
                  progress=lambda phase, done: phases.append((phase, done)))
    assert ("classifying", None) in phases and ("checking", None) in phases
    assert all(done is None or 0 <= done <= 1 for _, done in phases)


def test_progress_may_cancel():
    with pytest.raises(aomd.Cancelled, match="cancelled; nothing was written") as error:
        aomd.decimate(aomd.sample("sphere"), progress=lambda phase, done: phase != "checking")
    assert error.value.exit_code == 130


def test_what_progress_raises_comes_out():
    def fail(phase, done):
        raise KeyError(phase)
    with pytest.raises(KeyError):
        aomd.decimate(aomd.sample("sphere"), progress=fail)


def test_control_c_ends_it(tmp_path):
    """A signal that comes while nothing of Python runs: the report is what the end would write."""
    def interrupt(number, frame):
        raise KeyboardInterrupt
    ball = aomd.sample("sphere", 100)
    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(KeyboardInterrupt):
            aomd.decimate(ball, target_faces=100, report=tmp_path / "r.json")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert not (tmp_path / "r.json").exists()


def test_other_threads_run_meanwhile():
    """Nothing but a call that lets go of the lock gives the other thread a turn."""
    turns, finished = [], threading.Event()

    def other():
        while not finished.is_set():
            turns.append(None)
            time.sleep(0)

    interval = sys.getswitchinterval()
    thread = threading.Thread(target=other)
    thread.start()
    sys.setswitchinterval(1000)
    ball, taken = aomd.sample("sphere"), 0
    for _ in range(20):
        before = len(turns)
        aomd.decimate(ball, target_faces=100)
        taken += len(turns) - before
    sys.setswitchinterval(interval)
    finished.set()
    thread.join()
    assert taken > 0


def test_what_cannot_be_decimated():
    quad = aomd.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    with pytest.raises(aomd.LimitError, match="mesh: ") as error:
        aomd.decimate(quad)
    assert error.value.exit_code == 5
    assert aomd.decimate(quad, triangulate=True).mesh.count("faces") == 2
