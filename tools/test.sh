#!/usr/bin/env bash
# tools/test.sh [options of ctest]: installs what is missing, builds, runs every test; ends with ctest's summary.
set -euo pipefail
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

aomd_install_packages
# AOMD_CMAKE_ARGS: more settings for the build, e.g. -DAOMD_WERROR=ON (used by .ci/run).
read -r -a settings <<<"${AOMD_CMAKE_ARGS:-}"
aomd_build release "${settings[@]}" >&2
cd "$aomd_root"
exec ctest --preset release -j "$(nproc)" "$@"
