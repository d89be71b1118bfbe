#!/usr/bin/env bash
# tools/bench/volumes.sh [--metric PROGRAM] [--percent "25 10"] [--regularity "0 0.5 1"] [--peers] [MESH...]: decimates every
# MESH of tetrahedra with `aomd decimate --strategy quality` to a part of its tetrahedra and prints what is left, as
# rows of Markdown: dihedral angles, volumes of regions, distances between the same interfaces, CPU seconds of the
# whole command, memory. Distances and topology are measured by a PROGRAM that is no part of this one: it is called
# as PROGRAM RESULT ORIGINAL --samples N --list --match-regions and prints "key: value" lines. Without it those
# columns stay empty and angles are those of `aomd info`. With --peers every other library that was found when the build
# was configured with -DAOMD_BENCH_PEERS=ON (aomd-volume-peer-* beside the program) has a row for each, in turn: CGAL's
# remeshing, at the factor of the local edge length that leads within 2.5 % of the target, and VTK's filter. Without a
# MESH: the samples. AOMD names the program. Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
metric="" percent="25 10" regularity="0.5" peers="" samples=${SAMPLES:-200000}
meshes=()
while [ $# -gt 0 ]; do
  case "$1" in
    --metric) metric=$2; shift ;;
    --percent) percent=$2; shift ;;
    --regularity) regularity=$2; shift ;;
    --peers) peers=$(compgen -G "$(dirname "$program")/aomd-volume-peer-*" || true) ;;
    -h | --help) sed -n '2,11s/^# //p' "$0"; exit 0 ;;
    -*) echo "volumes.sh: unknown option $1" >&2; exit 2 ;;
    *) meshes+=("$1") ;;
  esac
  shift
done
[ -x "$program" ] || { echo "volumes.sh: no $program; build first (tools/test.sh)" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ ${#meshes[@]} -eq 0 ]; then
  for name in ball-in-box tet-bracket layered-beam; do
    "$program" sample "$name" "$work/$name.msh" --size 8 >/dev/null
    meshes+=("$work/$name.msh")
  done
fi
echo "| mesh, to | regularity, or who | tets | dihedral min / p5 / mean | < 10 deg, % | region volume, worst % | boundary RMS / H, % | interfaces RMS / H, % | model edges RMS / H, % | CPU s | MB | differences |"
echo "|---|---|---:|---|---:|---:|---|---|---|---:|---:|---|"
for mesh in "${meshes[@]}"; do
  "$program" classify "$mesh" "$work/original.msh" >/dev/null 2>&1 || cp "$mesh" "$work/original.msh"
  for p in $percent; do
    for r in $regularity $peers; do
      AOMD_PROGRAM=$program AOMD_METRIC=$metric AOMD_SAMPLES=$samples \
        python3 "$root/tools/bench/volume_row.py" "$mesh" "$work/original.msh" "$p" "$r" "$work/result.msh"
    done
  done
done
