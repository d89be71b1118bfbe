#!/usr/bin/env bash
# tools/bench/peers.sh [-n RUNS] [--faces N | --ratio R] [MESH...]: simplifies every MESH to N faces (or to the part R of
# its faces; 0.0442, 3069 faces of the bunny) with `aomd decimate` and with the libraries that people would use instead,
# in turns, and prints how long each took and how good each result is, as `aomd compare` measures it.
#   AOMD_VARIANTS  options of aomd decimate to try, separated by ";" (an empty one is the default)
#   AOMD_SAMPLES   points on each surface for the distances
#   AOMD_BUILD     the build folder (build-peers)
#   AOMD           the program, if it is not to be built
# Libraries that are missing are left out and named. Needs python3.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source=tools/bench/peers/build.sh
. "$root/tools/bench/peers/build.sh"
build=${AOMD_BUILD:-$root/build-peers}
program=${AOMD:-$build/bin/aomd}
runs=5 faces="" ratio=0.0442

usage() {
  sed -n '2,/^set/{/^# /s/^# //p}' "${BASH_SOURCE[0]}" >&2
  exit 2
}

meshes=()
while [ $# -gt 0 ]; do
  case "$1" in
    -n | --faces | --ratio) [ $# -ge 2 ] || usage ;;&
    -n) runs=$2 && shift ;;
    --faces) faces=$2 && shift ;;
    --ratio) ratio=$2 && shift ;;
    -*) usage ;;
    *) meshes+=("$1") ;;
  esac
  shift
done
[[ $runs =~ ^[1-9][0-9]*$ && $faces =~ ^[0-9]*$ && $ratio =~ ^0?\.[0-9]+$ ]] || usage
[ ${#meshes[@]} -gt 0 ] || meshes=("$root/../shared/data/bunny.ply")

# The contenders: what the table calls them, and how they are called.
labels=() commands=()
collect() {
  local peer variant number name
  for peer in "$build"/bin/aomd-peer-*; do
    [ -x "$peer" ] || continue
    while read -r number name; do
      labels+=("$name")
      commands+=("$peer $number")
    done < <("$peer")
  done
  local variants
  IFS=';' read -r -a variants <<<"${AOMD_VARIANTS---strategy quality --regularity 0;;--regularity 1;--strategy paper};"
  for variant in "${variants[@]}"; do
    read -r variant <<<"$variant"  # without blanks around it
    labels+=("aomd ${variant:-(default)}")
    commands+=("aomd $variant")
  done
}

# simplify COMMAND MESH FACES FOLDER RUN: leaves out.ply and RUN.json, or what went wrong in `error`.
simplify() {
  local words out=$4/out.ply
  [ ! -e "$4/error" ] || return 0
  read -r -a words <<<"$1"
  if [ "${words[0]}" = aomd ]; then
    words=("$program" decimate "$2" "$out" --target-faces "$3" "${words[@]:1}" --quiet --report "$4/$5.json")
    "${words[@]}" >/dev/null 2>"$4/messages" || fail "$?" "$4"
  else
    "${words[@]}" "$2" "$3" "$out" >"$4/$5.json" 2>"$4/messages" || fail "$?" "$4"
  fi
}

fail() {
  { echo "exit code $1:" && tail -n 1 "$2/messages"; } | tr '\n' ' ' >"$2/error"
}

compare() {
  [ ! -e "$2/error" ] || return 0
  "$program" compare "$1" "$2/out.ply" --json --samples "${AOMD_SAMPLES:-500000}" >"$2/compare.txt" 2>"$2/messages" ||
    fail "$?" "$2"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
targets=(aomd)
[ -z "${AOMD:-}" ] || targets=()
build_peers "$root" "$build" "$work/build.log" ${targets[@]+"${targets[@]}"}
collect
for mesh in "${meshes[@]}"; do
  "$program" info "$mesh" --json >"$work/info.json" || exit
  all=$(python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["input"]["faces"])' "$work/info.json")
  target=${faces:-$(python3 -c 'import sys; print(round(int(sys.argv[1]) * float(sys.argv[2])))' "$all" "$ratio")}
  for i in "${!commands[@]}"; do
    rm -rf "${work:?}/$i" && mkdir "$work/$i" && echo "${labels[$i]}" >"$work/$i/label"
  done
  for ((run = 0; run < runs; ++run)); do
    for i in "${!commands[@]}"; do simplify "${commands[$i]}" "$mesh" "$target" "$work/$i" "$run"; done
  done
  for i in "${!commands[@]}"; do compare "$mesh" "$work/$i"; done
  echo "## $(basename "$mesh"): $all faces to $target, $runs runs"
  python3 "$root/tools/bench/peers/table.py" "$work" "${#commands[@]}" "$runs"
done
