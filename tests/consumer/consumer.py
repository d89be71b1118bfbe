"""Reads a surface, decimates, compares and writes it, knowing nothing but the installed package."""

import pathlib
import sys

import aomd

folder = pathlib.Path(sys.argv[1])
ball = aomd.sample("sphere")
result = aomd.decimate(ball, target_faces=500)
assert len(result.mesh.faces) == 500
assert aomd.compare(ball, result.mesh, samples=1000)["hausdorff_pct"] < 2
aomd.write(folder / "coarse.ply", result.mesh)
assert aomd.read(folder / "coarse.ply") == result.mesh
assert aomd.render(result.mesh, size=(80, 60)).shape == (60, 80, 4)
