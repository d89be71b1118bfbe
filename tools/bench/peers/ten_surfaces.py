"""ten_surfaces.py PROGRAM PEERS DATA WORK [NAME...]: the table of tools/bench/ten_surfaces.sh.

PEERS is the folder of the programs aomd-peer-*, DATA that of the meshes, WORK one for what is written. `aomd compare`
measures each result against the original.
"""

import json
import os
import subprocess
import sys

SURFACES = [  # kind, name, how the original is made, from what
    ("scan", "bunny", "file", "bunny.ply"),
    ("scan", "rocker arm", "file", "rocker_arm.obj"),
    ("scan", "sample scan", "sample", "scan"),
    ("CAD", "fandisk", "file", "fandisk.off"),
    ("CAD", "DTC hull", "file", "dtc_hull.stl"),
    ("CAD", "turbine", "file", "turbine.off"),
    ("overlapping", "repaired dragon", "repair", "dragon.ply"),
    ("overlapping", "self_intersect", "file", "self_intersect.obj"),
    ("holes", "cheese", "file", "cheese.off"),
    ("holes", "elephant", "file", "elephant_with_holes.off"),
]
SHARES = [0.05, 0.1]
METHODS = [  # how a peer names it, and the table
    ("Lindstrom-Turk", "Lindstrom-Turk"),
    ("Garland-Heckbert, bounded normals", "Garland-Heckbert, bounded"),
    ("vtkQuadricDecimation", "VTK quadric"),
    ("meshoptimizer", "meshoptimizer"),
]
COMPARED = [  # key, digits that count, name
    ("rms_pct", 4, "RMS"),
    ("hausdorff_pct", 3, "Hausdorff"),
    ("flips", 0, "flips"),
    ("self_intersections", 0, "intersections"),
]


class Failure(Exception):
    """What a program said before it gave up."""


def call(*words):
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise Failure((run.stderr.strip().splitlines() or [f"exit code {run.returncode}"])[-1])
    return run.stdout


def peers_in(folder):
    """For each of METHODS the words that run it; empty where its library was not found."""
    listed = []
    for name in sorted(os.listdir(folder)):
        if name.startswith("aomd-peer-") and not name.endswith("-attributes"):
            program = os.path.join(folder, name)
            listed += [(program, *line.split(" ", 1)) for line in call(program).splitlines()]
    return [next(([program, number] for program, number, title in listed if known in title), [])
            for known, _ in METHODS]


def original(program, data, work, how, source):
    if how == "file":
        return os.path.join(data, source)
    path = os.path.join(work, "original.ply")
    call(program, how, source if how == "sample" else os.path.join(data, source), path)
    return path


def measure(program, before, after):
    return json.loads(call(program, "compare", before, after, "--json"))


def cell(m):
    return (f"{m['rms_pct']:.4f} / {m['hausdorff_pct']:.3f} / {m['min_angle_mean_deg']:.1f} / {m['flips']} / "
            f"{m['self_intersections']}")


def behind(own, others):
    """In what another is ahead: the best of all in each measure, in angles the one with the smallest RMS."""
    words = [name for key, digits, name in COMPARED
             if round(own[key], digits) > min(round(m[key], digits) for m in others)]
    closest = min(others, key=lambda m: m["rms_pct"])
    if own["min_angle_mean_deg"] < closest["min_angle_mean_deg"]:
        words.append("angle")
    return ", ".join(words) or "-"


def peer_cell(peer, program, before, out, faces, others):
    """One that stops at more faces is shown, and not compared with."""
    if not peer:
        return "not found"
    try:
        call(*peer, before, str(faces), out)
    except Failure as failure:
        return str(failure)
    result = measure(program, before, out)
    left = result["result"]["faces"]
    if left > 1.01 * faces:
        return f"{cell(result)} ({left:,} faces)"
    others.append(result)
    return cell(result)


def row(program, peers, before, out, name, target):
    call(program, "decimate", before, out, "--target-faces", str(target), "--regularity", "0", "--quiet")
    own = measure(program, before, out)
    faces = own["result"]["faces"]
    others = []
    cells = [peer_cell(peer, program, before, out, faces, others) for peer in peers]
    count = f"{faces:,}" if faces <= 1.01 * target else f"{faces:,} instead of {target:,}"
    return [f"{name} to {count}"] + cells + [cell(own), behind(own, others) if others else ""]


def main(program, folder, data, work, *wanted):
    peers = peers_in(folder)
    print("| | " + " | ".join(label for _, label in METHODS) + " | `--regularity 0` | behind in |")
    print("|---|" + "---:|" * (len(METHODS) + 1) + "---|")
    for kind, name, how, source in SURFACES:
        if wanted and name not in wanted:
            continue
        before = original(program, data, work, how, source)
        faces = json.loads(call(program, "info", before, "--json"))["input"]["faces"]
        for share in SHARES:
            cells = row(program, peers, before, os.path.join(work, "out.ply"), f"{kind}: {name}", round(share * faces))
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except Failure as failure:
        sys.exit(f"ten_surfaces.py: {failure}")
