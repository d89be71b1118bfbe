#!/usr/bin/env bash
# tools/bench/blocks.sh [-n BLOCKS] [FACES...]: decimates generated surfaces, a ground of hills with so many faces
# (1000000 and 10000000), to a twentieth, in blocks; and as a whole where it has at most WHOLE faces (12000000). Prints
# user CPU, memory at the peak and how far the results are from the original, by `aomd compare`.
#   AOMD   the program (build/bin/aomd)
#   PYTHON one that has NumPy (/usr/bin/python3)
#   WHOLE  the largest surface that is also decimated as a whole
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=${AOMD:-$root/build/bin/aomd}
whole=${WHOLE:-12000000}
blocks=16
if [ "${1:-}" = -n ]; then blocks=$2 && shift 2; fi
[ $# -gt 0 ] || set -- 1000000 10000000
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

hills() {  # FACES FILE
  "${PYTHON:-/usr/bin/python3}" - "$1" "$2" <<'PY'
import sys
import numpy as np

n = max(2, round((int(sys.argv[1]) / 2) ** 0.5) + 1)
axis = np.linspace(0, 8 * np.pi, n)
with open(sys.argv[2], "wb") as file:
    file.write(f"""ply
format binary_little_endian 1.0
element vertex {n * n}
property float x
property float y
property float z
element face {2 * (n - 1) ** 2}
property list uchar int vertex_indices
end_header
""".encode())
    for y in axis:
        z = np.sin(axis) * np.cos(0.7 * y) + 0.2 * np.sin(5 * axis + 3 * np.sin(2 * y)) + 0.02 * np.sin(31 * axis) * np.cos(29 * y)
        np.stack([axis, np.full(n, y), z], 1).astype("<f4").tofile(file)
    row = np.zeros(2 * (n - 1), dtype=[("count", "u1"), ("corner", "<i4", 3)])
    row["count"] = 3
    for k in range(n - 1):
        a = k * n + np.arange(n - 1)
        row["corner"][0::2] = np.stack([a, a + 1, a + n + 1], 1)
        row["corner"][1::2] = np.stack([a, a + n + 1, a + n], 1)
        row.tofile(file)
PY
}

measured() {  # LABEL OPTION...
  local label=$1 seconds kilobytes distances
  shift
  read -r seconds kilobytes < <({ /usr/bin/time -f "%U %M" "$program" decimate "$work/in.ply" "$work/out.ply" \
    --target-faces 5% --threads 1 --quiet "$@" 2>&1 1>/dev/null; } | tail -1)
  distances=$("$program" compare "$work/in.ply" "$work/out.ply" --samples 500000 |
    sed -n 's/^ *the larger *\([0-9.]*\) *\([0-9.]*\).*/\2 | \1/p')
  echo "| $faces | $label | $seconds | $((kilobytes / 1024)) | $((kilobytes * 1024 / faces)) | ${distances:-} |"
}

echo "| faces | | user CPU, s | peak, MB | B a face | RMS, % | largest, % |"
echo "|---:|---|---:|---:|---:|---:|---:|"
for faces in "$@"; do
  hills "$faces" "$work/in.ply"
  [ "$faces" -gt "$whole" ] || measured whole
  measured "$blocks blocks" --blocks "$blocks"
done
