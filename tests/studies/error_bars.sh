#!/usr/bin/env bash
# Error bars of the headline figures of every shipped strike, hours on one core: error_bars.md in build/error_bars.
#   bash tests/studies/error_bars.sh [CASE[:KIND]...]     (see error_bars.py)
# Installs and builds what is missing. Runs that are there are not made again.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}
bash "$top/prm/run.sh" "$top/prm/quickstart.prm" --output "$build/error_bars/first" --force >/dev/null
exec python3 "$top/tests/studies/error_bars.py" "$build/bin/birdstrike" --output "$build/error_bars" "$@"
