#!/usr/bin/env bash
# tools/bench/headless.sh [-n RUNS] [MESH...]: from mesh file to picture, 1280x800, whole process: aomd-view against f3d
# (under Xvfb), in turn. Prints the medians of CPU time, their ratio, and the largest memory. AOMD_VIEW names the program
# (build/bin/aomd-view). Needs python3, f3d and xvfb.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD_VIEW:-$root/build/bin/aomd-view}
runs=5
if [ "${1:-}" = -n ]; then
  runs=$2
  shift 2
fi
[ -x "$program" ] || { echo "bench: no $program; build first (tools/view.sh)" >&2; exit 2; }
for tool in python3 f3d Xvfb; do
  command -v "$tool" >/dev/null || { echo "bench: $tool is missing" >&2; exit 2; }
done
meshes=("$@")
[ ${#meshes[@]} -gt 0 ] || meshes=("$root/../shared/data/bunny.ply" "$root/../shared/data/dragon.ply")

PYTHONPATH=$root/tools/bench exec python3 -B - "$program" "$runs" "${meshes[@]}" <<'PYTHON'
import os, statistics, sys, tempfile

import process

program, runs, meshes = sys.argv[1], int(sys.argv[2]), sys.argv[3:]


def measure(command, picture, environment):
    """CPU seconds and peak megabytes of one process; its picture must appear."""
    taken = process.measure(command, environment=environment)
    if not os.path.exists(picture):
        sys.exit(f"bench: no picture from {' '.join(command)}")
    os.remove(picture)
    return taken


with tempfile.TemporaryDirectory() as work, process.screen("1280x800") as with_display:
    print(f"mesh file to PNG, 1280x800, CPU time of the whole process, median of {runs}, in turn")
    print(f"{'mesh':<16}{'aomd-view ms':>14}{'f3d ms':>10}{'ratio':>8}{'aomd-view MB':>14}{'f3d MB':>10}")
    for mesh in meshes:
        ours, theirs = [], []
        picture = os.path.join(work, "picture.png")
        for _ in range(runs):
            ours.append(measure([program, mesh, "--headless", "--size", "1280x800", "--screenshot", picture], picture,
                                os.environ))
            theirs.append(measure(["f3d", mesh, "--output", picture, "--resolution", "1280,800"], picture,
                                  with_display))
        a, b = (statistics.median(s for s, _ in side) for side in (ours, theirs))
        print(f"{os.path.basename(mesh):<16}{1e3 * a:>14.0f}{1e3 * b:>10.0f}{a / b:>8.2f}"
              f"{max(m for _, m in ours):>14.0f}{max(m for _, m in theirs):>10.0f}")
PYTHON
