#!/usr/bin/env bash
# Installs what is missing, builds the program and runs a parameter file:
#   bash prm/run.sh prm/frontal.prm [further arguments of `birdstrike run`]
# Further arguments and the exit code pass through; quiet when there is nothing to install or build.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}

[ $# -ge 1 ] || { echo "usage: bash prm/run.sh FILE.prm [arguments of 'birdstrike run']" >&2; exit 2; }

mapfile -t packages <"$top/.ci/packages"
bash "$top/.ci/install" "${packages[@]}"

mkdir -p "$build"
[ -x "$build/bin/birdstrike" ] || echo "Building birdstrike in $build (once; a few minutes)" >&2
if ! { [ -f "$build/Makefile" ] || cmake -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBIRDSTRIKE_TESTS=OFF; } >"$build/build.log" 2>&1 ||
   ! cmake --build "$build" --target birdstrike --parallel "$(nproc)" >>"$build/build.log" 2>&1; then
  tail -n 30 "$build/build.log" >&2
  echo "The build failed; the whole log is $build/build.log" >&2
  exit 1
fi

exec "$build/bin/birdstrike" run "$@"
