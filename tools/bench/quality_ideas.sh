#!/usr/bin/env bash
# tools/bench/quality_ideas.sh [-n RUNS] [--faces N] [--regularity W] [--update-docs] [MESH]: what each idea of the
# quality strategy is worth: the same decimation with everything, with each idea left out, and with none, measured by
# `aomd compare`. Markdown; --update-docs puts it between the markers of docs/QUALITY.md. Without a MESH: the bunny of
# ../shared/data, or a generated scan. AOMD names the program (build/bin/aomd). Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
runs=3 faces="" regularity=0.5 update=no mesh=""
while [ $# -gt 0 ]; do
  case "$1" in
    -n) runs=$2; shift 2 ;;
    --faces) faces=$2; shift 2 ;;
    --regularity) regularity=$2; shift 2 ;;
    --update-docs) update=yes; shift ;;
    -h | --help) sed -n '2,5s/^# //p' "$0"; exit 0 ;;
    -*) echo "quality_ideas.sh: unknown option $1" >&2; exit 2 ;;
    *) mesh=$1; shift ;;
  esac
done
[ -x "$program" ] || { echo "quality_ideas.sh: no $program; build first (tools/test.sh)" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ -z "$mesh" ]; then
  mesh=$root/../shared/data/bunny.ply
  faces=${faces:-3069}
  [ -r "$mesh" ] || { mesh=$work/scan.ply; "$program" sample scan "$mesh" >/dev/null; faces=""; }
fi
[ -n "$faces" ] || faces=$("$program" info "$mesh" --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["faces"] // 20)')

names=(all "no placement" "no third-powers" "no facing" "no second-stage" "no far-points" "no dense-points" "no swaps" "no fit" none)
options=("" "--without placement" "--without third-powers" "--without facing" "--without second-stage"
  "--without far-points" "--without dense-points" --no-swap --no-smooth
  "--without placement,third-powers,facing,second-stage,far-points,dense-points --no-swap --no-smooth")
for ((run = 0; run < runs; ++run)); do
  for i in "${!names[@]}"; do
    read -r -a extra <<<"${options[$i]}"
    "$program" decimate "$mesh" "$work/$i.ply" --strategy quality --regularity "$regularity" --target-faces "$faces" \
      ${extra[@]+"${extra[@]}"} --quiet --report "$work/$i-$run.json"
  done
done
for i in "${!names[@]}"; do "$program" compare "$mesh" "$work/$i.ply" --json >"$work/compare-$i.json"; done

table() {
  echo "$(basename "$mesh") to $faces faces, regularity $regularity; distances in % of the diagonal, time as a ratio to the first row:"
  echo
  echo "| | RMS | Hausdorff | mean smallest angle | faces < 10 deg, % | normals > 60 deg off, % | flips | self-intersections | time |"
  echo "|---|---:|---:|---:|---:|---:|---:|---:|---:|"
  python3 - "$work" "$runs" "${names[@]}" <<'PYTHON'
import json, statistics, sys

work, runs, names = sys.argv[1], int(sys.argv[2]), sys.argv[3:]

def load(name):
    with open(f"{work}/{name}.json") as file:
        return json.load(file)

def seconds(i, run):
    s = load(f"{i}-{run}")["seconds"]
    return s["adjacency"] + s["decimate"]

for i, name in enumerate(names):
    c = load(f"compare-{i}")
    time = statistics.median(seconds(i, run) / seconds(0, run) for run in range(runs))
    print(f"| {name} | {c['rms_pct']:.4f} | {c['hausdorff_pct']:.3f} | {c['min_angle_mean_deg']:.1f} "
          f"| {c['faces_below_10deg_pct']:.2f} | {c['normal_dev_gt60_pct']:.2f} | {c['flips']} "
          f"| {c['self_intersections']} | {time:.2f} |")
PYTHON
}
if [ "$update" = no ]; then
  table
else
  table >"$work/table.md"
  python3 "$root/tools/bench/between_markers.py" "$root/docs/QUALITY.md" ideas "$work/table.md"
fi
