#!/usr/bin/env bash
# tests/cli/mpi_test.sh AOMD AOMD-MPI: processes that share the blocks of a surface come to what one comes to, and end
# together.
set -euo pipefail
aomd=$1 shared=$2
command -v mpirun >/dev/null || { echo "mpirun is missing"; exit 77; }
# More processes than cores, also as root, without a network.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() {
  echo "FAILED: $*"
  cat out err 2>/dev/null
  exit 1
}

run() {  # PROCESSES ARGUMENT...
  local count=$1
  shift
  mpirun -n "$count" "$shared" "$@" >out 2>err
}

"$aomd" sample scan s.ply --size 20000
for target in 300 2000; do
  "$aomd" decimate s.ply one.ply --blocks 5 --target-faces $target --quiet
  for count in 1 2 3 4; do
    run $count decimate s.ply o.ply --blocks 5 --target-faces $target || fail "$count processes"
    cmp one.ply o.ply || fail "$count processes come to something else"
    [ "$(grep -c "Euler number" out)" -eq 1 ] || fail "not said once"
  done
done

# STL, whose facets each process welds by itself, and pieces of VTU, as input and as output.
"$aomd" convert s.ply s.stl
"$aomd" convert s.ply s.pvtu --pieces 3
for input in s.stl s.pvtu; do
  "$aomd" decimate $input one.pvtu --blocks 5 --target-faces 300 --pieces 2 --quiet
  run 3 decimate $input o.pvtu --blocks 5 --target-faces 300 --pieces 2 || fail "$input"
  for piece in 0 1; do cmp one_$piece.vtu o_$piece.vtu || fail "$input comes to something else"; done
done

code=0
run 3 decimate missing.ply o.ply --blocks 5 --target-faces 300 || code=$?
[ $code -eq 3 ] || fail "a missing input ends with $code"
[ "$(grep -c "^aomd: missing.ply: is no file" err)" -eq 1 ] || fail "not said once"
code=0
run 2 decimate s.ply o.ply --blocks 5 || code=$?
[ $code -eq 2 ] || fail "wrong usage ends with $code"

# One that is killed ends all, and leaves the old output.
"$aomd" sample scan big.ply --size 400000
echo old >o.ply
mpirun -n 3 "$shared" decimate big.ply o.ply --blocks 9 --target-faces 5000 >out 2>err &
mpirun=$!
victim=""
for _ in $(seq 100); do
  victim=$(pgrep -P "$mpirun" -x aomd-mpi | tail -1) || true
  [ -z "$victim" ] || break
  sleep 0.05
done
[ -n "$victim" ] || fail "nobody to kill"
sleep 0.2
kill -9 "$victim"
code=0
wait "$mpirun" || code=$?
[ $code -eq 137 ] || fail "a killed process went by"
[ "$(cat o.ply)" = old ] || fail "the old output is gone"
