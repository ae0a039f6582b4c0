#!/usr/bin/env bash
# Installs what is missing, builds, times every kernel and three reference runs on one and two threads, and writes the
# table of speeds in tests/README.md to stdout:
#   bash tests/benchmarks/run.sh [arguments of Google Benchmark, e.g. --benchmark_filter=bird]
# All that was measured, the table and the roofline picture stay in build/speed. Ten minutes on two cores, which should
# have nothing else to do. BIRDSTRIKE_REPEATS (3) is the number of times each reference run is repeated; BIRDSTRIKE_BEFORE is
# such a folder build/speed of another program on this machine, which the table then sets beside.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BIRDSTRIKE_BUILD:-$top/build}
repeats=${BIRDSTRIKE_REPEATS:-3}
results=$build/speed
before=${BIRDSTRIKE_BEFORE:-}
[ -z "$before" ] || [ -f "$before/benchmarks.json" ] || { echo "BIRDSTRIKE_BEFORE: there is no $before/benchmarks.json" >&2; exit 1; }

mapfile -t packages <"$top/.ci/packages"
bash "$top/.ci/install" "${packages[@]}" libbenchmark-dev python3 python3-matplotlib

mkdir -p "$results"
if ! cmake -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBIRDSTRIKE_TESTS=OFF -DBIRDSTRIKE_BENCHMARKS=ON \
       >"$build/build.log" 2>&1 ||
   ! cmake --build "$build" --target birdstrike benchmarks --parallel "$(nproc)" >>"$build/build.log" 2>&1; then
  grep -E 'error|Error|needed' "$build/build.log" | head -n 30 >&2 || true
  tail -n 10 "$build/build.log" >&2
  echo "The build failed; the whole log is $build/build.log" >&2
  exit 1
fi

commit=$(git -C "$top" describe --always --dirty 2>/dev/null || echo unknown)
echo "Timing the kernels" >&2
"$build/bin/benchmarks" --benchmark_out="$results/benchmarks.json" --benchmark_out_format=json \
  --benchmark_context=commit="$commit" "$@" >"$results/benchmarks.txt" 2>&1 ||
  { tail -n 10 "$results/benchmarks.txt" >&2; exit 1; }

# name, parameter file, overrides
run() {
  local name=$1 file=$2
  shift 2
  for threads in 1 2; do
    for repeat in $(seq "$repeats"); do
      echo "Running $name on $threads thread(s), $repeat of $repeats" >&2
      "$build/bin/birdstrike" run --force "$top/prm/$file" "$@" --set "Time/Threads=$threads" \
        --output "$results/$name-$threads-$repeat" >"$results/run.txt" 2>&1 || { tail -n 10 "$results/run.txt" >&2; exit 1; }
    done
  done
}
run frontal frontal.prm --set "Time/End time=2e-3"
run frontal_20k frontal.prm --set "Time/End time=0.5e-3" --set "Bird/Particle spacing=0.00174" \
  --set "Blade/Mesh/Elements along span=131" --set "Blade/Mesh/Elements along chord=38"
run blade blade-impulse.prm

# the distribution's own python has its matplotlib, another one may come first in the path
python=python3
[ -x /usr/bin/python3 ] && python=/usr/bin/python3
"$python" "$top/tests/benchmarks/speed_table.py" "$results" ${before:+"$before"} | tee "$results/speed.md"
"$python" "$top/tests/benchmarks/roofline.py" "$results" >&2
# a part of the benchmarks, chosen by arguments, does not tell whether the table of prices has aged
[ $# -gt 0 ] || "$python" "$top/tests/benchmarks/prices.py" "$results/benchmarks.json" --program "$build/bin/birdstrike" >&2
