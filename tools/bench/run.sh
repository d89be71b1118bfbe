#!/usr/bin/env bash
# tools/bench/run.sh [-n RUNS] [MESH...]: times the stages of `aomd decimate` apart and prints a table of medians.
# The meshes take turns, so that a slow minute of the machine hits all of them. Without a MESH: the bunny and the dragon
# of ../shared/data, or a generated scan. AOMD names the program (build/bin/aomd), AOMD_OPTIONS its options
# (--coarsest --angle 10). Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
read -r -a options <<<"${AOMD_OPTIONS:---coarsest --angle 10}"
runs=7
if [ "${1:-}" = -n ]; then
  runs=$2
  shift 2
fi
[ -x "$program" ] || { echo "bench: no $program; build first (tools/test.sh)" >&2; exit 2; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
meshes=("$@")
if [ ${#meshes[@]} -eq 0 ] && [ -r "$root/../shared/data/bunny.ply" ]; then
  meshes=("$root/../shared/data/bunny.ply" "$root/../shared/data/dragon.ply")
elif [ ${#meshes[@]} -eq 0 ]; then
  "$program" sample scan "$work/scan.ply"
  meshes=("$work/scan.ply")
fi

for ((run = 0; run < runs; ++run)); do
  for i in "${!meshes[@]}"; do
    "$program" decimate "${meshes[$i]}" "$work/out.ply" "${options[@]}" --quiet --report "$work/$i-$run.json"
  done
done
echo "aomd decimate ${options[*]}, median of $runs, milliseconds; memory in MB"
python3 - "$work" <<'PYTHON'
import glob, json, os, statistics, sys

stages = ["read", "classify", "adjacency", "decimate", "check", "write", "total"]
memory = ["mesh", "adjacency", "peak"]
print(f"{'mesh':<16}{'faces':>8}{'result':>8}" + "".join(f"{s:>10}" for s in stages + memory))
reports = {}
for path in sorted(glob.glob(os.path.join(sys.argv[1], "*.json"))):
    with open(path) as file:
        report = json.load(file)
    reports.setdefault(report["input"]["file"], []).append(report)
for file, runs in reports.items():
    first = runs[0]
    cells = [1e3 * statistics.median(r["seconds"][s] for r in runs) for s in stages]
    cells += [first["memory_bytes"][m] / 1e6 for m in memory]
    print(f"{os.path.basename(file):<16}{first['input']['faces']:>8}{first['output']['faces']:>8}"
          + "".join(f"{c:>10.1f}" for c in cells))
PYTHON
