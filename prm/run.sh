#!/usr/bin/env bash
# Installs what is missing, builds the program and runs a parameter file:
#   bash prm/run.sh prm/frontal.prm [further arguments of `birdstrike run`]
# Further arguments and the exit code pass through. An up-to-date program is not built again, in silence.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}

[ $# -ge 1 ] || { echo "usage: bash prm/run.sh FILE.prm [arguments of 'birdstrike run']" >&2; exit 2; }

mapfile -t packages <"$top/.ci/packages"
bash "$top/.ci/install" "${packages[@]}"

options=()
[ -f "$build/Makefile" ] || options=(-DCMAKE_BUILD_TYPE=Release -DBIRDSTRIKE_TESTS=OFF)
bash "$top/.ci/build" "$build" birdstrike -- "${options[@]}"

exec "$build/bin/birdstrike" run "$@"
