#!/usr/bin/env bash
# tools/tidy.sh: the checks of .clang-tidy over core, tools and viewer. Fails where one of them finds
# something. Needs no build. As headers take most of the time, the files of a folder are checked as
# one file that includes them, as the release preset compiles them.
set -euo pipefail
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

cd "$aomd_root"
folder=build/tidy
settings=(-DAOMD_BUILD_TESTS=OFF -DCMAKE_UNITY_BUILD=ON -DAOMD_UNITY_EVERYWHERE=ON)
[ -f $folder/CMakeCache.txt ] || ! command -v ninja >/dev/null || settings+=(-G Ninja)
cmake --preset dev -B $folder "${settings[@]}" >/dev/null

# The analyzer takes what a source includes for a header, unless the source is called UnifiedSource*.
mkdir -p $folder/commands
sed 's/unity_\([a-z0-9_]*\)_cxx\.cxx/UnifiedSource_\1.cpp/g' $folder/compile_commands.json \
  >$folder/commands/compile_commands.json
find $folder -name 'unity_*_cxx.cxx' | while read -r source; do
  name=$(basename "$source" _cxx.cxx)
  cp "$source" "$(dirname "$source")/UnifiedSource_${name#unity_}.cpp"
done

# What is said to standard error is how many warnings were left out.
sed -n 's/^ *"file": "\(.*\)".*/\1/p' $folder/commands/compile_commands.json |
  grep -v '_texts\.cpp$' |
  xargs -P "$(aomd_jobs)" -n 1 \
    clang-tidy --quiet --warnings-as-errors='*' -p $folder/commands 2>/dev/null
