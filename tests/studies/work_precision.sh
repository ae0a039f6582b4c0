#!/usr/bin/env bash
# Error against run time of every choice of method, some half an hour on one core: tables and charts in build/work_precision.
#   bash tests/studies/work_precision.sh [GROUP...]     (groups: see work_precision.py)
# Installs and builds what is missing. Runs that are there are not made again.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}
bash "$top/prm/run.sh" "$top/prm/quickstart.prm" --output "$build/work_precision/first" --force >/dev/null
exec python3 "$top/tests/studies/work_precision.py" "$build/bin/birdstrike" --output "$build/work_precision" ${@:+--only "$@"}
