#!/usr/bin/env bash
# tools/bench/hubs.sh [-n RUNS] [-f FACES] [MESH...]: whether time follows the number of faces where
# thousands of them share a vertex, an edge or a place. Makes surfaces of FACES (100000) faces: disc,
# cone, drum, tips, book, copies, line, point, flatfan, flathubs, strips, tiny. Decimates each to 10 %
# of its faces by both strategies, in turn with the sample `scan` of as many faces, compares it with
# itself, checks and repairs it, and prints user CPU seconds as ratios to those of the scan (least of
# the runs). AOMD names the program (build/bin/aomd). Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
runs=3 faces=100000
while getopts n:f: option; do
  case $option in
    n) runs=$OPTARG ;;
    f) faces=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ -x "$program" ] || { echo "bench: no $program; build first (tools/view.sh)" >&2; exit 2; }

exec python3 - "$program" "$runs" "$faces" "$@" <<'PYTHON'
import math, os, random, subprocess, sys, tempfile

program, runs, n, chosen = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4:]


def ring(count, z=0.0):
    return [(math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count), z) for i in range(count)]


def fan(count, hub, first):
    return [(hub, first + i, first + (i + 1) % count) for i in range(count)]


def turned(faces):
    return [(a, c, b) for a, b, c in faces]


def drum(count):
    side = [(2 + i, 2 + (i + 1) % count, 2 + count + (i + 1) % count) for i in range(count)]
    side += [(2 + i, 2 + count + (i + 1) % count, 2 + count + i) for i in range(count)]
    return ([(0, 0, 0), (0, 0, 1)] + ring(count) + ring(count, 1.0),
            turned(fan(count, 0, 2)) + fan(count, 1, 2 + count) + side)


def tiny(count):
    places = random.Random(1)
    points, faces = [], []
    for i in range(0, 4 * count, 4):
        x, y, z = (10 * places.random() for _ in range(3))
        points += [(x, y, z), (x + 0.1, y, z), (x, y + 0.1, z), (x, y, z + 0.1)]
        faces += [(i, i + 2, i + 1), (i, i + 1, i + 3), (i + 1, i + 2, i + 3), (i, i + 3, i + 2)]
    return points, faces


def hubs_without_area(count, each):
    points, faces = [], []
    for first in range(0, count // each * (each + 1), each + 1):
        points += [(float(i), float(first), 0.0) for i in range(each + 1)]
        faces += fan(each, first, first + 1)
    return points, faces


def strips(count, length):
    line = [(0.0, 0.0, float(j)) for j in range(length + 1)]
    points, faces = list(line), []
    for x, y, _ in ring(count):
        outer = len(points)
        points += [(x, y, float(j)) for j in range(length + 1)]
        for j in range(length):
            faces += [(j, j + 1, outer + j), (j + 1, outer + j + 1, outer + j)]
    return points, faces


kinds = {
    "disc": lambda: ([(0, 0, 0)] + ring(n), fan(n, 0, 1)),
    "cone": lambda: ([(0, 0, 0.2)] + ring(n), fan(n, 0, 1)),
    "drum": lambda: drum(n // 4),
    "tips": lambda: ([(0, 0, 1), (0, 0, -1)] + ring(n // 2), fan(n // 2, 0, 2) + turned(fan(n // 2, 1, 2))),
    "book": lambda: ([(0, 0, 0), (0, 0, 1)] + ring(n, 0.5), [(0, 1, 2 + i) for i in range(n)]),
    "copies": lambda: ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)] * n),
    "line": lambda: ([(i, 0, 0) for i in range(n + 2)], [(i, i + 1, i + 2) for i in range(n)]),
    "point": lambda: ([(1, 2, 3)] * (n + 1), fan(n, 0, 1)),
    "flatfan": lambda: ([(i, 0, 0) for i in range(n + 1)], fan(n, 0, 1)),
    "flathubs": lambda: hubs_without_area(n, 500),
    "strips": lambda: strips(n // 40, 20),
    "tiny": lambda: tiny(n // 4),
}


def write(path, points, faces):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        file.writelines("%.9g %.9g %.9g\n" % p for p in points)
        file.writelines("3 %d %d %d\n" % f for f in faces)


def user_seconds(arguments):
    process = subprocess.Popen([program, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_utime if process.returncode in (0, 1) else math.inf


with tempfile.TemporaryDirectory() as work:
    out = f"{work}/out.ply"

    def commands(path):
        aim = ["--target-faces", "10%", "--threads", "1", "--quiet"]
        return {"quality": ["decimate", path, out, *aim], "paper": ["decimate", path, out, "--strategy", "paper", *aim],
                "compare": ["compare", path, path, "--threads", "1"], "check": ["check", path],
                "repair": ["repair", path, out]}

    scan = f"{work}/scan.off"
    subprocess.run([program, "sample", "scan", scan, "--size", str(n)], check=True, stdout=subprocess.DEVNULL)
    columns = list(commands(scan))
    print("| | " + " | ".join(columns) + " |\n|---|" + "---:|" * len(columns))
    for kind in chosen or kinds:
        path = f"{work}/{kind}.off"
        write(path, *kinds[kind]())
        ratios = []
        for column in columns:
            times = [[user_seconds(commands(p)[column]) for p in (path, scan)] for _ in range(runs)]
            ratios.append(min(t[0] for t in times) / min(t[1] for t in times))
        print(f"| {kind} | " + " | ".join(f"{r:.2f}" for r in ratios) + " |", flush=True)
PYTHON
