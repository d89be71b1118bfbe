#!/usr/bin/env bash
# tools/update_baselines.sh [BUILD] [NAME...]: makes the pictures in tests/baselines anew, all or the named ones:
# those of tests/scripts/NAME.aomd, and the four of each tests/scripts/panels/NAME.aomd, named panels/NAME.
# Look at every one that changed before it is committed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(cd "${1:-$root/build}" && pwd)
shift || true
names=("$@")
cd "$root/tests/scripts"
if [ ${#names[@]} -eq 0 ]; then
  for script in *.aomd panels/*.aomd; do names+=("${script%.aomd}"); done
fi
baselines=$root/tests/baselines
mkdir -p "$baselines/panels"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture OUT.png OPTIONS...
picture() {
  "$build/bin/aomd-view" --headless "${@:2}" --screenshot "$baselines/$1"
  echo "tests/baselines/$1"
}

for name in "${names[@]}"; do
  script=$root/tests/scripts/$name.aomd
  if [ "${name#panels/}" = "$name" ]; then
    read -r -a options <<<"$(sed -n '1s/^# options: //p' "$script")"
    (cd "$root/tests" && picture "$name.png" --size 960x600 --script "$script" "${options[@]}")
    continue
  fi
  for theme in light dark; do
    for screen in "1280x800 1" "1920x1080 1.5"; do
      read -r size scale <<<"$screen"
      options=()
      if [ "$name" = panels/dialog_recovery ]; then
        cp recovery/* "$work"
        options=(--recovery "$work")
      fi
      (export TZ=UTC HOME=$PWD/home && cd home/meshes &&
        picture "${name}_${theme}_$size.png" --transparent --theme "$theme" --size "$size" --scale "$scale" --script "$script" "${options[@]}")
    done
  done
done
