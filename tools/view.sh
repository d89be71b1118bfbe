#!/usr/bin/env bash
# tools/view.sh [MESH] [options of aomd-view]: installs what is missing, builds, and opens the viewer on MESH, or on a
# generated sample when none is given. Without a display it draws into aomd-view.png and says where that is.
set -euo pipefail
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

aomd_install_packages
aomd_build release aomd-view aomd >&2

viewer=$aomd_root/build/bin/aomd-view
has_display=${DISPLAY:-}${WAYLAND_DISPLAY:-}
for option in "$@"; do
  case "$option" in
    --headless | --headless=* | --screenshot | --screenshot=* | --script | --script=* | --help | -h | --version)
      exec "$viewer" "$@" ;;
  esac
done
[ -z "$has_display" ] || exec "$viewer" "$@"

picture=$PWD/aomd-view.png
"$viewer" "$@" --headless --screenshot "$picture"
echo "No display here: the picture is in $picture"
