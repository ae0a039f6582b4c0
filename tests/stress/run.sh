#!/usr/bin/env bash
# Strikes drawn at random, N of them from SEED on:  bash tests/stress/run.sh 200 1 [build/bin/birdstrike] [further arguments of stress.py]
# Files of scenes that fail, stop or are refused stay in stress-failures.
set -euo pipefail
cd "$(dirname "$0")/../.."
count=${1:?number of scenes}
seed=${2:?seed of the first}
program=${3:-build/bin/birdstrike}
python=python3
/usr/bin/python3 -c 'import numpy, h5py' 2>/dev/null && python=/usr/bin/python3
"$python" tests/stress/stress.py "$program" --seed "$seed" --count "$count" --jobs "$(nproc)" --keep stress-failures "${@:4}"
