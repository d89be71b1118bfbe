#!/usr/bin/env bash
# packages.sh PACKAGES CHROOT: installs the Debian packages of a folder in a clean Debian 12, runs what
# they bring, builds tests/consumer against them with CMake, pkg-config, C and Python, and removes them
# again. CHROOT is made by debootstrap where it is not there, and kept. For root, with a mirror.
set -euo pipefail
packages=$(realpath "$1") chroot=$2
consumer=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../consumer")
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
[ -e "$chroot/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$chroot" >/dev/null
chroot=$(realpath "$chroot")
inside() { chroot "$chroot" /bin/bash -euo pipefail -c "$1"; }
rm -rf "$chroot/try"
mkdir -p "$chroot/try"
cp "$packages"/*.deb "$chroot/try"
cp -r "$consumer" "$chroot/try/consumer"

inside 'apt-get update -q && apt-get install -qy -o Dpkg::Use-Pty=0 --no-install-recommends /try/*.deb' >/dev/null
inside 'cd /try && aomd --version && aomd sample bracket b.stl && mkdir o &&
  aomd decimate --to o --target-faces 20% --format ply --quiet b.stl && aomd info o/b.ply | head -1'
inside 'cd /try && aomd-view o/b.ply --headless --screenshot b.png --size 320x240 && [ -s b.png ]'
inside 'cd /try && [ ! -e /usr/bin/aomd-mpi ] || { aomd convert b.stl b.ply &&
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n 2 \
    aomd-mpi decimate b.ply c.ply --blocks 2 --target-faces 20% && echo "MPI: done"; }'
inside 'cd /try && mkdir files && python3 consumer/consumer.py files && echo "python: done"'

inside 'apt-get install -qy -o Dpkg::Use-Pty=0 --no-install-recommends g++ make cmake pkg-config nlohmann-json3-dev' >/dev/null
inside 'cd /try && cmake -S consumer -B build >/dev/null && cmake --build build >/dev/null &&
  for program in core shared c scene; do build/consumer_$program files; echo "CMake, $program: done"; done'
inside 'cd /try && g++ -std=c++20 consumer/consumer.cpp -o cpp $(pkg-config --cflags --libs aomd) &&
  cc -std=c99 consumer/consumer.c -o c $(pkg-config --cflags --libs aomd) -lm &&
  ./cpp files && ./c files && echo "pkg-config: done"'

inside 'apt-get purge -qy -o Dpkg::Use-Pty=0 $(dpkg-query -W -f "\${Package}\n" | grep aomd) && rm -rf /try' >/dev/null
left=$(inside 'find / -xdev -iname "*aomd*" -not -path "/proc/*" -not -path "/var/cache/*"')
[ -z "$left" ] || { echo "packages.sh: left behind: $left" >&2; exit 1; }
echo "removed: nothing is left"
