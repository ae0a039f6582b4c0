#!/usr/bin/env bash
# `birdstrike study` from outside: grid, reuse, a lost point, task list, refusals, shipped studies. Usage: study.sh PROGRAM TOP
. "$(dirname "$0")/from_outside.sh" study "$1" "$2"

fast=(--set "Bird/Particle spacing=0.008" --set "Blade/Mesh/Elements along span=10" --set "Blade/Mesh/Elements along chord=3"
      --set "Time/End time=0.1e-3" --set "Output/Field interval=0")
a="$top/prm/quickstart.prm"
grid=("$a" "${fast[@]}" --set "Bird/Velocity=default" --vary "Bird/Speed=100 m/s:200 m/s:2" --vary "Bird/Angle to surface=45, 90 deg")

ask "help" 0 "--vary" "--pairs" "--launcher" "--task-list" "--jobs" -- --help
ask "a grid" 0 "4 points, 0 of them" "still rising at the end of the run, no peak yet" "4 of 4" "^ +100 +45 .* done$" "Study in grid" -- "${grid[@]}" --output grid
for file in study.csv study.h5 figures.gp responses.csv maps.csv profiles.csv Speed=200-Angle-to-surface=90/summary.json; do
  [ -s grid/$file ] || fail "a grid left no $file"
done
# what still rises is no peak: so say table, curves, map, and their data
require "a map marks what still rises" 'grep -q "+: still rising at the end of the run, no peak yet" grid/maps.svg && grep -qE ">[0-9.]+\+<" grid/maps.svg && head -n 1 grid/maps.csv | grep -q "^# 1:" && grep -q "still rising, no peak yet: peak (mid-chord) \[-\]" grid/maps.csv'
require "curves have open markers" 'grep -q "still rising at the end of the run, no peak yet" grid/responses.svg && grep -q "still rising, no peak yet: peak (mid-chord) \[-\]" grid/responses.csv'
require "what does not rise is not marked" '! grep -q "no peak yet: plastic work" grid/maps.csv'
require "its pictures are drawn" 'grep -q "</svg>" grid/responses.svg && grep -q "</svg>" grid/maps.svg'
peak=$(sed -n 's/.*"peak_moment": \([^,]*\),/\1/p' grid/Speed=200-Angle-to-surface=90/summary.json)
require "the table repeats the summaries" 'grep -qE "^4,200,90,.*,$peak,.*,done,grid/" grid/study.csv && [ "$(wc -l <grid/study.csv)" -eq 5 ]'
require "one thread a point" 'grep -q "set Threads = 1" grid/Speed=100-Angle-to-surface=45/parameters.prm'

stamp=$(stat -c %Y.%y grid/*/history.csv | sort)
rm grid/Speed=100-Angle-to-surface=90/summary.json
ask "a study that was stopped goes on" 0 "4 points, 3 of them" "1 of 1: Speed=100, Angle to surface=90" -- "${grid[@]}" --output grid
require "and computes nothing twice" '[ "$(comm -12 <(echo "$stamp") <(stat -c %Y.%y grid/*/history.csv | sort) | wc -l)" -eq 3 ]'
ask "it may grow" 0 "6 points, 4 of them" -- "${grid[@]:0:${#grid[@]}-4}" --vary "Bird/Speed=100, 150, 200" --vary "Bird/Angle to surface=45, 90" --output grid

# what a study has made is lost by --force alone: tables of other points, runs of other entries
all=$(cksum grid/*.* grid/*/history.csv)
refuse "other entries in its folder" "holds the tables of another study" "'Speed=100-Angle-to-surface=45' and 5 more" "the same study again, or with more values" "--force" -- "$a" "${fast[@]}" --vary "Bird/Mass=0.1, 0.12" --output grid
refuse "fewer values of one entry" "another study" -- "${grid[@]:0:${#grid[@]}-4}" --vary "Bird/Speed=100, 200" --set "Bird/Angle to surface=45" --output grid
refuse "fewer points" "and 1 more" -- "${grid[@]}" --output grid
refuse "nor by collecting" "another study" -- "$a" "${fast[@]}" --vary "Bird/Mass=0.1, 0.12" --output grid --collect
refuse "other runs in the same folders" "'grid/Speed=100-Angle-to-surface=45' holds a run that would be lost, for Bird/Mass differs" "3 folders more" "--force" -- "${grid[@]}" --set "Bird/Mass=0.11" --output grid
refuse "nor by a list of tasks" "would be lost" -- "${grid[@]}" --set "Bird/Mass=0.11" --output grid --task-list lossy
require "everything is as it was" '[ "$all" = "$(cksum grid/*.* grid/*/history.csv)" ] && [ ! -e lossy ]'
refuse "nor by the same numbers in other letters, whose folders are others" "another study" -- "${grid[@]:0:${#grid[@]}-4}" --vary "Bird/Speed=1e2, 1.5e2, 2e2" --vary "Bird/Angle to surface=45, 90" --output grid --collect
ask "unless it is forced" 0 "4 points, 4 of them" -- "${grid[@]}" --output grid --force
require "then the tables are of the new one, the runs stay" '[ "$(wc -l <grid/study.csv)" -eq 5 ] && [ -s grid/Speed=150-Angle-to-surface=90/summary.json ]'

ask "texts of an entry with a unit" 0 "Study in places" -- "$a" "${fast[@]}" --vary "Bird/Aim point=0.15, 0, 0 | 0.2, 0, 0" --vary "Case/Description=80% a_b | c" --output places
require "are drawn" '! grep -q "could not draw" out.txt && grep -q "80% a_b" places/responses.svg places/maps.svg && grep -q "0.15, 0, 0" places/maps.svg'

# a lost point, a refused point: both keep their rows, the others go on
ask "a lost point" 3 "lost: .*energy" "Lost: 'Energy error limit=1e-12'" -- "$a" "${fast[@]}" --vary "Time/Energy error limit=0.05, 1e-12" --output lost
require "keeps its row" 'grep -qE "^2,1e-12,.*lost: .*energy" lost/study.csv && grep -qE "^1,0.05,shell,.*,done," lost/study.csv'
ask "a refused point" 2 "refused: .*inside" -- "$a" "${fast[@]}" --vary "Bird/Stand-off=0.001, default" --output inside
ask "a reason is the refusal's, not a warning before it" 2 "refused: The equation of state carries no shock of 99999" -- "$a" "${fast[@]}" --set "Bird/Velocity=default" --set "Bird/Angle to surface=90" --vary "Bird/Speed=100, 99999" --output fastest
require "and no warning's" '! grep -q "refused: Warning" out.txt fastest/study.csv'
require "does not stop the other" 'grep -qE "^2,.*,done," inside/study.csv'

# signals: all children end, what is complete is reused
"$program" study "$a" "${fast[@]}" --set "Time/Maximum wall time=60" --vary "Time/End time=0.1e-3, 10, 11" --jobs 3 --output stopped >out.txt 2>&1 &
running=$!
for _ in $(seq 300); do [ -s stopped/End-time=10/parameters.prm ] && [ -s stopped/End-time=11/parameters.prm ] && [ -s stopped/End-time=1e-4/summary.json -o -s stopped/End-time=0.1e-3/summary.json ] && break; sleep 0.1; done
kill -TERM $running
wait $running
code=$?
require "a signal ends study and runs, with the exit code of 'run'" '[ $code -eq 130 ] && grep -q "Complete points will be reused" out.txt && [ "$(grep -l "stopped by a signal" stopped/*/summary.json | wc -l)" -eq 2 ]'
ask "what was complete is there" 0 "3 points, 1 of them are there, 2 will continue from a checkpoint" "stopped at [0-9.]+ [mu]?s, will continue" -- "$a" "${fast[@]}" --set "Time/Maximum wall time=60" --vary "Time/End time=0.1e-3, 10, 11" --collect --output stopped

# a limit of the wall's clock cuts a point: it has no values, and goes on with the next call
ask "points cut by the clock" 130 "stopped at [0-9.]+ [mu]?s, will continue" -- "$a" "${fast[@]}" --set "Time/End time=9" --set "Time/Maximum wall time=0.5" --vary "Bird/Mass=0.1" --output cut
require "have no values" 'grep -qE "^1,0.1,,,.stopped at .*, will continue" cut/study.csv'

# and what was not goes on from where it was, as if nothing had happened; where 'resume' refuses, it is run anew
long=(--set "Time/End time=240e-3" --set "Output/HDF5=false" --vary "Bird/Mass=0.1, 0.12" --jobs 2)
"$program" study "$a" "${fast[@]}" "${long[@]}" --output on >out.txt 2>&1 &
running=$!
for _ in $(seq 300); do [ -s on/Mass=0.1/parameters.prm ] && [ -s on/Mass=0.12/parameters.prm ] && break; sleep 0.1; done
sleep 0.3
kill -TERM $running
wait $running
require "stopped points say so" 'grep -q "Mass=0.1: stopped at .*, will continue" out.txt && ! grep -q "exit code" out.txt'
ask "a launcher that hands over what was stopped" 1 "exit code 0, and there is no complete run" -- "$a" "${fast[@]}" "${long[@]}" --launcher true --output on
echo damaged >"$(ls on/Mass=0.12/checkpoints/*.h5 | tail -1)"
ask "a stopped study goes on" 0 "2 points, 0 of them are there, 1 will continue from a checkpoint" "^ *0.1 .* done" "^ *0.12 .* done" -- "$a" "${fast[@]}" "${long[@]}" --output on
require "from the checkpoint" 'grep -q "Continuing from" on/Mass=0.1/log.txt && ! grep -q "Continuing from" on/Mass=0.12/log.txt'
ask "the same without a stop" 0 "2 points, 0 of them are there$" -- "$a" "${fast[@]}" "${long[@]}" --output through
require "has the same histories" 'cmp on/Mass=0.1/history.csv through/Mass=0.1/history.csv && cmp on/Mass=0.12/history.csv through/Mass=0.12/history.csv'

# somebody else's scheduler
ask "a task list" 0 "tasks: 2 lines" "SLURM_ARRAY_TASK_ID" -- "$a" "${fast[@]}" --vary "Bird/Shape=cylinder, hemispherical cylinder" --launcher "env TASK=1" --task-list tasks --output "my tasks"
require "runs nothing" '[ -z "$(find "my tasks" -name summary.json)" ] && [ "$(wc -l <tasks)" -eq 2 ] && grep -q "env TASK=1 /" tasks'
table=$(cksum grid/study.csv grid/study.h5 grid/maps.svg)
ask "a task list of a study that is made" 0 "tasks 2.* is empty: no point is left to run" -- "${grid[@]}" --output grid --task-list "tasks 2"
require "leaves its table" '[ "$table" = "$(cksum grid/study.csv grid/study.h5 grid/maps.svg)" ]'
cp "$a" own.prm
printf 'cd /somewhere\nmake things\n' >script.sh
refuse "a task list over a script" "no list of tasks" -- "$a" "${fast[@]}" --vary "Bird/Mass=0.1, 0.2" --task-list script.sh --output over
refuse "a task list over the case" "no list of tasks" -- own.prm "${fast[@]}" --vary "Bird/Mass=0.1, 0.2" --task-list own.prm --output over
require "keeps it" 'cmp "$a" own.prm && [ ! -e over ]'
(cd / && bash -c "$(sed -n 1p "$scratch/tasks")" && bash -c "$(sed -n 2p "$scratch/tasks")") >out.txt 2>&1
ask "collects what was run" 0 "2 points, 2 of them" "^ *hemispherical cylinder .* done" -- "$a" "${fast[@]}" --vary "Bird/Shape=cylinder, hemispherical cylinder" --output "my tasks"
ask "a launcher that runs nothing" 1 "exit code 0, and there is no complete run" -- "$a" "${fast[@]}" --vary "Bird/Mass=0.1, 0.2" --launcher true --output idle
ask "a launcher that is not there" 1 "Cannot start 'no-such-launcher'" -- "$a" "${fast[@]}" --vary "Bird/Mass=0.1, 0.2" --launcher no-such-launcher --output nowhere

# pairs, and the file's own section
ask "pairs" 0 "2 points" "^ +0.1 +900 " "^ +0.2 +950 " -- "$a" "${fast[@]}" --vary "Bird/Mass=0.1, 0.2" --vary "Bird/Density=900, 950" --pairs --output pairs
for file in "$top"/prm/studies/*.prm; do
  name=$(basename "$file" .prm)
  sed "s|include |include $top/prm/studies/|; s/= \(.*\) = 100:300:5/= \1 = 100:300:2/; s/:5$/:2/" "$file" >"$name.prm"
  ask "shipped: $name" 0 "Study in small-$name" -- "$name.prm" "${fast[@]}" --output "small-$name"
done

refuse "no file" "FILE" --
refuse "nothing varied" "Nothing is varied" -- "$a"
refuse "an unknown entry" "'Mass'" -- "$a" --vary "Bird/Mas=1, 2"
refuse "an empty list" "no values" -- "$a" --vary "Bird/Mass="
refuse "equal points" "occurs twice" -- "$a" --vary "Bird/Mass=0.1 kg, 100 g"
refuse "a range of unknown size" "whole number" -- "$a" --vary "Bird/Mass=0.1:0.2:many"
refuse "too many points" "10100 points; at most 10000" -- "$a" --vary "Bird/Mass=1:2:101" --vary "Bird/Density=1:2:100"
refuse "pairs of unequal length" "as many values" -- "$a" --vary "Bird/Mass=1, 2" --vary "Bird/Density=1, 2, 3" --pairs
refuse "a case that cannot be, whatever the point" "Action" -- no-such.prm --vary "Bird/Mass=1, 2"
refuse "a run's folder" "folder of a run" -- "${grid[@]}" --output grid/Speed=100-Angle-to-surface=45
mkdir foreign && touch foreign/thesis.tex
refuse "a foreign folder" "no study has written" -- "${grid[@]}" --output foreign
require "refusals leave nothing" '[ ! -e runs ]'

echo "$n_failed failed"
[ $n_failed -eq 0 ]
