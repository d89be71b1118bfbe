#!/usr/bin/env bash
# Builds the programs and makes Debian packages of them: build/packages/*.deb (docs/INSTALL.md).
set -euo pipefail
# shellcheck source=../setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"
aomd_packages+=(help2man file)
aomd_install_packages
# Where Debian has libraries, so that those of several architectures can be installed together.
aomd_build release aomd_installed "-DCMAKE_INSTALL_LIBDIR=lib/$(c++ -print-multiarch)"
cd "$aomd_root/build"
cpack -G DEB -B packages >/dev/null
rm -rf packages/_CPack_Packages
ls packages/*.deb
