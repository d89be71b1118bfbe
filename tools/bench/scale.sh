#!/usr/bin/env bash
# tools/bench/scale.sh [-n RUNS] [FACES...]: how time and memory grow with the mesh. Decimates the sample `scan` of each
# size (70000 350000 1000000 5000000) to 5 % of its faces, sizes in turn, and prints from the reports: microseconds of
# decimation an input face (least of the runs), their ratio to the first size, and bytes an input face: the mesh with its
# stored adjacencies, and what the process held over them at most by the end of the decimation (the mesh as read
# included). AOMD names the program (build/bin/aomd). Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
runs=3
if [ "${1:-}" = -n ]; then
  runs=$2
  shift 2
fi
[ -x "$program" ] || { echo "bench: no $program; build first (tools/view.sh)" >&2; exit 2; }
sizes=("$@")
[ ${#sizes[@]} -gt 0 ] || sizes=(70000 350000 1000000 5000000)

exec python3 - "$program" "$runs" "${sizes[@]}" <<'PYTHON'
import json, subprocess, sys, tempfile

program, runs, sizes = sys.argv[1], int(sys.argv[2]), [int(s) for s in sys.argv[3:]]
with tempfile.TemporaryDirectory() as work:
    reports = {size: [] for size in sizes}
    for size in sizes:
        subprocess.run([program, "sample", "scan", f"{work}/{size}.ply", "--size", str(size)], check=True,
                       stdout=subprocess.DEVNULL)
    for _ in range(runs):
        for size in sizes:
            subprocess.run([program, "decimate", f"{work}/{size}.ply", f"{work}/result.ply", "--target-faces",
                            str(size // 20), "--quiet", "--report", f"{work}/report.json"], check=True)
            with open(f"{work}/report.json") as file:
                reports[size].append(json.load(file))

print("| faces | us a face | ratio | mesh, B a face | over it, B a face |\n|---:|---:|---:|---:|---:|")
first = None
for size in sizes:
    report = min(reports[size], key=lambda r: r["seconds"]["decimate"])
    faces, memory = report["input"]["faces"], report["memory_bytes"]
    spent = (report["seconds"]["adjacency"] + report["seconds"]["decimate"]) / faces * 1e6
    first = first or spent
    mesh = memory["mesh"] + memory["adjacency"]
    print(f"| {faces:,} | {spent:.2f} | {spent / first:.2f} | {mesh / faces:.0f} "
          f"| {(memory['decimate_peak'] - mesh) / faces:.0f} |")
PYTHON
