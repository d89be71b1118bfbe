#!/usr/bin/env bash
# tests/cli/paper_tables_test.sh AOMD: tools/bench/paper_tables.sh on a generated mesh in place of the bunny.
set -euo pipefail
export AOMD=$1
bench=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../tools/bench" && pwd)
command -v python3 >/dev/null || { echo "python3 is missing"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export AOMD_DATA=$work
cd "$work"

fail() {
  echo "FAILED: $*"
  cat out err 2>/dev/null
  exit 1
}

tables() {
  "$bench/paper_tables.sh" "$@" >out 2>err
}

tables --help || fail "--help is an error"
grep -q -- '--update-docs' out || fail "--help does not name --update-docs"
for options in "--wrong" "-n 0" "-n" "--pictures"; do
  code=0
  # shellcheck disable=SC2086  # the options are words
  tables $options || code=$?
  [ $code -eq 2 ] || fail "$options ends with $code"
done

tables || fail "without models"
{ [ ! -s out ] && grep -q 'bunny.ply; left out' err; } || fail "without models it does not say so"

"$AOMD" sample scan "$work/bunny.ply" --size 1000 >/dev/null
faces=$("$AOMD" info bunny.ply --json | sed -n 's/.*"faces": \([0-9]*\),.*/\1/p')
tables -n 1 || fail "with one model"
grep -q 'dragon.ply; left out' err || fail "the missing dragon is not named"
grep -q 'Table 1' out || fail "no Table 1"
! grep -q 'Table 2' out || fail "Table 2 without a dragon"
grep -q '^| \*\*9\*\* | the paper | 4,567 | 4,567 | 10,294 | 6,837 | 77 | 77 | 1,110 | ' out || fail "the paper's row of Figure 9"
[ "$(grep -c '^|  | `--strategy ' out)" -eq 16 ] || fail "not four ways for each of four figures"
sed 's/,//g' out | grep -q "^|  | as read | .* | $faces | " || fail "the generated mesh has $faces faces"
[ -z "$(awk -F'|' '/^\|/ && NF != 15' out)" ] || fail "rows of different lengths"

printf 'before\n<!-- tables: begin -->\nold\n<!-- tables: end -->\nafter\n' >doc.md
python3 "$bench/paper_tables.py" --into doc.md out
{ printf 'before\n<!-- tables: begin -->\n' && cat out && printf '<!-- tables: end -->\nafter\n'; } >wanted.md
cmp doc.md wanted.md || fail "the document around the tables has changed"
echo "no markers" >doc.md
! python3 "$bench/paper_tables.py" --into doc.md out 2>err || fail "a document without markers is changed"
[ "$(cat doc.md)" = "no markers" ] || fail "a document without markers is changed"
