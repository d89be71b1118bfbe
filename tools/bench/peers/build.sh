# shellcheck shell=bash
# Sourced by what measures other libraries. build_peers ROOT BUILD LOG [TARGET...]: builds the programs aomd-peer-* of
# tools/bench/peers and the TARGETs in the folder BUILD, and names the libraries that are missing.
build_peers() {
  local root=$1 build=$2 log=$3 peers
  shift 3
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DAOMD_BENCH_PEERS=ON -DAOMD_BUILD_VIEWER=OFF \
    -DAOMD_BUILD_TESTS=OFF | sed -n 's/^-- Peers: /not compared: /p'
  peers=$(ninja -C "$build" -t targets all | sed -n 's/^\(aomd-peer-[a-z]*\): phony$/\1/p')
  # shellcheck disable=SC2086  # the list is words
  ninja -C "$build" $peers "$@" >"$log" || { tail -40 "$log" >&2; return 1; }
}
