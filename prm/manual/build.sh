#!/usr/bin/env bash
# Makes the manual as pages of HTML, with a search that needs no server:
#   bash prm/manual/build.sh [FOLDER]      default build/manual; the first page is FOLDER/index.html
# Installs what is missing, and builds the program if there is none: it lists the entries. Warnings are errors.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}
folder=${1:-$build/manual}
program=$build/bin/birdstrike

[ $# -le 1 ] || { echo "usage: bash prm/manual/build.sh [FOLDER]" >&2; exit 2; }

# A folder of something else is not replaced.
if [ -e "$folder" ] && [ -n "$(ls -A "$folder")" ] && [ ! -f "$folder/searchindex.js" ]; then
  echo "$folder holds other files: give another folder." >&2
  exit 2
fi

python=python3
if ! "$python" -c 'import sphinx, myst_parser, furo' 2>/dev/null; then
  python=/usr/bin/python3 # whose modules are Debian's
  bash "$top/.ci/install" python3-sphinx python3-myst-parser furo
fi

if [ ! -x "$program" ]; then
  mapfile -t packages <"$top/.ci/packages"
  bash "$top/.ci/install" "${packages[@]}"
  options=()
  [ -f "$build/Makefile" ] || options=(-DCMAKE_BUILD_TYPE=Release -DBIRDSTRIKE_TESTS=OFF)
  bash "$top/.ci/build" "$build" birdstrike -- "${options[@]}"
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$python" "$top/prm/manual/entries.py" "$program" "$work/pages/entries"
"$python" "$top/prm/manual/site/collect.py" "$top" "$work/pages"
"$python" -m sphinx -q -W --keep-going -b html -c "$top/prm/manual/site" -d "$work/trees" "$work/pages" "$work/html"
# Debian's theme asks for a style sheet in a folder of a web server; manual.css does what is needed of it.
sed -i '/^@import url(\/javascript/d' "$work"/html/_static/styles/*.css

rm -rf "$folder"
mkdir -p "$folder"
cp -r "$work/html/." "$folder"
echo "The manual is $folder/index.html"
