#!/usr/bin/env bash
# tools/bench/texture.sh [FOLDER]: what a textured model looks like before and after. The globe (six charts) goes to 10 %,
# both are drawn with the same picture, camera and light, from six sides. Prints the structural similarity (SSIM) of each
# pair of pictures; the pictures stay in FOLDER where one is given.
#   AOMD, AOMD_VIEW   the programs (build/bin/aomd, build/bin/aomd-view)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
aomd=${AOMD:-$root/build/bin/aomd}
view=${AOMD_VIEW:-$root/build/bin/aomd-view}
size=64
case ${1:-} in -*) sed -n '2,/^set/{/^# /s/^# //p}' "$0" >&2; exit 2 ;; esac
for program in "$aomd" "$view"; do
  [ -x "$program" ] || { echo "texture.sh: no $program; build first (tools/view.sh)" >&2; exit 2; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
work=${1:-$scratch}
mkdir -p "$work"

draw() {  # MESH NAME
  {
    echo "open $1"
    printf '%s\n' "panel all off" "color texture" "show edges off" "show model-edges off" "show model-vertices off" "show axes off"
    for side in front right back left top bottom; do
      echo "camera $side"
      echo "screenshot $work/$2-$side.png no-ui"
    done
    echo quit
  } >"$scratch/$2.aomd"
  "$view" --headless --size 800x800 --script "$scratch/$2.aomd" >/dev/null
}

"$aomd" sample globe "$scratch/before.glb" --size "$size"
draw "$scratch/before.glb" before
echo "| options | front | right | back | left | top | bottom |"
echo "|---|---:|---:|---:|---:|---:|---:|"
for options in "" "--attributes none" "--seams ignore"; do
  name=after$(tr -d ' -' <<<"$options")
  # shellcheck disable=SC2086  # the options are words
  "$aomd" decimate "$scratch/before.glb" "$scratch/after.glb" --target-faces 10% --quiet $options
  draw "$scratch/after.glb" "$name"
  printf '| %s |' "${options:-default}"
  for side in front right back left top bottom; do
    judged=$("$aomd" image-diff "$work/before-$side.png" "$work/$name-$side.png") || [ $? -eq 1 ]
    printf ' %s |' "$(sed -nE 's/^ssim ([0-9.]+),.*/\1/p' <<<"$judged")"
  done
  echo
done
