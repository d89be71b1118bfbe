#!/usr/bin/env bash
# tools/readme_pictures.sh: makes the pictures in docs/pictures anew, with the program itself, from generated meshes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
viewer=${1:-build/bin/aomd-view}
script=$(mktemp)
trap 'rm -f "$script"' EXIT

# picture NAME THEME: draws the script on standard input into docs/pictures/NAME.png.
picture() {
  cat >"$script"
  "$viewer" --headless --size 1280x800 --theme "$2" --script "$script" --screenshot "docs/pictures/$1.png"
}

picture scan light <<'END'
sample scan
camera front up=z
orbit 25 15
factor 8
run
wait-idle
END

picture bracket dark <<'END'
sample bracket
coarsest on
sweep
wait-idle
END

picture volume light <<'END'
sample mixed
panel adjacency
adjacency 0 3 on
adjacency 3 2 on
wait-idle
END

picture why light <<'END'
sample scan 4000
run
wait-idle
panel selection on
select edge 4759
fit selection
wait-idle
END

picture tetrahedra light <<'END'
sample ball-in-box
clip x 0.5 cells
strategy quality
target-faces 5000
run
wait-idle
END
