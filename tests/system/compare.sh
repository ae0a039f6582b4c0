#!/usr/bin/env bash
# `birdstrike compare` from outside: runs, reuse, a lost case, refusals. Usage: compare.sh PROGRAM TOP
. "$(dirname "$0")/from_outside.sh" compare "$1" "$2"

fast=(--set "Bird/Particle spacing=0.006" --set "Blade/Mesh/Elements along span=14" --set "Blade/Mesh/Elements along chord=4"
      --set "Time/End time=0.3e-3" --set "Output/Field interval=0")
a="$top/prm/quickstart.prm"
b="$top/prm/oblique.prm"

ask "help" 0 "--blade" "--set" "--output" "runs/compare" -- --help
ask "two cases" 0 "Case 2 of 2" "Differences are to .quickstart." "^Tip +peak" "Comparison in both" -- "$a" "$b" "${fast[@]}" --output both
for file in comparison.md comparison.csv figures.gp tip_deflection.csv root_moment.csv root_stress.csv contact.csv energies.csv \
            profiles.csv quickstart/summary.json oblique/summary.json; do
  [ -s both/$file ] || fail "two cases left no $file"
done
require "its curves are drawn" '[ "$(grep -l "</svg>" both/*.svg | wc -l)" -eq 6 ]'

# the numbers are those of the runs
peak=$(sed -n 's/.*"peak_moment": \([^,]*\),/\1/p' both/oblique/summary.json)
require "the table repeats the summary, a row a case" 'grep -qE "^oblique,.*,$peak," both/comparison.csv && [ "$(wc -l <both/comparison.csv)" -eq 3 ]'
cat >look.py <<'PYTHON'
import csv, json, sys
def table(name): return [r for r in csv.reader(open(name)) if not r[0].startswith("#")]
def column(rows, begin): c = [n.startswith(begin) for n in rows[0]].index(True); return [float(r[c]) for r in rows[1:] if r[c]]
history, curves, profiles = (table(f) for f in ("both/oblique/history.csv", "both/tip_deflection.csv", "both/profiles.csv"))
assert column(curves, "oblique: time") == column(history, "time")
assert column(curves, "oblique: deflection") == column(history, "tip_mid_chord")
span, deflection = column(profiles, "oblique: place along the span"), column(profiles, "oblique: deflection")
peak = json.load(open("both/oblique/summary.json"))["tip"]["peak"]
assert len(span) == 15 and abs(span[0]) < 1e-12 and abs(span[-1] - 0.3112) < 1e-12, span
assert abs(deflection[0]) < 1e-12 and abs(deflection[-1] - peak) < 1e-12, (deflection[-1], peak)
PYTHON
require "curves are the history, the mid-chord line ends at the tip" 'python3 look.py >>out.txt 2>&1'

# what is there is not computed again
stamp=$(stat -c %Y.%y both/quickstart/history.csv)
ask "the same again" 0 "quickstart: the run in both/quickstart is reused" "oblique: the run in both/oblique is reused" -- "$a" "$b" "${fast[@]}" --output both
require "nothing was run" '[ "$stamp" = "$(stat -c %Y.%y both/quickstart/history.csv)" ] && ! grep -q "to run" out.txt'
refuse "another value would lose a run" "'both/oblique' holds a run that would be lost, for Bird/Velocity differs" "--force" -- "$a" both/oblique/parameters.prm "${fast[@]}" --output both --set "Bird/Velocity=0, 0, 177.4"
ask "another value is another run" 0 "Case 1 of 1 to run: oblique" "is not reused because Bird/Velocity differs" "quickstart: the run in both/quickstart is reused" -- \
  "$a" both/oblique/parameters.prm "${fast[@]}" --output both --set "Bird/Velocity=0, 0, 177.4" --force
refuse "other cases would lose the table" "tables of another comparison, with 'oblique'" "the same cases again, or with more of them" -- "$a" "${fast[@]}" --output both
require "which is there" '[ "$(wc -l <both/comparison.csv)" -eq 3 ] && [ -s both/tip_deflection.svg ]'
"$program" run "$a" "${fast[@]}" --output runs/quickstart >/dev/null
ask "a run of 'run' is taken" 0 "the run in runs/quickstart is reused" -- "$a" "${fast[@]}" --output single
require "and nothing else was made" '[ ! -e single/quickstart ]'

ask "no results.h5" 0 "without results.h5" -- "$b" "${fast[@]}" --set "Output/HDF5=false" --output plain
ask "one file, two kinds of blade" 0 "quickstart shell: the run in runs/quickstart is reused" "^Case +blade" "^quickstart shell +shell" "^quickstart rigid +rigid" -- "$a" --blade shell,rigid "${fast[@]}" --output kinds
require "the shell is the file's own" '[ -s kinds/quickstart-rigid/summary.json ] && [ ! -e kinds/quickstart-shell ]'

# runs of one file are told apart by their folders, and keep what --set changed
for mass in 0.1 0.12; do "$program" run "$a" "${fast[@]}" --set "Bird/Mass=$mass" --output runs/mass-$mass >/dev/null; done
ask "two run folders" 0 "mass-0.1: the run in runs/mass-0.1 is reused" "mass-0.12: the run in runs/mass-0.12 is reused" -- \
  runs/mass-0.1 runs/mass-0.12 --output folders
ask "two runs of one file" 0 "mass-0.1: the run in runs/mass-0.1 is reused" "mass-0.12: the run in runs/mass-0.12 is reused" "^mass-0.12 +shell" -- \
  runs/mass-0.1/parameters.prm runs/mass-0.12/parameters.prm --output masses

# a lost case takes no other with it
sed 's/set End time = .*/set End time = 2e-3\n  set Energy error limit = 1e-12/' "$a" >doomed.prm
ask "a lost case" 3 "^doomed .* lost" "'doomed' was lost: failed: .*energy" "^Tip +peak" -- "$a" doomed.prm "${fast[@]}" --output lost
require "the other one is compared" 'grep -qE "^quickstart,shell,56," lost/comparison.csv && grep -qE "^doomed,,,,lost,," lost/comparison.csv'

# a run that cannot be read loses its own case only; a folder in use is left alone
echo "no JSON" >plain/oblique/summary.json
ask "a damaged run is made again" 0 "Case 1 of 1 to run: oblique" "its files cannot be read" -- "$b" "${fast[@]}" --set "Output/HDF5=false" --output plain
flock plain/.birdstrike-comparison "$program" compare "$b" "${fast[@]}" --set "Output/HDF5=false" --output plain >out.txt 2>&1
code=$?
require "one comparison a folder" '[ $code -eq 2 ] && grep -q "Another comparison is writing" out.txt'

# an interrupted comparison ends its run in order, says so, and does not take it for a result
"$program" compare "$a" "${fast[@]}" --set "Time/End time=10" --set "Time/Maximum wall time=60" --output stopped >out.txt 2>&1 &
running=$!
for _ in $(seq 300); do [ -s stopped/quickstart/parameters.prm ] && break; sleep 0.1; done
kill -TERM $running
wait $running
code=$?
require "a signal ends comparison and run, with the exit code of 'run'" '[ $code -eq 130 ] && grep -q "Complete cases will be reused" out.txt && grep -q "stopped by a signal" stopped/quickstart/summary.json'

# what was stopped goes on, as if nothing had happened; where 'resume' refuses, it is run anew
long=(--set "Time/End time=240e-3" --set "Output/HDF5=false")
"$program" compare "$a" "${fast[@]}" "${long[@]}" --output on >out.txt 2>&1 &
running=$!
for _ in $(seq 300); do [ -s on/quickstart/parameters.prm ] && break; sleep 0.1; done
sleep 0.3
kill -TERM $running
wait $running
cp -r on anew
echo damaged >"$(ls anew/quickstart/checkpoints/*.h5 | tail -1)"
ask "a stopped case goes on" 0 "Case 1 of 1 to run: quickstart, into .*, from its checkpoint at" "Continuing from" -- "$a" "${fast[@]}" "${long[@]}" --output on
ask "without a checkpoint it is run anew" 0 "Case 1 of 1 to run: quickstart, into .*a signal ended it" -- "$a" "${fast[@]}" "${long[@]}" --output anew
"$program" run "$a" "${fast[@]}" "${long[@]}" --output through >/dev/null 2>&1
require "the histories are those of a run without a stop" 'cmp on/quickstart/history.csv through/history.csv && cmp anew/quickstart/history.csv through/history.csv'

# without gnuplot
mkdir bin  # an empty path of programs

compare_without() { PATH="$scratch/bin" "$program" compare "$@"; }
if compare_without "$a" "$b" "${fast[@]}" --output both --force >out.txt 2>&1 && grep -q "gnuplot is not installed: apt-get install gnuplot-nox" out.txt &&
   [ -s both/comparison.csv ] && [ -z "$(find both -maxdepth 1 -name '*.svg')" ]; then
  echo "passed without gnuplot"
else
  fail "without gnuplot"
fi

refuse "no file" "FILE" --
refuse "a missing file" "no-such.prm" -- "$a" no-such.prm
refuse "the same file twice" "same case" -- "$a" "$a"
cp "$a" copy.prm
refuse "the same case by another name" "same case" -- "$a" copy.prm
mkdir -p elsewhere && sed 's/0.1005/0.2/' "$a" >elsewhere/quickstart.prm
refuse "two cases of one name" "would both run in the folder" -- "$a" elsewhere/quickstart.prm
refuse "an unknown kind of blade" "Kind.*wooden" "shell" -- "$a" --blade shell,wooden
refuse "the same kind twice" "same case" -- "$a" --blade shell,shell
refuse "a misspelt override" "Mas" "Mass" -- "$a" --set "Bird/Mas=1"
refuse "a run's folder" "folder of a run" -- "$a" "$b" --output runs/quickstart
mkdir foreign && touch foreign/thesis.tex
refuse "a foreign folder" "foreign" -- "$a" "$b" --output foreign
refuse "a case that cannot start, before another has run" "inside" -- "$a" "$b" "${fast[@]}" --set "Bird/Stand-off=0.001" --output refused
require "a refusal leaves nothing" '[ ! -e refused ]'
mkdir -p mixed && touch mixed/.birdstrike-comparison && cp -r both/oblique mixed/quickstart
refuse "a run folder of another case" "another case, 'oblique'" -- "$a" "${fast[@]}" --output mixed

echo "$n_failed failed"
[ $n_failed -eq 0 ]
