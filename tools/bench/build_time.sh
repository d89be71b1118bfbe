#!/usr/bin/env bash
# tools/bench/build_time.sh [-DVARIABLE=VALUE...]: CPU seconds of the compiler for what
# tools/view.sh builds, by library, as the table of docs/BUILDING.md. Builds the release preset with
# these settings in a folder of its own, without ccache, and removes it.
set -euo pipefail

# As the launcher of the compiler: runs it and adds a line "LIBRARY USER SYSTEM", in seconds, to
# AOMD_UNIT_TIMES.
if [ "${1:-}" = --unit ]; then
  shift
  TIMEFORMAT='%U %S'
  seconds=$({ time "$@" 2>&3; } 3>&2 2>&1)
  for word in "$@"; do
    case "$word" in *CMakeFiles/*.dir/*) library=${word#*CMakeFiles/} ;; esac
  done
  echo "${library%%.dir/*} $seconds" >>"$AOMD_UNIT_TIMES"
  exit
fi

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export AOMD_UNIT_TIMES=$folder/times CCACHE_DISABLE=1

(cd "$root" && cmake --preset release -B "$folder/build" -G Ninja \
  "-DCMAKE_CXX_COMPILER_LAUNCHER=bash;$root/tools/bench/build_time.sh;--unit" "$@") >"$folder/log"
cmake --build "$folder/build" --target aomd-view aomd >>"$folder/log" ||
  { cat "$folder/log" >&2; exit 1; }

echo "| library | units | CPU s | CPU s a unit |"
echo "|---|---:|---:|---:|"
sort "$AOMD_UNIT_TIMES" | awk '
  function row(name) {
    printf "| %s | %d | %.0f | %.1f |\n", name, units[name], sum[name], sum[name] / units[name]
  }
  { ++units[$1]; sum[$1] += $2 + $3; ++units["all"]; sum["all"] += $2 + $3 }
  $1 != last { if (last != "") row(last); last = $1 }
  END { row(last); row("all") }'
