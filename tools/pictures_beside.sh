#!/usr/bin/env bash
# tools/pictures_beside.sh [FOLDER]: the meshes of FOLDER (../shared/data) as this viewer, F3D and MeshLab show them, side
# by side, in docs/pictures/beside, in both themes. F3D draws with its ambient occlusion, smoothing and tone mapping;
# MeshLab's window is taken as it opens. What is not installed, and meshes that are not there, are left out. Needs
# ImageMagick, and Xvfb for the others. AOMD_VIEW names the program (build/bin/aomd-view).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
viewer=${AOMD_VIEW:-$PWD/build/bin/aomd-view}
data=$(realpath "${1:-../shared/data}")
out=$PWD/docs/pictures/beside
size=600x450
work=$(mktemp -d)
started=()
finish() {
  for process in "${started[@]}"; do kill "$process" 2>/dev/null || true; done
  rm -rf "$work"
}
trap finish EXIT
mkdir -p "$out"

if command -v Xvfb >/dev/null; then
  export DISPLAY=:$((200 + $$ % 500))
  Xvfb "$DISPLAY" -screen 0 1920x1200x24 2>/dev/null &
  started+=($!)
  sleep 2
fi

# ours MESH THEME: what standard input says of it.
ours() {
  cat >"$work/script"
  "$viewer" "$1" --headless --no-ui --theme "$2" --size "$size" --script "$work/script" --screenshot "$work/ours.png"
}

# f3d_picture MESH THEME [OPTION...]
f3d_picture() {
  local mesh=$1 background=0.12,0.13,0.15
  [ "$2" = dark ] || background=0.93,0.94,0.96
  shift 2
  rm -f "$work/f3d.png"
  command -v f3d >/dev/null || return 0
  f3d "$mesh" --resolution "${size/x/,}" --bg-color "$background" --ssao --fxaa --tone-mapping "$@" \
    --output "$work/f3d.png" >/dev/null 2>&1 || true
}

# meshlab_picture MESH: the middle of its window.
meshlab_picture() {
  rm -f "$work/meshlab.png"
  command -v meshlab >/dev/null || return 0
  LIBGL_ALWAYS_SOFTWARE=1 meshlab "$1" >/dev/null 2>&1 &
  local process=$!
  sleep "${MESHLAB_SECONDS:-20}"
  import -window root -crop 700x525+80+135 +repage -resize "$size" "$work/meshlab.png" || true
  kill "$process"
  wait "$process" 2>/dev/null || true
}

# beside NAME: the pictures that there are, with who made them.
beside() {
  local -A titles=([ours]="AOMD Studio" [f3d]=F3D [meshlab]=MeshLab)
  local shown=() program
  for program in ours f3d meshlab; do
    [ ! -f "$work/$program.png" ] || shown+=(-label "${titles[$program]}" "$work/$program.png")
  done
  montage "${shown[@]}" -tile x1 -geometry 450x338+3+3 -pointsize 16 -quality 82 "$out/$1.jpg"
}

# surface NAME MESH [COMMAND...]
surface() {
  local name=$1 mesh=$data/$2
  shift 2
  [ -f "$mesh" ] || return 0
  meshlab_picture "$mesh"
  for theme in light dark; do
    printf '%s\n' "show edges off" "show occlusion on" "show ground on" "$@" wait-idle | ours "$mesh" "$theme"
    f3d_picture "$mesh" "$theme" "${round[@]}"
    beside "$name-$theme"
  done
}

# volume: cut open, which the others do not do without a click.
volume() {
  echo "sample ball-in-box
save $work/volume.vtu" >"$work/script"
  "$viewer" --headless --script "$work/script"
  rm -f "$work/meshlab.png"
  for theme in light dark; do
    ours "$work/volume.vtu" "$theme" <<'END'
clip x 0.5 cells
show occlusion on
wait-idle
END
    f3d_picture "$work/volume.vtu" "$theme" --edges "${round[@]}"
    beside "volume-$theme"
  done
}

# MeshLab measures the distance at vertices for F3D, which measures none.
distances() {
  command -v meshlabserver >/dev/null || return 0
  local parameters="" each
  for each in RichMesh:1:SampledMesh RichMesh:0:TargetMesh RichBool:false:SaveSample RichBool:true:SampleVert \
    RichBool:false:SampleEdge RichBool:false:SampleFauxEdge RichBool:false:SampleFace RichInt:3000:SampleNum; do
    IFS=: read -r kind value name <<<"$each"
    parameters+="<Param type=\"$kind\" value=\"$value\" name=\"$name\"/>"
  done
  parameters+='<Param type="RichAbsPerc" value="1" min="0" max="100" name="MaxDist"/>'
  echo "<FilterScript><filter name=\"Hausdorff Distance\">$parameters</filter></FilterScript>" >"$work/filter.mlx"
  meshlabserver -i "$1" -i "$2" -s "$work/filter.mlx" -o "$3" -m vq >/dev/null 2>&1 || true
}

distance() {
  local mesh=$data/bunny.ply
  [ -f "$mesh" ] || return 0
  local run="strategy quality
target-faces 3000
run
wait-idle"
  echo "$run
save $work/coarse.ply" >"$work/script"
  "$viewer" "$mesh" --headless --script "$work/script"
  distances "$mesh" "$work/coarse.ply" "$work/measured.ply"
  if [ -f "$work/measured.ply" ]; then
    echo "save $work/measured.vtu" >"$work/script"
    "$viewer" "$work/measured.ply" --headless --script "$work/script"
  fi
  rm -f "$work/meshlab.png" "$work/f3d.png"
  for theme in light dark; do
    ours "$mesh" "$theme" <<END
$run
color distance
show occlusion on
zoom 0.9
wait-idle
END
    [ ! -f "$work/measured.vtu" ] ||
      f3d_picture "$work/measured.vtu" "$theme" --scalars=quality --bar "${round[@]}"
    beside "distance-$theme"
  done
}

round=(--camera-azimuth-angle=30 --camera-elevation-angle=15)
surface bunny bunny.ply
surface dragon dragon.ply "show model-edges off" "show model-vertices off"
surface fandisk fandisk.off
volume
distance
