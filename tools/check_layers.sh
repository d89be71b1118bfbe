#!/usr/bin/env bash
# Every file includes only from its own layer and from layers it may know (docs/ARCHITECTURE.md). Exit code 1 and one
# line for each #include that points the wrong way.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

declare -A may_include=(
  [core/mesh]="core/mesh"
  [core/model]="core/mesh core/model"
  [core/io]="core/mesh core/model core/io"
  [core/operators]="core/mesh core/model core/io core/operators"
  [core/decimate]="core/mesh core/model core/io core/operators core/decimate"
  [core/measure]="core/mesh core/model core/io core/measure"
  [core/repair]="core/mesh core/model core/io core/repair"
  [core/samples]="core/mesh core/samples"
  [core/paper]="core/mesh core/model core/operators core/decimate core/paper"
  [viewer/scene]="core viewer/scene"
  [viewer/render]="core viewer/scene viewer/render"
  [viewer/ui]="core viewer/scene viewer/render viewer/ui"
  [viewer/app]="core viewer/scene viewer/render viewer/ui viewer/app"
  [tools/aomd]="core tools/aomd"
  [tools/bench]="core viewer tools/bench"
)

# Whether $1, a list of folders, holds a folder that is $2 or contains it.
allowed() {
  local folder
  for folder in $1; do
    [[ "$2" == "$folder" || "$2" == "$folder"/* ]] && return 0
  done
  return 1
}

bad=0
while IFS=: read -r file line text; do
  included=${text#*\"}
  included=${included%%\"*}
  folder=${file#*/}
  layer=${file%%/*}/${folder%%/*}
  case "$included" in
    core/* | viewer/* | tools/*) ;;
    *) continue ;;
  esac
  if [ -z "${may_include[$layer]:-}" ]; then
    echo "$file:$line: the layer $layer is unknown to tools/check_layers.sh"
    bad=1
  elif ! allowed "${may_include[$layer]}" "${included%/*}"; then
    echo "$file:$line: $layer must not include $included"
    bad=1
  fi
done < <(grep -rn --include='*.h' --include='*.cpp' '^#include "' core viewer tools)
exit "$bad"
