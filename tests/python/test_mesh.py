"""Meshes from and to NumPy, and files."""

import gc
import subprocess
import sys

import numpy as np
import pytest

import aomd

TET = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def surface():
    return aomd.Mesh(TET, FACES)


def test_arrays_go_in_and_come_out():
    mesh = surface()
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.uint32
    np.testing.assert_array_equal(mesh.vertices, TET)
    np.testing.assert_array_equal(mesh.faces, FACES)
    assert mesh.regions.shape == (0, 4) and mesh.edges.shape == (0, 2)
    assert [mesh.count(kind) for kind in ("vertices", "edges", "faces", "regions")] == [4, 0, 4, 0]
    assert repr(mesh) == "<aomd.Mesh: 4 vertices, 4 faces>"


def test_arrays_that_come_out_are_no_copies_and_cannot_be_written_to():
    mesh = surface()
    assert mesh.vertices.__array_interface__["data"] == mesh.vertices.__array_interface__["data"]
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[0, 0] = 7
    with pytest.raises(ValueError, match="read-only"):
        mesh.faces[0, 0] = 7


def test_arrays_outlive_their_mesh():
    vertices = surface().vertices
    gc.collect()
    np.testing.assert_array_equal(vertices, TET)


def test_what_goes_in_is_copied():
    given = TET.copy()
    mesh = aomd.Mesh(given, FACES)
    given[:] = 9
    np.testing.assert_array_equal(mesh.vertices, TET)


@pytest.mark.parametrize("kind", [np.int8, np.uint16, np.int32, np.uint32, np.int64, np.uint64])
def test_faces_may_have_any_type_of_whole_numbers(kind):
    assert aomd.Mesh(TET, FACES.astype(kind)) == surface()


def test_arrays_need_not_be_contiguous():
    assert aomd.Mesh(np.asfortranarray(TET), np.asfortranarray(FACES)) == surface()
    assert aomd.Mesh(TET.tolist(), FACES.tolist()) == surface()
    wide = np.zeros((4, 6), dtype=int)
    wide[:, ::2] = FACES
    assert aomd.Mesh(TET, wide[:, ::2]) == surface()
    assert aomd.Mesh(TET[::-1][::-1], FACES[:, ::-1][:, ::-1]) == surface()


@pytest.mark.parametrize("kind", ["f4", ">f8", "f2", "i8", "u1"])
def test_vertices_may_have_any_type_of_numbers(kind):
    assert aomd.Mesh(TET.astype(kind), FACES.astype(">i4")) == surface()


MEASURES = """
import pathlib, re, sys
import numpy as np
import aomd

def memory(line):
    text = pathlib.Path("/proc/self/status").read_text()
    return 1024 * int(re.search(line + r":\\s+(\\d+) kB", text).group(1))

n = 1_000_000
vertices = np.ones((n, 3), sys.argv[1])
faces = np.zeros((n, 3), sys.argv[2])
faces[:] = np.arange(3)
pathlib.Path("/proc/self/clear_refs").write_text("5")  # the peak begins anew
before = memory("VmRSS")
mesh = aomd.Mesh(vertices, faces)
print(memory("VmHWM") - before)
"""


@pytest.mark.parametrize("kinds", [("f8", "u4"), ("f8", "i8"), ("f4", "i4")])
def test_making_a_mesh_takes_one_copy_at_most(kinds):
    """24 MB of coordinates, 12 of faces, 1 of shapes: what Python has of them is not converted."""
    told = subprocess.run([sys.executable, "-c", MEASURES, *kinds], check=True,
                          capture_output=True, text=True).stdout
    assert 36_000_000 < int(told) < 41_000_000


@pytest.mark.parametrize("vertices, faces, words", [
    (TET[:, :2], FACES, r"vertices: must have the shape \(n, 3\), not \(4, 2\)"),
    (TET, FACES + 1, "faces: row 0 names vertex 3 of 4|faces: row 1 names vertex 4 of 4"),
    (TET, FACES - 1, "faces: row 0 names vertex -1 of 4"),
    (TET, FACES * 1.5, "faces: must be whole numbers, not float64"),
    (TET, FACES[0], r"faces: must have the shape \(n, vertices of each\), not \(3,\)"),
    (TET, np.zeros((1, 5), int), "faces: none has 5 vertices"),
    (np.where(TET == 1, np.nan, TET), FACES, "vertices: vertex 1 is not finite"),
])
def test_what_is_no_mesh_is_refused(vertices, faces, words):
    with pytest.raises(ValueError, match=words):
        aomd.Mesh(vertices, faces)


def test_a_volume_and_its_shapes():
    mesh = aomd.sample("layered-beam", 2)
    assert mesh.regions.shape[1] == 4
    assert aomd.Mesh(mesh.vertices, regions=mesh.regions).count("regions") == mesh.count("regions")
    assert set(mesh.by_shape("regions")) == {"tetrahedron"}


def test_several_shapes():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], dtype=float)
    mesh = aomd.Mesh(square, [np.array([[0, 1, 2, 3]]), np.array([[1, 4, 2]])])
    with pytest.raises(ValueError, match="faces are of several shapes"):
        mesh.faces
    shapes = mesh.by_shape()
    np.testing.assert_array_equal(shapes["quad"], [[0, 1, 2, 3]])
    np.testing.assert_array_equal(shapes["triangle"], [[1, 4, 2]])


def test_classes():
    mesh = aomd.Mesh(TET, FACES, classes={"faces": np.array([1, 1, 2, 2]),
                                          "vertices": [[0, 5], [1, 6], [-1, 0], [2, 1]]})
    np.testing.assert_array_equal(mesh.classes("faces"), [[2, 1], [2, 1], [2, 2], [2, 2]])
    np.testing.assert_array_equal(mesh.classes("vertices"), [[0, 5], [1, 6], [-1, 0], [2, 1]])
    assert mesh.classes("edges") is None
    with pytest.raises(ValueError, match=r"must have the shape \(4,\) or \(4, 2\), not \(3,\)"):
        aomd.Mesh(TET, FACES, classes={"faces": [1, 2, 3]})
    with pytest.raises(ValueError, match="row 1 is no model entity: 4, 0"):
        aomd.Mesh(TET, FACES, classes={"faces": [[2, 1], [4, 0], [2, 1], [2, 1]]})
    with pytest.raises(ValueError, match="must be vertices, edges, faces or regions"):
        aomd.Mesh(TET, FACES, classes={"cells": [1]})


def test_attributes():
    mesh = surface().with_attribute("heat", [0.5, 1, 2, 4])
    np.testing.assert_array_equal(mesh.attributes()["heat"], [0.5, 1, 2, 4])
    mesh = mesh.with_attribute("flow", np.arange(12.0).reshape(4, 3))
    mesh = mesh.with_attribute("heat", [1, 2, 3, 4])
    assert mesh.attributes()["heat"].dtype == np.int64
    assert mesh.attributes()["flow"].shape == (4, 3)
    mesh = mesh.with_attribute("mark", [1, 0, 0, 1], "faces").without_attribute("heat")
    assert set(mesh.attributes()) == {"flow"} and set(mesh.attributes("faces")) == {"mark"}
    textured = mesh.with_attribute("uv", np.zeros((12, 2)), "corners")
    assert textured.attributes("corners")["uv"].shape == (12, 2) and not mesh.attributes("corners")
    with pytest.raises(ValueError, match="must be numbers of the shape"):
        mesh.with_attribute("heat", [1.0, 2.0])


def test_files(tmp_path):
    mesh = surface().with_attribute("heat", [0.5, 1.25, 2, 4])
    assert mesh.write(tmp_path / "a.vtu") == []
    back = aomd.read(tmp_path / "a.vtu")
    assert back == mesh and back.notes == []
    assert aomd.Mesh.from_bytes(mesh.to_bytes("vtu")) == mesh
    assert surface().to_bytes("off").startswith(b"OFF")


def test_errors_have_the_words_of_the_program(tmp_path):
    with pytest.raises(aomd.ReadError, match="nothing.ply: cannot be opened: No such file") as error:
        aomd.read(tmp_path / "nothing.ply")
    assert error.value.exit_code == 3 and isinstance(error.value, aomd.Error)
    (tmp_path / "wrong.off").write_text("OFF\n1 1 0\n0 0 0\n3 0 0 9\n")
    with pytest.raises(aomd.ReadError, match="wrong.off:4: "):
        aomd.read(tmp_path / "wrong.off")
    with pytest.raises(aomd.WriteError) as error:
        surface().write(tmp_path / "none" / "a.ply")
    assert error.value.exit_code == 4
    with pytest.raises(ValueError, match="format: must be obj"):
        surface().to_bytes("doc")


def test_samples():
    assert "sphere" in aomd.samples()
    with pytest.raises(ValueError):
        aomd.sample("no such")
