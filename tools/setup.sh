#!/usr/bin/env bash
# What tools/view.sh and tools/test.sh share: installs what is missing, configures, builds.
# Sourced, it only defines functions; run by itself, it installs the packages.
set -euo pipefail

aomd_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

aomd_packages=(build-essential cmake ninja-build pkg-config
  libglm-dev libtinyobjloader-dev libpng-dev libjpeg-dev libpugixml-dev libmuparser-dev zlib1g-dev libcgal-dev libcli11-dev nlohmann-json3-dev libgtest-dev
  libglfw3-dev libimgui-dev libstb-dev libtomlplusplus-dev libgl-dev libegl-dev libgl1-mesa-dri fonts-inter fonts-jetbrains-mono)
# Used where the distribution has them: Mesa 25.1 dropped OSMesa, EGL then draws without a display; Gmsh reads CAD models;
# tinygltf reads and writes glTF; tests drive the real window on a screen of Xvfb; help2man makes manual pages; pybind11
# and NumPy make `import aomd`; MPI makes `aomd-mpi`.
aomd_optional_packages=(libosmesa6-dev libgmsh-dev xvfb libxtst-dev help2man
  libtinygltf-dev pybind11-dev python3-dev python3-numpy python3-pytest
  libopenmpi-dev openmpi-bin)

aomd_fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

aomd_missing() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null)" = "install ok installed" ] || echo "$package"
  done
}

aomd_as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

aomd_apt() {
  aomd_as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 "$@"
}

# Installs the packages that are missing; one quick question to dpkg when none are.
aomd_install_packages() {
  command -v dpkg-query >/dev/null ||
    { echo "$(basename "$0"): no dpkg here; trusting that these are installed: ${aomd_packages[*]}" >&2; return; }
  local missing optional package
  missing=$(aomd_missing "${aomd_packages[@]}" | tr '\n' ' ')
  optional=$(aomd_missing "${aomd_optional_packages[@]}")
  [ -n "$missing$optional" ] || return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    [ -z "$missing" ] && return 0
    aomd_fail "missing packages, and neither root nor sudo to install them: $missing"
  fi
  local candidates=""
  [ -z "$missing" ] || aomd_apt update || echo "$(basename "$0"): apt-get update failed; trying with old lists" >&2
  for package in $optional; do
    apt-cache show "$package" >/dev/null 2>&1 && candidates+=" $package"
  done
  [ -n "$missing$candidates" ] || return 0
  echo "Installing: $missing$candidates" >&2
  # shellcheck disable=SC2086  # the lists are words
  aomd_apt install -y --no-install-recommends $missing $candidates >/dev/null || {
    missing=$(aomd_missing "${aomd_packages[@]}" | tr '\n' ' ')
    [ -z "$missing" ] || aomd_fail "these packages could not be installed: $missing"
  }
}

# As many jobs as processors, but no more than one for each 1.5 GB of free memory.
aomd_jobs() {
  local processors free_mb by_memory
  processors=$(nproc)
  free_mb=$(awk '/^MemAvailable/ {print int($2 / 1024)}' /proc/meminfo 2>/dev/null || true)
  by_memory=$((${free_mb:-1536} / 1536))
  [ "$by_memory" -ge 1 ] || by_memory=1
  echo $((processors < by_memory ? processors : by_memory))
}

# aomd_build PRESET [TARGET...] [-DVARIABLE=VALUE...]: quiet unless something fails.
aomd_build() {
  local preset=$1 argument targets=() settings=() folder
  shift
  for argument in "$@"; do
    case "$argument" in
      -D*) settings+=("$argument") ;;
      *) targets+=("$argument") ;;
    esac
  done
  case "$preset" in
    release) folder=$aomd_root/build ;;
    *) folder=$aomd_root/build/$preset ;;
  esac
  if [ ! -f "$folder/CMakeCache.txt" ]; then
    ! command -v ninja >/dev/null || settings+=(-G Ninja)
    ! command -v ccache >/dev/null || settings+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  if [ ! -f "$folder/CMakeCache.txt" ] || [ ${#settings[@]} -gt 0 ]; then
    (cd "$aomd_root" && cmake --preset "$preset" "${settings[@]}" >/dev/null)
  fi
  cmake --build "$folder" -j "$(aomd_jobs)" ${targets[@]:+--target "${targets[@]}"}
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
  aomd_install_packages
  echo "All packages are installed."
fi
