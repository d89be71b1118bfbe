#!/usr/bin/env bash
# Every file includes only from its own layer and from layers it may know (docs/ARCHITECTURE.md). Exit code 1 and one
# line for each #include that points the wrong way.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

below_decimate="core/base core/mesh core/parts core/model core/fields core/io core/operators core/decimate/options.h core/decimate/counted_values.h core/decimate/quadric.h core/decimate/original_samples.h"
below_session="viewer/base viewer/document viewer/drawing viewer/explain viewer/lessons"
scene="$below_session viewer/session viewer/commands"
declare -A may_include=(
  [core/base]="core/base"
  [core/mesh]="core/base core/mesh"
  [core/parts]="core/base core/mesh core/parts"
  [core/model]="core/base core/mesh core/model"
  [core/fields]="core/base core/mesh core/model core/fields"
  [core/io]="core/base core/mesh core/parts core/model core/fields core/io"
  [core/operators]="core/base core/mesh core/model core/fields core/io core/operators"
  [core/decimate]="core/base core/mesh core/model core/fields core/io core/operators core/decimate"
  [core/decimate/curves]="$below_decimate core/decimate/curves"
  [core/decimate/spacing]="$below_decimate core/decimate/spacing"
  [core/decimate/guard]="$below_decimate core/decimate/guard"
  [core/decimate/explain]="$below_decimate core/decimate/explain"
  [core/decimate/paper]="$below_decimate core/decimate/spacing core/decimate/guard core/decimate/explain core/decimate/curves core/decimate/loop.h core/decimate/parts_at_once.h core/decimate/paper"
  [core/decimate/quality]="$below_decimate core/decimate/spacing core/decimate/guard core/decimate/explain core/decimate/curves core/decimate/loop.h core/decimate/parts_at_once.h core/decimate/quality"
  [core/decimate/volume]="$below_decimate core/decimate/spacing core/decimate/guard core/decimate/explain core/decimate/curves core/decimate/loop.h core/decimate/parts_at_once.h core/decimate/quality core/decimate/volume"
  [core/blocks]="core/base core/mesh core/parts core/model core/io core/decimate core/operators core/blocks"
  [core/measure]="core/base core/mesh core/model core/fields core/io core/measure"
  [core/repair]="core/base core/mesh core/model core/fields core/io core/repair"
  [core/samples]="core/base core/mesh core/model core/fields core/io core/samples"
  [core/paper]="core/base core/mesh core/model core/operators core/decimate core/paper"
  [core/c]="core/base core/mesh core/model core/fields core/io core/decimate core/measure core/repair core/samples core/c"
  [viewer/base]="core viewer/base"
  [viewer/document]="core viewer/base viewer/document"
  [viewer/drawing]="core viewer/base viewer/document viewer/drawing"
  [viewer/explain]="core viewer/base viewer/document viewer/drawing viewer/explain"
  [viewer/lessons]="core viewer/base viewer/document viewer/drawing viewer/lessons"
  [viewer/session]="core $below_session viewer/session"
  [viewer/commands]="core $below_session viewer/session viewer/commands"
  [viewer/suite]="core viewer/base viewer/suite"
  [viewer/render]="core viewer/base viewer/document viewer/drawing viewer/render"
  [viewer/ui]="core $scene viewer/render viewer/ui"
  [viewer/app]="core $scene viewer/suite viewer/render viewer/ui viewer/app"
  [tools/aomd]="core tools/aomd"
  [tools/mpi]="core tools/aomd tools/mpi"
  [tools/python]="core viewer tools/aomd tools/python"
  [tools/bench]="core viewer tools/bench"
)

# Whether $1, a list of folders and files, names $2 or a folder that contains it.
allowed() {
  local entry
  for entry in $1; do
    [[ "$2" == "$entry" || "$2" == "$entry"/* ]] && return 0
  done
  return 1
}

# The layer of a file: the deepest folder above it that has a row.
layer_of() {
  local folder=${1%/*}
  while [[ "$folder" == */* && -z "${may_include[$folder]:-}" ]]; do folder=${folder%/*}; done
  echo "$folder"
}

bad=0
while IFS=: read -r file line text; do
  included=${text#*\"}
  included=${included%%\"*}
  layer=$(layer_of "$file")
  case "$included" in
    core/* | viewer/* | tools/*) ;;
    *) continue ;;
  esac
  if [ -z "${may_include[$layer]:-}" ]; then
    echo "$file:$line: the layer $layer is unknown to tools/check_layers.sh"
    bad=1
  elif ! allowed "${may_include[$layer]}" "$included"; then
    echo "$file:$line: $layer must not include $included"
    bad=1
  fi
done < <(grep -rn --include='*.h' --include='*.cpp' '^#include "' core viewer tools)
exit "$bad"
