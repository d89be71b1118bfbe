#!/usr/bin/env python3
"""report.py: lines of the tables of tools/bench/attributes.sh.

report.py head
report.py colours LABEL COMPARE.json     from what aomd compare measured
report.py charts LABEL RESULT.obj        a sphere with the charts of spheres.py
"""

import json
import math
import sys

from spheres import SIDES


def colours(label, file):
    with open(file, encoding="utf-8") as opened:
        found = json.load(opened)
    field = found["fields"][0]
    print(f"| {label} | {found['result']['faces']} | {100 * field['rms'] / 255:.2f} | {found['rms_pct']:.5f} | "
          f"{found['hausdorff_pct']:.3f} | {found['min_angle_mean_deg']:.1f} | {found['flips']} |")


def read(file):
    vertices, places, faces = [], [], []
    with open(file, encoding="utf-8") as lines:
        for line in lines:
            word, *rest = line.split() or [""]
            if word == "v":
                vertices.append(tuple(map(float, rest[:3])))
            elif word == "vt":
                places.append(tuple(map(float, rest[:2])))
            elif word == "f":
                faces.append([tuple(int(k) - 1 for k in corner.split("/")[:2]) for corner in rest])
    return vertices, places, faces


def on_chart(p, side):
    """The texture coordinates that spheres.py gives a place on one of its sides."""
    centre, right, up = SIDES[side]
    along = [sum(a * b for a, b in zip(p, axis)) for axis in (centre, right, up)]
    u, v = (0.5 + 0.5 * math.atan(x / along[0]) / (math.pi / 4) for x in along[1:])
    return (side + 0.1 + 0.8 * u) / 6, 0.1 + 0.8 * v


def charts(label, file):
    """Corners in the wrong chart, faces turned over there, and how far corners are off."""
    vertices, places, faces = read(file)
    wrong = turned = 0
    squares, area = [], 0
    for face in faces:
        middle = [sum(vertices[v][k] for v, _ in face) for k in range(3)]
        side = max(range(6), key=lambda s: sum(a * b for a, b in zip(middle, SIDES[s][0])))
        (a, b), (c, d), (e, f) = (places[t] for _, t in face)
        twice = (c - a) * (f - b) - (e - a) * (d - b)
        turned += twice <= 0
        area += twice / 2
        for v, t in face:
            wrong += int(6 * places[t][0]) != side
            wanted = on_chart(vertices[v], side)
            squares.append((6 * (places[t][0] - wanted[0])) ** 2 + (places[t][1] - wanted[1]) ** 2)
    rms = math.sqrt(sum(squares) / len(squares))
    print(f"{label}: {len(faces)} faces, {wrong} corners in another chart, {turned} faces turned over in texture "
          f"space, area there {area / 0.64:.6f} of the original's, corners off by {100 * rms:.4f} % of a chart (RMS)")


def main(kind, *rest):
    if kind == "head":
        print("| | faces | RMS colour, % | RMS distance, % | Hausdorff, % | mean smallest angle | flips |")
        print("|---|---:|---:|---:|---:|---:|---:|")
    else:
        {"colours": colours, "charts": charts}[kind](*rest)


if __name__ == "__main__":
    main(*sys.argv[1:])
