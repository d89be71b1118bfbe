#!/usr/bin/env bash
# programs.sh CMAKE BUILD WORK: installs the programs as a package does, below a folder of its own, and
# looks at what lies there. Exit code 77 where help2man is missing, after all else has been looked at.
set -euo pipefail
cmake=$1 build=$2 work=$3
fail() {
  echo "programs.sh: $*" >&2
  exit 1
}
rm -rf "$work"
components="programs viewer"
[ ! -e "$build/bin/aomd-mpi" ] || components+=" mpi"
for component in $components; do
  DESTDIR=$work "$cmake" --install "$build" --prefix /usr --component $component >/dev/null
done
[ -z "$(find "$work" -type f -not -path "$work/usr/*")" ] || fail "something lies outside of /usr"
for file in bin/aomd bin/aomd-view share/applications/aomd-view.desktop \
  share/icons/hicolor/scalable/apps/aomd-view.svg share/metainfo/aomd-view.metainfo.xml \
  share/mime/packages/aomd-view.xml share/zsh/site-functions/_aomd \
  share/fish/vendor_completions.d/aomd.fish share/bash-completion/completions/aomd \
  share/doc/aomd/copyright share/doc/aomd/changelog.gz; do
  [ -s "$work/usr/$file" ] || fail "usr/$file is missing"
done
"$work/usr/bin/aomd" --version >/dev/null
mpi=0
if [ "${components##* }" = mpi ]; then
  mpi=1
  [ -s "$work/usr/share/doc/aomd-mpi/copyright" ] || fail "aomd-mpi has no copyright"
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "$work/usr/bin/aomd-mpi" --version >/dev/null
fi

# The words that bash offers for the last one, sorted.
offered() {
  PATH=$work/usr/bin:$PATH bash -c '
    _init_completion() { words=("${COMP_WORDS[@]}") cword=$COMP_CWORD cur=${words[cword]} prev=${words[cword - 1]}; }
    _filedir() { COMPREPLY=("${1:-files}"); }
    source "$1"
    shift
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    _aomd aomd
    printf "%s\n" "${COMPREPLY[@]}" | sort' - "$work/usr/share/bash-completion/completions/aomd" "$@" | tr '\n' ' '
}
expect() {  # WANTED WORD...
  local wanted=$1 words
  shift
  words=$(offered "$@")
  [ "$words" = "$wanted " ] || fail "\"$*\" is completed to \"$words\", not \"$wanted\""
}
expect "decimate" aomd dec
expect "compare convert" aomd co
expect "--target-error --target-faces --target-tets" aomd decimate a.ply --target
expect "paper quality" aomd decimate --strategy ""
expect "files" aomd decimate ""
expect "--to" aomd convert --t
expect "-d" aomd convert --to ""
expect "sphere" aomd sample sph

command -v help2man >/dev/null || exit 77
[ "$(find "$work/usr/share/man/man1" -name 'aomd*.1.gz' | wc -l)" -eq \
  $(("$("$work/usr/bin/aomd" --help | sed -n '/^Subcommands:/,/^$/p' | grep -c '^  ')" + 3 + mpi)) ] ||
  fail "not one manual page for each program and command"
zcat "$work/usr/share/man/man1/aomd-decimate.1.gz" | grep -q '^aomd-decimate \\- Makes a mesh coarser' ||
  fail "aomd-decimate.1 has no name"
[ "$mpi" -eq 0 ] || zcat "$work/usr/share/man/man1/aomd-mpi.1.gz" | grep -q blocks ||
  fail "aomd-mpi.1 says nothing of blocks"
