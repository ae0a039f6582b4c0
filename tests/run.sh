#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, and passes the tests:
#   bash tests/run.sh [further arguments of ctest]
# CTest's closing line comes last; the exit code is CTest's.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}

mapfile -t packages <"$top/.ci/packages"
bash "$top/.ci/install" "${packages[@]}" libgtest-dev libbenchmark-dev clang-format-14 python3 valgrind \
  python3-numpy python3-h5py python3-jsonschema paraview python3-paraview xvfb xauth libgl1-mesa-dri

mkdir -p "$build"
if ! cmake -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBIRDSTRIKE_TESTS=ON -DBIRDSTRIKE_BENCHMARKS=ON \
       -DBIRDSTRIKE_WERROR=ON >"$build/build.log" 2>&1 ||
   ! cmake --build "$build" --parallel "$(nproc)" >>"$build/build.log" 2>&1; then
  grep -E 'error|Error|needed' "$build/build.log" | head -n 30 >&2 || true
  tail -n 10 "$build/build.log" >&2
  echo "The build failed; the whole log is $build/build.log" >&2
  exit 1
fi

cd "$build"
exec ctest --output-on-failure --parallel "$(nproc)" "$@"
