#!/usr/bin/env bash
# The whole verification ladder at full size, some ten minutes on two cores:
#   bash tests/verification/run.sh [build/bin/birdstrike] [further arguments of ladder.py, e.g. --update or --cases "C9 E"]
# Builds the tests that it needs where the program's folder is a build; leaves ladder.md, ladder.csv, ladder.svg in build/verification.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=${1:-build/bin/birdstrike}
build=$(dirname "$(dirname "$program")")
[ ! -f "$build/CMakeCache.txt" ] || cmake --build "$build" --target birdstrike structure_tests bird_tests contact_tests simulation_tests -j "$(nproc)"
python=python3
/usr/bin/python3 -c 'import numpy, h5py' 2>/dev/null && python=/usr/bin/python3
"$python" tests/verification/ladder.py "$program" --output build/verification "${@:2}"
