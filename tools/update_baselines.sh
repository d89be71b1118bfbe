#!/usr/bin/env bash
# tools/update_baselines.sh [BUILD] [NAME...]: makes the pictures in tests/baselines anew, all or the named ones.
# Look at every one that changed before it is committed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build}
shift || true
names=("$@")
if [ ${#names[@]} -eq 0 ]; then
  for script in "$root"/tests/scripts/*.aomd; do names+=("$(basename "$script" .aomd)"); done
fi
cd "$root/tests"
for name in "${names[@]}"; do
  script=scripts/$name.aomd
  options=$(sed -n '1s/^# options: //p' "$script")
  # shellcheck disable=SC2086  # the options are several words
  "$build/bin/aomd-view" --headless --size 960x600 --script "$script" --screenshot "baselines/$name.png" $options
  echo "baselines/$name.png"
done
