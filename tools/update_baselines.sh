#!/usr/bin/env bash
# tools/update_baselines.sh [BUILD] [NAME...]: makes the pictures in tests/baselines anew, all or those of the named
# cases of tests/pictures.toml and tests/panels.toml; recovery: those of the dialog on work that was left.
# Look at every one that changed before it is committed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(cd "${1:-$root/build}" && pwd)
shift || true
export TZ=UTC HOME=$root/tests/scripts/home
cd "$root/tests"

# update SUITE [NAME...]: all of its cases, or those that it has of the names.
update() {
  local suite=$1 name known=()
  shift
  for name in "$@"; do
    ! grep -q "^$name = " "$suite" || known+=("$name")
  done
  [ $# -eq 0 ] || [ ${#known[@]} -gt 0 ] || return 0
  "$build/bin/aomd-view" test "$suite" --jobs 2 --update "${known[@]}"
}
update pictures.toml "$@"
update panels.toml "$@"

case " ${*:-recovery} " in *" recovery "*) ;; *) exit ;; esac
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd scripts/home/meshes
for theme in light dark; do
  for screen in "1280x800 1" "1920x1080 1.5"; do
    read -r size scale <<<"$screen"
    cp ../../recovery/* "$work"
    "$build/bin/aomd-view" --headless --transparent --theme "$theme" --size "$size" --scale "$scale" \
      --script ../../panels/dialog_recovery.aomd --recovery "$work" \
      --screenshot "$root/tests/baselines/panels/dialog_recovery_${theme}_$size.png"
  done
done
