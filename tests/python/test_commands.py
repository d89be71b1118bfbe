"""What the commands of `aomd` come to."""

import json
import os
import subprocess

import numpy as np
import pytest

import aomd


def program(*words):
    """What the program prints as JSON, whatever it says."""
    ended = subprocess.run([os.environ["AOMD_PROGRAM"], *words, "--json"],
                           capture_output=True, text=True)
    return json.loads(ended.stdout)


def without_names(value):
    """Files and figures of the run itself are not those of the program."""
    if isinstance(value, dict):
        return {key: without_names(each) for key, each in value.items()
                if key not in ("file", "seconds", "memory_bytes", "command", "remedy")}
    return value


@pytest.mark.parametrize("sample", ["sphere", "bracket", "layered-beam"])
def test_info_and_check_say_what_the_program_says(tmp_path, sample):
    mesh = aomd.sample(sample)
    file = tmp_path / "a.vtu"
    mesh.write(file)
    assert without_names(aomd.info(mesh)) == without_names(program("info", file))
    assert without_names(aomd.check(mesh)) == without_names(program("check", file))


def test_check_and_repair():
    mesh = aomd.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 1, 2]])
    found = aomd.check(mesh, require=["distinct", "manifold"])
    assert [each["name"] for each in found["surface"]] == ["repeated faces", "self-intersections"]
    assert found["missing"] == ["distinct"]
    with pytest.raises(aomd.UsageError, match="require: \"clear\" is none of closed"):
        aomd.check(mesh, require=["clear"])
    repaired = aomd.repair(mesh)
    assert repaired.mesh.count("faces") == 1 and repaired.left == []
    assert [(each["name"], each["count"]) for each in repaired.done] == [("repeated faces", 1)]
    assert aomd.repair(mesh, repeated_faces=False, orient=False).mesh == mesh
    with pytest.raises(aomd.LimitError):
        aomd.repair(aomd.sample("layered-beam"))


def test_welding():
    mesh = aomd.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1.01, 0, 0], [1, 1, 0], [0, 1.01, 0]],
                     [[0, 1, 2], [3, 4, 5]])
    assert aomd.repair(mesh, weld=True).mesh == mesh
    welded = aomd.repair(mesh, weld=0.02, drop_unused=True).mesh
    assert welded.count("vertices") == 4


@pytest.mark.parametrize("sample, options", [("sphere", {"target_faces": 300}),
                                             ("layered-beam", {"target_tets": "50%"})])
def test_compare_says_what_the_program_says(tmp_path, sample, options):
    mesh = aomd.sample(sample)
    mesh = mesh.with_attribute("heat", np.sin(mesh.vertices[:, 0]))
    coarse = aomd.decimate(mesh, **options).mesh
    mesh.write(tmp_path / "a.vtu")
    coarse.write(tmp_path / "b.vtu")
    as_listed = [aomd.read(tmp_path / file) for file in ("a.vtu", "b.vtu")]
    found = aomd.compare(*as_listed, samples=2000, max_distance=0.0001)
    said = program("compare", tmp_path / "a.vtu", tmp_path / "b.vtu", "--samples", "2000",
                   "--max-distance", "0.0001")
    assert without_names(found) == without_names(said)
    assert "heat" in [each["name"] for each in found["fields"]]
    if sample == "sphere":
        assert found["objections"][0].startswith("largest distance")


def test_classify():
    found = aomd.classify(aomd.sample("bracket"))
    assert found.model_faces > 0 and found.mesh.classes("faces") is not None
    smooth = aomd.classify(aomd.sample("sphere"), angle=None)
    assert (smooth.model_faces, smooth.model_edges) == (1, 0)
    assert aomd.classify(found.mesh).given


def test_split_and_intersections():
    cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
    split = aomd.split_to_tets(aomd.Mesh(cube, regions=[[0, 1, 3, 2, 4, 5, 7, 6]]))
    assert split.regions.shape == (6, 4) and split.notes == ["cut 1 hexahedron into 6 tetrahedra"]
    crossed = aomd.Mesh([[0, 0, 0], [2, 0, 0], [0, 2, 0], [.5, .5, -1], [.5, .5, 1], [3, 3, 0]],
                        [[0, 1, 2], [3, 4, 5]])
    assert aomd.self_intersections(crossed).tolist() == [[0, 1]]
    assert aomd.self_intersections(aomd.sample("sphere")).shape == (0, 2)
