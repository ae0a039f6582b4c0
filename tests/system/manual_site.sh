#!/usr/bin/env bash
# The manual becomes a site without warnings, whole, and without a request to another machine.
# Usage: manual_site.sh PROGRAM TOP FOLDER
set -euo pipefail
program=$1 top=$2 folder=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export BIRDSTRIKE_BUILD
BIRDSTRIKE_BUILD=$(dirname "$(dirname "$program")")
bash "$top/prm/manual/build.sh" "$folder"

n_failed=0
expect() # NAME COMMAND...: the command succeeds
{
  local name=$1
  shift
  "$@" >/dev/null 2>&1 || { echo "FAILED $name"; n_failed=$((n_failed + 1)); }
}
for chapter in "$top"/prm/manual/*.md; do
  expect "a page of $(basename "$chapter")" test -s "$folder/prm/manual/$(basename "$chapter" .md).html"
  [ "$(basename "$chapter")" = README.md ] ||
    expect "$(basename "$chapter") in the table of chapters" grep -q "($(basename "$chapter"))" "$top/prm/manual/README.md"
done
expect "entries of the bird" grep -q 'Particle</span> <span class="pre">spacing' "$folder/entries/bird.html"
expect "entries of checkpoints" grep -q 'Step</span> <span class="pre">interval' "$folder/entries/output.html"
expect "units of entries" grep -q "kg/m^3" "$folder/entries/bird.html"
expect "the search knows entries" grep -q "entries/bird" "$folder/searchindex.js"
python3 "$here/site_links.py" "$folder" || n_failed=$((n_failed + 1))

mkdir -p "$folder.else" && echo x >"$folder.else/mine.txt"
if bash "$top/prm/manual/build.sh" "$folder.else" >/dev/null 2>&1 || [ ! -s "$folder.else/mine.txt" ]; then
  echo "FAILED a folder of somebody else is kept"
  n_failed=$((n_failed + 1))
fi
rm -rf "$folder.else"
[ "$n_failed" -eq 0 ] && echo "the manual is a site"
exit "$((n_failed > 0))"
