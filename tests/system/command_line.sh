#!/usr/bin/env bash
# The program from outside: exit codes, length and content of its messages, nothing half-written taken for a result.
# Usage: command_line.sh PROGRAM TOP
set -u
program=$1
top=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
n_failed=0

# check NAME EXPECTED_EXIT PATTERN... -- ARGUMENTS: every pattern must occur; a refusal has at most six lines, no dump
check() {
  local name=$1 expected=$2; shift 2
  local patterns=()
  while [ "$1" != "--" ]; do patterns+=("$1"); shift; done
  shift
  "$program" "$@" >out.txt 2>&1 </dev/null # nobody types
  local code=$?
  local bad=""
  [ $code -eq "$expected" ] || bad="exit code $code, expected $expected"
  for pattern in ${patterns[@]+"${patterns[@]}"}; do
    grep -qE -- "$pattern" out.txt || bad="$bad; no '$pattern' in the output"
  done
  if [ "$expected" -ne 0 ]; then
    # a run that fails on its way has told what it computes first; its message is what follows
    [ "$expected" -eq 3 ] || [ "$(wc -l <out.txt)" -le 6 ] || bad="$bad; more than six lines"
    grep -qiE 'stacktrace|An error occurred in line|terminate called' out.txt && bad="$bad; a dump"
  fi
  if [ -n "$bad" ]; then
    echo "FAILED $name: ${bad#; }"; sed 's/^/    /' out.txt | head -n 20; n_failed=$((n_failed + 1))
  else
    echo "passed $name"
  fi
}

# variant SED_EXPRESSION: quickstart.prm with a change
variant() { sed -E "$1" "$top/prm/quickstart.prm" >case.prm; }

fast=(--set "Bird/Particle spacing=0.006" --set "Blade/Mesh/Elements along span=14" --set "Blade/Mesh/Elements along chord=4")

check "version" 0 "birdstrike [0-9]+\.[0-9]+" "compiler +(GNU|Clang)" "deal.II +[0-9]" "HDF5 +[0-9]" -- --version
check "help" 0 "run" "explain" "validate" "columns" "parameters" "130 interrupted" -- --help
check "help of run" 0 "--set" "--output" -- run --help
check "no subcommand" 2 -- 
check "unknown subcommand" 2 "Unknown command 'fly'. Commands: run, explain" -- fly
check "parameters as prm" 0 "subsection Bird" "set Mass" "\[kg\]" -- parameters
check "parameters as JSON" 0 '"Bird"' '"unit"' -- parameters --json
check "parameters of a section" 0 "^Bird/Equation of state/Sound speed" "unit m/s; default 1482.9" -- parameters "bird/equation of state"
check "sections that repeat" 0 "^Bird/Equation of state/Sound speed" "Section Bird 2/Equation of state has the same entries as Bird/Equation of state" -- parameters "equation of"
check "an entry" 0 "^Bird/Speed" "unit m/s; default empty" -- parameters Bird/Speed
check "entries with a word" 0 "^Blade/Element/Hourglass" -- parameters hourglass
check "no entry with a word" 2 "No entry has 'Mas5'" "Nearest name: 'Mass'" -- parameters Mas5
check "materials" 0 "Ti-6Al-4V: 4430 kg/m.3, E 113.8 GPa" "source: ASM data sheet MTP641" "custom" -- materials
check "liquids" 0 "murnaghan: p = B" "Hugoniot pressure at 200 m/s" "tabulated" -- liquids
check "columns" 0 "root_bending_moment +N m +.*struck face" "probe_NAME_ux, _uy, _uz" "failed_elements" -- columns
check "columns of a case" 0 "contact_force_x, _y, _z +N" -- columns "$top/prm/quickstart.prm"
grep -qE "failed_elements|NAME" out.txt && { echo "FAILED columns of a case has others'"; n_failed=$((n_failed + 1)); }
check "explain" 0 "particles" "limited by" "momentum" -- explain "$top/prm/quickstart.prm"
check "validate" 0 "valid" -- validate "$top/prm/quickstart.prm"
[ -z "$(ls | grep -v out.txt)" ] || { echo "FAILED explain or validate wrote: $(ls)"; n_failed=$((n_failed + 1)); }

# A formula that is no number later on ends the run in words, with what it has written up to there.
"$program" run "$top/prm/quickstart.prm" "${fast[@]}" --output late --set "Time/End time=0.5 ms" --set "Blade/Loads/Pressure=1e3*sqrt(1e-4 - t)" >out.txt 2>&1
[ $? -eq 2 ] && grep -q "Blade/Loads/Pressure: '1e3.sqrt(1e-4 - t)' is not finite at .*, t = 0.0001" out.txt && [ -s late/log.txt ] && [ ! -e late/summary.json ] ||
  { echo "FAILED a load that is no number later on"; tail -n 5 out.txt; n_failed=$((n_failed + 1)); }
rm -rf late

# The screen: at most 30 lines before the first step and 25 after the last; log.txt and --verbose have the whole.
"$program" run "$top/prm/quickstart.prm" "${fast[@]}" --output brief --set "Output/Console interval=1e9" >out.txt 2>&1
n_before=$(grep -n "^Warning" out.txt | head -n 1 | cut -d: -f1)
n_after=$(($(wc -l <out.txt) - $(grep -n "^Ended at" out.txt | cut -d: -f1) + 1))
"$program" run "$top/prm/quickstart.prm" "${fast[@]}" --output verbose --verbose --set "Output/Console interval=1e9" >whole.txt 2>&1
if [ "$n_before" -gt 30 ] || [ "$n_after" -gt 25 ] || grep -q "per particle-step" out.txt || ! grep -q "per particle-step" brief/log.txt ||
   ! grep -q "per particle-step" whole.txt || ! grep -q "centre of mass" whole.txt; then
  echo "FAILED length of the screen: $n_before lines before the first step, $n_after after the last"
  n_failed=$((n_failed + 1))
fi
rm -rf brief verbose whole.txt

# A new file runs as it is, of a plate and of a mesh in mm.
for blade in shell solid; do
  for spin in 0 "3000 rpm"; do
    check "new: $blade at $spin" 0 "Next: birdstrike explain new.prm" -- new new.prm --blade "$blade" --spin "$spin"
    strict=(--strict) # a bird that meets a turning blade is cut by its edge
    [ "$spin" = 0 ] || strict=()
    check "new: $blade at $spin is valid" 0 "new.prm: valid" -- validate new.prm "${strict[@]}"
    check "new: $blade of a mesh at $spin" 0 -- new new.prm --force --blade "$blade" --spin "$spin" --mesh "$top/meshes/own-blade-$blade.msh"
    check "new: $blade of a mesh at $spin is valid" 0 "new.prm: valid" -- validate new.prm "${strict[@]}" --set "Blade/Mesh/File scale=0.001"
    [ "$spin" != 0 ] || check "new: a $blade mesh in mm is warned of" 2 "mm" "With --strict these warnings are errors: unit/" -- validate new.prm --strict
    rm -f new.prm
  done
done
check "new: a wrong kind" 2 "Allowed: shell or solid" -- new new.prm --blade beam
check "new: no such mesh" 2 "cannot open 'no-such.msh'" -- new new.prm --mesh no-such.msh
touch new.prm
check "new: a file that is there" 2 "--force" -- new new.prm
rm -f new.prm
check "strict: a unit" 2 "Was it meant in MPa" "With --strict these warnings are errors: unit/" -- run "$top/prm/quickstart.prm" --strict --set "Blade/Material/Young's modulus=113800"
check "strict: an entry without effect" 2 "entry/unused" -- explain "$top/prm/quickstart.prm" --strict --set "Blade/Mesh/File scale=2"
check "strict: nothing to say" 0 "valid" -- validate "$top/prm/quickstart.prm" --strict

variant 's/Particle spacing/Particle spcing/'
check "misspelt entry" 2 "Particle spcing" "Particle spacing" "case.prm" "line" -- run case.prm
variant 's/^( *)set Mass .*/\1set Density = 950\n\1set End time = 1/'
check "wrong section" 2 "End time" "Time" -- run case.prm
variant 's/set Mass .*/set Mass = heavy/'
check "wrong type" 2 "heavy" "Mass" -- run case.prm
variant 's/set Mass .*/set Mass = -1/'
check "out of range" 2 "Mass" -- run case.prm
check "missing file" 2 "no-such.prm" -- run no-such.prm
check "misspelt override" 2 "Mas" "Mass" -- run "$top/prm/quickstart.prm" --set "Bird/Mas=1"
check "bird that starts inside" 2 "inside" -- run "$top/prm/quickstart.prm" "${fast[@]}" --set "Bird/Stand-off=0.001"
check "bird that stands still" 2 "does not close in" -- run "$top/prm/quickstart.prm" "${fast[@]}" --set "Bird/Velocity=0, 0, 0"
check "spin of a clamped blade" 2 "Initial spin" "root that stands still" -- run "$top/prm/quickstart.prm" "${fast[@]}" --set "Blade/Loads/Initial spin=0; 100; 0"
check "bird that misses" 2 "miss" -- run "$top/prm/quickstart.prm" "${fast[@]}" --set "Bird/Aim point=1, 1, 0"
check "nothing in the case" 2 "neither" -- run "$top/prm/bird-free.prm" --set "Bird/Enabled=false"
check "a shell's element for a solid" 2 "no element of a solid" "B-bar" -- run "$top/prm/quickstart.prm" --set "Blade/Kind=solid" --set "Blade/Element/Formulation=physical"
check "a brick for a shell" 2 "no element of a shell" "physical" -- run "$top/prm/quickstart.prm" --set "Blade/Element/Formulation=B-bar"
check "a rotation of a solid" 2 "rotations" -- run "$top/prm/quickstart.prm" --set "Blade/Kind=solid" --set "Blade/Supports/Held=1: rx"
check "an aim point off the surface" 0 "of the chord, 21 mm off the mid-surface" -- explain "$top/prm/quickstart.prm" --set "Bird/Aim point=0.2, 0.01, -0.021"
check "an entry of the other kind is named" 0 "Blade/Element/Thinning is set" "Blade: solid" -- explain "$top/prm/quickstart.prm" --set "Blade/Kind=solid" --set "Blade/Element/Thinning=false"
check "missing mesh" 2 "no-such.msh" -- run "$top/prm/quickstart.prm" --set "Blade/Mesh/Generator=file" --set "Blade/Mesh/File=no-such.msh"
check "bricks for a shell" 2 "holds 224 hexahedra" "Blade/Kind = solid" -- run "$top/prm/quickstart.prm" --set "Blade/Mesh/Generator=file" --set "Blade/Mesh/File=$top/meshes/plate-28x8x1.msh"
check "unknown boundary name" 2 "no boundary 'rot'" "root, tip" -- run "$top/prm/quickstart.prm" --set "Blade/Supports/Clamped=rot"
check "unknown boundary id" 2 "77" -- run "$top/prm/quickstart.prm" --set "Blade/Supports/Clamped=77"
[ -z "$(find . -name summary.json)" ] || { echo "FAILED a refusal left a summary"; n_failed=$((n_failed + 1)); }

mkdir -p foreign && touch foreign/thesis.tex
check "a foreign folder is not overwritten" 2 "foreign" -- run "$top/prm/quickstart.prm" "${fast[@]}" --output foreign
[ -f foreign/thesis.tex ] || { echo "FAILED the foreign folder was emptied"; n_failed=$((n_failed + 1)); }

check "a lost balance" 3 "energy" "t = " -- run "$top/prm/quickstart.prm" "${fast[@]}" --output lost \
  --set "Time/Energy error limit=1e-12"
[ ! -e lost/summary.json ] || { echo "FAILED a failed run left a summary"; n_failed=$((n_failed + 1)); }

check "a short run" 0 "Results in" -- run "$top/prm/quickstart.prm" "${fast[@]}" --output short --set "Time/End time=0.3e-3"
for file in original.prm parameters.prm log.txt history.csv results.h5 summary.json filtered.csv blade.pvd bird.pvd; do
  [ -s short/$file ] || { echo "FAILED a run left no $file"; n_failed=$((n_failed + 1)); }
done
grep -q '"peak_reached": false' short/summary.json && grep -q "tip peak.*(still rising at the end)" short/log.txt ||
  { echo "FAILED a tip on its way up is called a peak"; n_failed=$((n_failed + 1)); }
check "its parameters.prm runs again" 0 "Results in" -- run short/parameters.prm --output again
diff -q short/history.csv again/history.csv >/dev/null || { echo "FAILED the re-run differs"; n_failed=$((n_failed + 1)); }
check "one thread" 0 -- run short/parameters.prm --output one --set "Time/Threads=1"
check "two threads" 0 -- run short/parameters.prm --output two --set "Time/Threads=2"
diff -q one/history.csv two/history.csv >/dev/null || { echo "FAILED two threads differ from one"; n_failed=$((n_failed + 1)); }

# a signal ends a run in order: its results are whole, its exit code says that they are not those of its parameters
"$program" run "$top/prm/quickstart.prm" --output stopped --set "Time/End time=10" >out.txt 2>&1 &
for _ in $(seq 300); do [ -e stopped/log.txt ] && break; sleep 0.1; done
kill -TERM $!
wait $!
code=$?
if [ $code -eq 130 ] && grep -q "stopped by a signal" stopped/summary.json && grep -q "Interrupted by a signal" out.txt; then
  echo "passed an interrupted run"
else
  echo "FAILED an interrupted run: exit code $code, expected 130"; tail -n 5 out.txt; n_failed=$((n_failed + 1))
fi

# more than one rank is refused, by one voice
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -np 2 "$program" run "$top/prm/quickstart.prm" >out.txt 2>&1
if [ $? -eq 2 ] && [ "$(grep -c 'one MPI rank' out.txt)" -eq 1 ]; then
  echo "passed two ranks are refused"
else
  echo "FAILED two ranks"; n_failed=$((n_failed + 1))
fi

# every shipped case runs, shortened, and none sets what means nothing
for case in "$top"/prm/*.prm; do
  check "shortened $(basename "$case")" 0 "Results in" -- run "$case" --output "run-$(basename "$case" .prm)" \
    --set "Time/End time=20e-6" --set "Bird/Particle spacing=0.006"
  ! grep -q "means nothing" out.txt || { echo "FAILED $case sets what means nothing"; n_failed=$((n_failed + 1)); }
done

echo "$n_failed failed"
[ $n_failed -eq 0 ]
