#!/usr/bin/env bash
# tools/bench/attributes.sh: what decimation makes of colours and texture coordinates. A sphere of 99,372 faces with a
# colour at each vertex goes to 5,000 faces, at several weights of the colours in the cost of collapses: what they are off
# by against what the shape is. One with six charts of a texture goes to 10 %. Prints a table for each pattern.
#   AOMD           the program (build/bin/aomd)
#   MESHOPTIMIZER  the folder of the npm package meshoptimizer, to run its simplifyWithAttributes beside it (with node)
#   VTK            the program aomd-peer-vtk-attributes (tools/bench/peers), which runs VTK's attribute metric beside it
# Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$root/tools/bench/attributes
program=${AOMD:-$root/build/bin/aomd}
faces=5000
[ $# -eq 0 ] || { sed -n '2,/^set/{/^# /s/^# //p}' "$0" >&2; exit 2; }
[ -x "$program" ] || { echo "attributes.sh: no $program; build first (tools/test.sh)" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# row LABEL ORIGINAL RESULT: one line of the table of colours.
row() {
  "$program" compare "$2" "$3" --json --samples 200000 >"$work/compare.json" 2>/dev/null || true
  python3 "$here/report.py" colours "$1" "$work/compare.json"
}

decimate() {  # LABEL PATTERN OPTIONS...
  local label=$1 mesh=$work/$2.ply
  shift 2
  "$program" decimate "$mesh" "$work/out.ply" --target-faces "$faces" --quiet "$@"
  row "$label" "$mesh" "$work/out.ply"
}

meshoptimizer() {  # WEIGHT PATTERN
  node "$here/meshoptimizer.mjs" "$MESHOPTIMIZER" "$work/$2.ply" "$faces" "$1" "$work/out.ply"
  row "meshoptimizer, weight $1" "$work/$2.ply" "$work/out.ply"
}

vtk() {  # WEIGHT PATTERN
  "$VTK" "$work/$2.ply" "$faces" "$1" "$work/out.ply"
  row "VTK, weight $1" "$work/$2.ply" "$work/out.ply"
}

for pattern in globe patches smooth; do
  python3 "$here/spheres.py" "$pattern" "$work/$pattern.ply"
  echo "## $pattern to $faces faces"
  python3 "$here/report.py" head
  for weight in 0 0.5 1 2 3 5 10; do decimate "weight $weight" "$pattern" --attributes "color=$weight"; done
  for weight in 0 3 5; do
    decimate "weight $weight, \`--regularity 0\`" "$pattern" --regularity 0 --attributes "color=$weight"
  done
  if [ -n "${MESHOPTIMIZER:-}" ]; then
    for weight in 0 0.01 0.1 1; do meshoptimizer "$weight" "$pattern"; done
  fi
  if [ -n "${VTK:-}" ]; then
    for weight in 0.001 0.01 0.1 1; do vtk "$weight" "$pattern"; done
  fi
done

python3 "$here/spheres.py" charts "$work/charts.obj"
echo "## six charts to 10 %"
for options in "--attributes none" "--attributes uv=1" "--attributes uv=100"; do
  # shellcheck disable=SC2086  # the options are words
  "$program" decimate "$work/charts.obj" "$work/out.obj" --target-faces 10% --quiet $options
  python3 "$here/report.py" charts "\`$options\`" "$work/out.obj"
done
