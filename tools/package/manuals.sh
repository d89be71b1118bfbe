#!/usr/bin/env bash
# manuals.sh AOMD VIEW MPI FOLDER: writes the manual pages of the programs and of each command of aomd,
# from what their --help says (help2man). Programs may be empty, but for one.
set -euo pipefail
aomd=$1 view=$2 mpi=$3 folder=$4
mkdir -p "$folder"
version=$("${aomd:-${view:-$mpi}}" --version | cut -d' ' -f2)
page() {  # NAME PROGRAM HELP-OPTION DESCRIPTION
  help2man --no-info --section 1 --name "$4" --help-option "$3" --version-string "$1 $version" \
    --manual "AOMD Studio" --source "AOMD Studio $version" --output "$folder/$1.1" "$2"
  sed -i "s/^\.TH [^ ]*/.TH ${1^^}/; s/^[^ ]* \\\\- /$1 \\\\- /" "$folder/$1.1"
  gzip -9nf "$folder/$1.1"
}
if [ -n "$view" ]; then
  page aomd-view "$view" --help "$("$view" --help | head -1)"
  page aomd-view-test "$view" "test --help" "$("$view" test --help | head -1)"
fi
if [ -n "$mpi" ]; then
  page aomd-mpi "$mpi" "decimate --help" "aomd decimate for processes that mpirun starts"
fi
if [ -n "$aomd" ]; then
  page aomd "$aomd" --help "$("$aomd" --help | head -1)"
  "$aomd" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\)  *\(.*\)/\1\t\2/p' |
    while IFS=$'\t' read -r name what; do
      page "aomd-$name" "$aomd" "$name --help" "$what"
    done
fi
