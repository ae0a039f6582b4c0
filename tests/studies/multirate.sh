#!/usr/bin/env bash
# What ratio of steps pays, and what error it brings: the frontal strike on coarse and fine blades with growing limits of
# the ratio. Usage: multirate.sh PROGRAM [MESHES [LIMITS [further arguments of the program]]]
#   bash tests/studies/multirate.sh build/bin/birdstrike "31x9 62x18 124x36" "1 2 4 8" --set "Time/Threads=1"
# Columns: elements, largest ratio allowed, time steps, bird and blade steps to each of them, run time (s), tip at 2 ms
# (mm), its difference from ratio 1 (%), largest energy error (%).
set -euo pipefail
program=$1
meshes=${2:-31x9 62x18 124x36}
limits=${3:-1 2 3 4 6 8}
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

printf '%-9s %5s %8s %7s %8s %9s %10s %8s %10s\n' elements limit steps bird blade time tip change energy
for mesh in $meshes; do
  reference=
  for limit in $limits; do
    "$program" run --force "$top/prm/frontal.prm" --output "$folder/run" --set "Time/End time=2e-3" \
      --set "Time/Maximum ratio=$limit" --set "Blade/Mesh/Elements along span=${mesh%x*}" \
      --set "Blade/Mesh/Elements along chord=${mesh#*x}" --set "Output/Blade fields=false" \
      --set "Output/Bird fields=false" "${@:4}" >"$folder/log"
    macro=$(sed -nE 's/^ +time steps +([0-9 ]+) \(with.*/\1/p' "$folder/log" | tr -d ' ')
    read -r bird blade time tip energy < <(python3 - "$folder/run/summary.json" <<'PYTHON'
import json, sys
s = json.load(open(sys.argv[1]))
print(s["steps"]["bird"], s["steps"]["blade"], s["cost"]["wall"], s["tip"]["final"], s["energy"]["max_relative_error"])
PYTHON
    )
    reference=${reference:-$tip}
    awk -v mesh="$mesh" -v limit="$limit" -v n="$macro" -v bird="$bird" -v blade="$blade" -v time="$time" \
      -v tip="$tip" -v reference="$reference" -v energy="$energy" 'BEGIN {
        printf "%-9s %5d %8d %7.2f %8.2f %9.2f %10.4f %+8.3f %10.4f\n", mesh, limit, n, bird / n, blade / n, time,
          1e3 * tip, 100 * (tip / reference - 1), 100 * energy }'
  done
done
