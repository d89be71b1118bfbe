#!/usr/bin/env bash
# tools/bench/scale_volumes.sh [-n RUNS] [LAYERS...]: how time and memory grow with a volume. Decimates the sample
# `ball-in-box` of each number of layers (3 5 9 19: 20,736 to 5,267,712 tetrahedra) to 25 % of its tetrahedra, sizes in
# turn, and prints of the whole command: CPU seconds (least of the runs), microseconds a tetrahedron of the input, their
# ratio to the first size, and bytes a tetrahedron at the peak over what the program holds for a mesh of a few
# tetrahedra. AOMD names the program (build/bin/aomd). Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
runs=1
if [ "${1:-}" = -n ]; then
  runs=$2
  shift 2
fi
[ -x "$program" ] || { echo "bench: no $program; build first (tools/view.sh)" >&2; exit 2; }
sizes=("$@")
[ ${#sizes[@]} -gt 0 ] || sizes=(3 5 9 19)

exec python3 - "$program" "$runs" "${sizes[@]}" <<'PYTHON'
import json, os, subprocess, sys, tempfile

program, runs, sizes = sys.argv[1], int(sys.argv[2]), [int(s) for s in sys.argv[3:]]


def measured(work, size):
    """CPU seconds, bytes at the peak and tetrahedra of one decimation."""
    # A shell of its own starts it: the memory of a process counts that of the one that forked it.
    process = subprocess.Popen(["sh", "-c", '"$@"; exit $?', "sh", program, "decimate", f"{work}/{size}.msh", f"{work}/result.msh", "--strategy",
                                "quality", "--target-tets", "25%", "--quiet", "--report", f"{work}/report.json"])
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"bench: size {size} ended with status {status}")
    with open(f"{work}/report.json") as file:
        report = json.load(file)
    return usage.ru_utime + usage.ru_stime, report["memory_bytes"]["peak"], report["input"]["regions"]


with tempfile.TemporaryDirectory() as work:
    for size in [1] + sizes:
        subprocess.run([program, "sample", "ball-in-box", f"{work}/{size}.msh", "--size", str(size)], check=True,
                       stdout=subprocess.DEVNULL)
    base = measured(work, 1)[1]
    found = {size: [] for size in sizes}
    for _ in range(runs):
        for size in sizes:
            found[size].append(measured(work, size))

print("| tetrahedra | CPU s | us a tetrahedron | ratio | B a tetrahedron |\n|---:|---:|---:|---:|---:|")
first = None
for size in sizes:
    seconds, peak, tets = min(found[size])
    first = first or seconds / tets
    print(f"| {tets:,} | {seconds:.2f} | {seconds / tets * 1e6:.2f} | {seconds / tets / first:.2f} "
          f"| {(peak - base) / tets:.0f} |")
PYTHON
