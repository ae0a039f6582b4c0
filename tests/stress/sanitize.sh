#!/usr/bin/env bash
# The program under an observer: tests, and a short run of every case in prm/ with two threads, its checkpoint and the way on from it.
#   bash tests/stress/sanitize.sh address    every test; address and undefined-behaviour sanitizers
#   bash tests/stress/sanitize.sh thread     the tests that start threads; thread sanitizer
#   bash tests/stress/sanitize.sh debug      assertions, deal.II's too; cases alone
#   bash tests/stress/sanitize.sh valgrind   the quickstart alone; memcheck, built for AVX2
# Builds into the folder of the preset. Prints one line with the figures; fails on any report of the observer.
set -euo pipefail

kind=${1:?address, thread, debug or valgrind}
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$top"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

tests=() observer=() n_tests=0 n_failed=0 end=2e-5
cases=(prm/*.prm)
case $kind in
  address)
    preset=sanitize tests=(.)
    export ASAN_OPTIONS=detect_leaks=0 # MPI's and HDF5's own
    ;;
  thread)
    preset=sanitize-thread tests=('^core\.ThreadPool|^simulation\.')
    export TSAN_OPTIONS="suppressions=$top/tests/stress/tsan.supp history_size=4"
    export DEAL_II_NUM_THREADS=1 # as the program has it: deal.II and TBB are not instrumented
    ;;
  debug) preset=debug ;;
  valgrind)
    preset=valgrind end=2e-6 cases=(prm/quickstart.prm)
    observer=(valgrind --quiet --error-exitcode=99 "--suppressions=$top/tests/stress/valgrind.supp")
    ;;
  *) echo "'$kind'? Allowed: address, thread, debug, valgrind." >&2; exit 2 ;;
esac
build=$top/build-$preset

targets=(birdstrike)
[ ${#tests[@]} -eq 0 ] || targets=(all)
[ "$kind" != thread ] || targets=(birdstrike core_tests simulation_tests)
cmake --preset "$preset" >"$scratch/build.log" 2>&1 &&
  cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target "${targets[@]}" >>"$scratch/build.log" 2>&1 ||
  { tail -n 30 "$scratch/build.log" >&2; exit 1; }


fail()
{
  n_failed=$((n_failed + 1))
  echo "FAILED: $1" >&2
  tail -n 60 "$scratch/said" >&2
}

for which in "${tests[@]}"; do
  (cd "$build" && ctest --parallel "${JOBS:-$(nproc)}" --timeout 7200 --output-on-failure -R "$which" -E '^(system|benchmarks|archive)\.') \
    >"$scratch/said" 2>&1 || fail tests
  n_tests=$(sed -n 's/.* out of \([0-9]*\)$/\1/p' "$scratch/said" | tail -n 1)
done

for case in "${cases[@]}"; do
  run=$scratch/$(basename "$case" .prm)
  "${observer[@]}" "$build/bin/birdstrike" run "$case" --output "$run" --set Time/Threads=2 --set "Time/End time=$end" \
    >"$scratch/said" 2>&1 || fail "run $case"
  "${observer[@]}" "$build/bin/birdstrike" resume "$run" --set "Time/End time=${end/e/.5e}" >"$scratch/said" 2>&1 ||
    fail "resume $case"
done
echo "$kind: $n_tests tests, ${#cases[@]} cases run and resumed, $n_failed failed"
[ "$n_failed" -eq 0 ]
