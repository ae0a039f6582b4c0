#!/usr/bin/env bash
# Everything that reads a file, under libFuzzer with the address and undefined-behaviour sanitizers:
#   [SEED=1] bash tests/stress/fuzz.sh [SECONDS a target, 20 | counted] [TARGET...]
# `counted`: a number of inputs instead of seconds, from the shipped files only, in one order, one thread and without random
# addresses (where setarch may): the same inputs each time, as CI needs them.
# An input may only be accepted or refused in words: no crash, no other exception, 20 s on the clock and 2 GiB at most. Builds with
# clang into build-fuzz, begins with the shipped files and what earlier runs have found (build-fuzz/corpus), prints a line
# a target, and leaves what fails in build-fuzz/failures.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BIRDSTRIKE_FUZZ_BUILD:-$top/build-fuzz}
seconds=${1:-20}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(parameter_file mesh_file checkpoint run_folder)

bash "$top/.ci/install" clang libclang-rt-dev
mkdir -p "$build/failures"
cmake -S "$top" -B "$build" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" \
  -DBIRDSTRIKE_NATIVE=OFF -DBIRDSTRIKE_TESTS=OFF -DBIRDSTRIKE_FUZZ=ON >"$build/build.log" 2>&1 &&
  cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target "${targets[@]/#/fuzz_}" >>"$build/build.log" 2>&1 ||
  { tail -n 20 "$build/build.log" >&2; exit 1; }

memory=/dev/shm
[ -w "$memory" ] || memory=/tmp
scratch=$(mktemp -d -p "$memory")
trap 'rm -rf "$scratch"' EXIT
export TMPDIR=. ASAN_OPTIONS=detect_leaks=0 # what MPI and deal.II keep until the end

seeds=$scratch/seeds
mkdir -p "$seeds"/{parameter_file,mesh_file,checkpoint,run_folder}
cp "$top"/prm/{quickstart,fan-blade}.prm "$top"/tests/scenes/{moving-frame,hidden-asymmetry}.prm "$seeds/parameter_file"
for mesh in "$top"/tests/data/gmsh/{,groups/}*.{msh,vtk} "$top"/tests/data/gmsh/*.{inp,key} "$top"/tests/data/vtk/*.vtk "$top"/meshes/*.msh; do
  case $mesh in *.msh) format=m ;; *.inp) format=i ;; *.key) format=k ;; *) format=v ;; esac
  dim=2
  [[ $mesh != */body* && $mesh != *x1.msh ]] || dim=3
  { printf '%s%s' "$format" "$dim"; cat "$mesh"; } >"$seeds/mesh_file/$(basename "$(dirname "$mesh")")-$(basename "$mesh")"
done
printf 'i26 2 0 0 0\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n1 5 quad 1 2 5 4\n2 1 line 1 4\n' >"$seeds/mesh_file/ucd"
printf 't20 0 0 0.01\n0.1, 0.05, 0, 1e-3 # a comment\n' >"$seeds/mesh_file/table"
for kind in s f r; do printf '%sbirdstrike checkpoint 4, 10 bytes, CRC-32 00000000\n' "$kind" >"$seeds/checkpoint/$kind"; done
cp "$top"/tests/fuzz/seeds/run_folder/* "$seeds/run_folder"
# Their dictionary: the words of the readers' sources, those of printable letters.
export LC_ALL=C
grep -rhoE '"[]-~ !#-[]{2,40}"' "$top"/source/{io,mesh,bird,contact,structure,time_control,report}/ --include='*.cc' | sort -u >"$scratch/words"

declare -A counts=([parameter_file]=300 [mesh_file]=12000 [checkpoint]=1500 [run_folder]=25000) # some 15 s each

fuzz() # TARGET: its closing lines
{
  local corpus=$build/corpus/$1 bound=(-max_total_time=$seconds) same=()
  if [ "$seconds" = counted ]; then
    corpus=$scratch/corpus/$1 bound=(-runs="${counts[$1]}" -reload=0) # no look at the folder by the clock
    export DEAL_II_NUM_THREADS=1
    ! setarch --addr-no-randomize true 2>/dev/null || same=(setarch --addr-no-randomize)
  fi
  mkdir -p "$corpus" "$scratch/work/$1"
  cd "$scratch/work/$1"
  "${same[@]}" "$build/bin/fuzz_$1" "${bound[@]}" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=2048 -seed="${SEED:-1}" \
    -dict="$scratch/words" -seed_inputs="$(printf '%s\n' "$seeds/$1"/* | paste -sd,)" -print_final_stats=1 \
    -artifact_prefix="$build/failures/$1-" "$corpus" >"$scratch/$1.log" 2>&1
}
running=()
for target in "${targets[@]}"; do
  fuzz "$target" &
  running+=($!)
done
n_failed=0
for k in "${!targets[@]}"; do
  target=${targets[$k]}
  wait "${running[$k]}" || { n_failed=$((n_failed + 1)); grep -aE -A 30 'ERROR|SUMMARY|runtime error|terminate|Test unit' "$scratch/$target.log" >&2 || tail -n 10 "$scratch/$target.log" >&2; }
  echo "$target: $(sed -n 's/stat::number_of_executed_units: *//p' "$scratch/$target.log") executions," \
    "$(grep -aoE 'cov: [0-9]+ ft: [0-9]+' "$scratch/$target.log" | tail -n 1), peak $(sed -n 's/stat::peak_rss_mb: *//p' "$scratch/$target.log") MiB"
done
[ "$n_failed" -eq 0 ]
