#!/usr/bin/env python3
"""spheres.py PATTERN OUT: a sphere as a cube of 91 x 91 cells a side, 99,372 faces.

globe, patches and smooth are colours at vertices (PLY): land and sea, three colours with much more border, and waves.
charts are texture coordinates (OBJ), a chart for each side of the cube.
"""

import math
import sys

CELLS = 91
SIDES = [((1, 0, 0), (0, 1, 0), (0, 0, 1)), ((-1, 0, 0), (0, 0, 1), (0, 1, 0)),
         ((0, 1, 0), (0, 0, 1), (1, 0, 0)), ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
         ((0, 0, 1), (1, 0, 0), (0, 1, 0)), ((0, 0, -1), (0, 1, 0), (1, 0, 0))]


def sphere():
    """Vertices, and faces as (side, ((vertex, i, j), ...)) with places on the side's grid."""
    vertices, known, faces = [], {}, []

    def at(side, i, j):
        centre, right, up = SIDES[side]
        a, b = (math.tan(math.pi / 4 * (2 * k / CELLS - 1)) for k in (i, j))
        p = [centre[k] + a * right[k] + b * up[k] for k in range(3)]
        length = math.sqrt(sum(x * x for x in p))
        p = tuple(x / length for x in p)
        key = tuple(round(x * 1e9) for x in p)
        if key not in known:
            known[key] = len(vertices)
            vertices.append(p)
        return known[key], i, j

    for side in range(6):
        for i in range(CELLS):
            for j in range(CELLS):
                a, b, c, d = (at(side, i + u, j + v) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)))
                faces += [(side, (a, b, c)), (side, (a, c, d))]
    return vertices, faces


def step(x):
    """From 0 to 1 where x is near 0."""
    t = min(1, max(0, 0.5 + 10 * x))
    return t * t * (3 - 2 * t)


def waves(p, n):
    return sum(math.sin(n * x + phase) for x, phase in zip(p, (1, 2, 0.5)))


def colour(pattern, p):
    if pattern == "smooth":
        return [127.5 + 127.5 * math.sin(6 * x + k) for k, x in enumerate(p)]
    if pattern == "globe":
        land = step(waves(p, 3))
        return [30 + 190 * land - 40 * abs(p[2]) * land, 80 + 100 * land, 200 - 140 * land]
    one = step(waves(p, 5))
    other = step(math.sin(4 * p[0] - 1) * math.sin(4 * p[1] + 1) + 0.5 * math.sin(4 * p[2]))
    return [255 * one, 255 * (1 - one) * other + 60 * one, 255 * (1 - other)]


def write_colours(file, pattern, vertices, faces):
    coordinates = "".join(f"property double {name}\n" for name in "xyz")
    colours = "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
    file.write(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\n{coordinates}{colours}"
               f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    for p in vertices:
        numbers = [repr(x) for x in p] + [str(round(x)) for x in colour(pattern, p)]
        file.write(" ".join(numbers) + "\n")
    for _, corners in faces:
        file.write("3 " + " ".join(str(v) for v, _, _ in corners) + "\n")


def write_charts(file, vertices, faces):
    """Charts lie in a row, each from n + 0.1 to n + 0.9 of six."""
    for p in vertices:
        file.write("v %r %r %r\n" % p)
    places, lines = {}, []
    for side, corners in faces:
        line = "f"
        for v, i, j in corners:
            place = ((side + 0.1 + 0.8 * i / CELLS) / 6, 0.1 + 0.8 * j / CELLS)
            line += f" {v + 1}/{places.setdefault(place, len(places) + 1)}"
        lines.append(line)
    for place in places:
        file.write("vt %r %r\n" % place)
    file.write("\n".join(lines) + "\n")


def main(pattern, out):
    vertices, faces = sphere()
    with open(out, "w", encoding="utf-8") as file:
        if pattern == "charts":
            write_charts(file, vertices, faces)
        else:
            write_colours(file, pattern, vertices, faces)


if __name__ == "__main__":
    main(*sys.argv[1:])
