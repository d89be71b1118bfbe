#!/usr/bin/env bash
# tools/bench/ten_surfaces.sh [--update-docs] [NAME...]: ten surfaces of four kinds (scans, CAD parts, such that overlap
# themselves, such of holes) to 5 and to 10 % of their faces with `aomd decimate --regularity 0` and, to as many faces,
# with other libraries: distances, mean smallest angle, flips and self-intersections of each, and in what `aomd` is not
# ahead. Markdown; --update-docs puts it between the markers of docs/QUALITY.md. NAMEs choose surfaces.
#   AOMD_DATA      the folder of the meshes (../shared/data)
#   AOMD_BUILD     the build folder (build-peers)
#   AOMD           the program, and AOMD_PEERS the folder of the programs aomd-peer-*, if they are not to be built
# Libraries that are missing are left out and named. Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source=tools/bench/peers/build.sh
. "$root/tools/bench/peers/build.sh"
build=${AOMD_BUILD:-$root/build-peers}
update=no names=()
while [ $# -gt 0 ]; do
  case "$1" in
    --update-docs) update=yes ;;
    -*) sed -n '2,/^set/{/^# /s/^# //p}' "$0" >&2; exit 2 ;;
    *) names+=("$1") ;;
  esac
  shift
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if [ -z "${AOMD:-}" ] || [ -z "${AOMD_PEERS:-}" ]; then build_peers "$root" "$build" "$work/build.log" aomd >&2; fi

table() {
  python3 "$root/tools/bench/peers/ten_surfaces.py" "${AOMD:-$build/bin/aomd}" "${AOMD_PEERS:-$build/bin}" \
    "${AOMD_DATA:-$root/../shared/data}" "$work" ${names[@]+"${names[@]}"}
}

if [ "$update" = no ]; then
  table
else
  table >"$work/table.md"
  python3 "$root/tools/bench/between_markers.py" "$root/docs/QUALITY.md" surfaces "$work/table.md"
fi
