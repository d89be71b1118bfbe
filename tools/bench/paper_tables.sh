#!/usr/bin/env bash
# tools/bench/paper_tables.sh [-n RUNS] [--pictures DIR] [--update-docs]: Tables 1 and 2 of the paper beside what
# `aomd decimate` makes of the same models, as Markdown: both strategies, both topology modes.
#   -n RUNS          times are medians of so many runs, in turns (3)
#   --pictures DIR   also draws Figures 8 to 17 there: the paper's strategy and ours, all from one place a model
#   --update-docs    puts the tables between the markers of docs/PAPER.md instead of printing them, and draws the
#                    pictures that it shows (docs/pictures/paper) anew
#   AOMD, AOMD_VIEW  the programs (build/bin/aomd, build/bin/aomd-view)
#   AOMD_DATA        the folder of bunny.ply and dragon.ply (../shared/data); a model that is not there is left out
# Needs python3, and ImageMagick for pictures.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$(dirname "$here")")
program=${AOMD:-$root/build/bin/aomd}
viewer=${AOMD_VIEW:-$root/build/bin/aomd-view}
data=${AOMD_DATA:-$root/../shared/data}
docs=$root/docs/PAPER.md
runs=3 pictures="" update=""

# What the paper says of each figure: vertices, edges and faces (Tables 1 and 2; rounded, in the caption of Figure 17;
# nowhere for Figure 12), and how its mesh was made.
rows=(
  "bunny 8 35947 0 69451"
  "bunny 9 4567 10294 6837 --factor 4 --angle 10"
  "bunny 10 2961 5496 3645 --factor 8 --angle 10"
  "bunny 11 2667 4626 3069 --coarsest --angle 10"
  "bunny 12 - - - --coarsest --angle 60"
  "dragon 13 100250 0 202520"
  "dragon 14 22166 66555 44464 --factor 4 --angle 10"
  "dragon 15 11364 34099 22811 --factor 8 --angle 10"
  "dragon 16 9115 27345 18306 --coarsest --angle 10"
  "dragon 17 ~2600 ~4300 ~2900 --coarsest --angle 60"
)
ways=(paper-safe paper-paper quality-safe quality-paper)  # strategy-topology

usage() {
  sed -n '2,/^set/{/^# /s/^# //p}' "${BASH_SOURCE[0]}"
}

wrong() {
  usage >&2
  exit 2
}

while [ $# -gt 0 ]; do
  case "$1" in
    -n | --pictures) [ $# -ge 2 ] || wrong ;;&
    -n) runs=$2 && shift ;;
    --pictures) pictures=$2 && shift ;;
    --update-docs) update=yes ;;
    -h | --help) usage && exit ;;
    *) wrong ;;
  esac
  shift
done
[[ $runs =~ ^[1-9][0-9]*$ ]] || wrong
[ -x "$program" ] || { echo "paper_tables: no $program; build first (tools/test.sh)" >&2; exit 2; }
if [ -n "$pictures$update" ]; then
  [ -x "$viewer" ] || { echo "paper_tables: no $viewer; build first (tools/view.sh)" >&2; exit 2; }
  command -v convert >/dev/null || { echo "paper_tables: convert (ImageMagick) is missing" >&2; exit 2; }
fi

# options_of WAY FACES OPTION...: how `aomd decimate` makes the mesh of a figure. With ours, whose angle does not bind at
# these sizes, factors have other meanings than the paper's: it is told how many faces the paper ended with.
options_of() {
  local way=$1 faces=$2
  shift 2
  echo "--strategy ${way%-*} --topology ${way#*-}"
  if [ "${way%-*}" = quality ] && [ "$1" = --factor ]; then
    echo "--target-faces $faces"
  else
    echo "$*"
  fi
}

# make_figure RUN MODEL FIGURE VERTICES EDGES FACES [OPTION...]: the meshes of a figure, WAY.ply and their reports.
make_figure() {
  local run=$1 model=$2 folder=$work/$2/$3 faces=$6 way options
  mkdir -p "$folder" && echo "$4 $5 $6" >"$folder/paper"
  shift 6
  [ $# -gt 0 ] || return 0
  for way in "${ways[@]}"; do
    read -r -d '' -a options < <(options_of "$way" "$faces" "$@") || true
    echo "${options[*]}" >"$folder/$way.options"
    "$program" decimate "$data/$model.ply" "$folder/$way.ply" "${options[@]}" --quiet --report "$folder/$way-$run.json"
  done
}

# draw MESH CAMERA PICTURE: faces and edges in one colour, as the paper shows them. Drawn larger, since the viewer leaves
# out the edges of triangles of a few pixels.
draw() {
  if grep -aq -m 1 '^element face 0$' "$1"; then
    echo "paper_tables: no $(basename "$3"): no face is left" >&2
    return
  fi
  printf '%s\n' "camera $2" "color none" "show model-edges off" "show model-vertices off" >"$work/script"
  "$viewer" "$1" --headless --no-ui --theme light --size 1440x1080 --script "$work/script" --screenshot "$work/large.png"
  convert "$work/large.png" -resize 480x360 -colorspace Gray +dither -colors 48 "PNG8:$3"
}

# draw_figure FOLDER MODEL FIGURE VERTICES EDGES FACES [OPTION...]: FOLDER/figure-FIGURE.png of the mesh as read, or one
# picture for each strategy.
draw_figure() {
  local folder=$1 model=$2 figure=$3 camera strategy
  case "$model" in
    bunny) camera="front fov=30 distance=0.34 target=-0.017,0.110,0" ;;
    dragon) camera="front fov=30 distance=0.335 target=-0.006,0.125,0" ;;
  esac
  if [ $# -eq 6 ]; then
    draw "$data/$model.ply" "$camera" "$folder/figure-$figure.png"
    return
  fi
  for strategy in paper quality; do
    draw "$work/$model/$figure/$strategy-safe.ply" "$camera" "$folder/figure-$figure-$strategy.png"
  done
}

# for_each_row COMMAND ARGUMENT: COMMAND ARGUMENT ROW for the models that are here.
for_each_row() {
  local row words
  for row in "${rows[@]}"; do
    read -r -a words <<<"$row"
    [ ! -r "$data/${words[0]}.ply" ] || "$1" "$2" "${words[@]}"
  done
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
models=()
for model in bunny dragon; do
  if [ -r "$data/$model.ply" ]; then models+=("$model"); else echo "paper_tables: no $data/$model.ply; left out" >&2; fi
done
[ ${#models[@]} -gt 0 ] || exit 0

for ((run = 0; run < runs; ++run)); do for_each_row make_figure "$run"; done
python3 "$here/paper_tables.py" "$work" "$runs" "${models[@]}" >"$work/tables.md"
if [ -n "$pictures$update" ]; then
  mkdir -p "${pictures:=$work/pictures}"
  for_each_row draw_figure "$pictures"
fi
if [ -z "$update" ]; then
  cat "$work/tables.md"
  exit
fi
[ ${#models[@]} -eq 2 ] || { echo "paper_tables: docs/PAPER.md shows both models; left as it is" >&2; exit 1; }
python3 "$here/paper_tables.py" --into "$docs" "$work/tables.md"
grep -o 'pictures/paper/[a-z0-9-]*\.png' "$docs" | while read -r picture; do
  cp "$pictures/$(basename "$picture")" "$root/docs/$picture"
done
