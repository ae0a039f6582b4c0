#!/usr/bin/env bash
# `birdstrike converge` from outside: ladders, reuse, refusals. Usage: converge.sh PROGRAM TOP
. "$(dirname "$0")/from_outside.sh" converge "$1" "$2"

strip="$top/prm/blade-impulse.prm"
strike=("$top/prm/quickstart.prm" --set "Time/End time=0.1e-3" --set "Output/Field interval=0")

ask "help" 0 "--levels" "--vary" "--ratio" "--finer" -- --help
ask "a ladder of time steps" 0 "3 levels, 0 of them" "h -> 0" "error bar" "Ladder in steps" -- "${strike[@]}" --set "Bird/Particle spacing=0.006" --vary step --output steps
for file in levels.csv converge.csv figures.gp refinement.csv "Step-scale=0.9-Bird-step-scale=1/summary.json"; do
  [ -s "steps/$file" ] || fail "the ladder left no $file"
done
require "what still rises has open markers" 'grep -q "still rising at the end of the run, no peak yet" steps/refinement.svg && grep -q "levels: still rising, no peak yet: peak (mid-chord)" steps/refinement.csv'
require "its picture is drawn" 'grep -q "</svg>" steps/refinement.svg'
require "a row a quantity, a verdict each" '[ "$(grep -cE "(converges|asymptotic range|oscillates|scatters|diverges|does not change|missing)$" steps/converge.csv)" -ge 8 ]'
require "a tip that still rises is no peak" 'grep -qE "^Tip: peak .*,yes,[a-z ]+$" steps/converge.csv && grep -qE "^Plasticity: plastic work,.*,no,[a-z ]+$" steps/converge.csv'
ask "what is there is reused" 0 "3 levels, 3 of them" "Tip: peak .*still rising at the end, no peak" -- "${strike[@]}" --set "Bird/Particle spacing=0.006" --vary step --output steps
ask "particles and mesh together" 0 "3 levels, 0 of them" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --ratio 1.4 --output both
require "the case is the finest level" '[ -s "both/Elements-along-span=31-Elements-along-chord=9-Particle-spacing=0.005/summary.json" ]'
refuse "another ladder would lose the table" "tables of another ladder, with 'Elements-along-span=" "the same ladder again, or with more levels" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --vary particles --output both
refuse "another case would lose runs" "holds a run that would be lost, for Bird/Mass differs" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --set "Bird/Mass=0.11" --ratio 1.4 --output both
require "both are there" '[ -s both/levels.csv ] && [ -s both/refinement.svg ]'
ask "a ladder grows" 0 "4 levels, 3 of them" "by least squares over 4 levels" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --ratio 1.4 --levels 4 --output both
ask "the order is known" 0 "4 levels, 4 of them" "order 1, h -> 0" "95 % confidence interval" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --ratio 1.4 --levels 4 --order 1 --output both
ask "bounds of the order are known" 0 "4 levels, 4 of them" "order 1:2, h -> 0" "that are not rejected" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --ratio 1.4 --levels 4 --order 1:2 --output both
require "they stand in the table" 'grep -qE "^Plasticity: plastic work,.*,1:2,[0-9.e-]+,[0-9.e-]+,[0-9.e-]+,no,[a-z ]+$" both/converge.csv'
ask "an order again" 0 "4 levels, 4 of them" "order 1, h -> 0" -- "${strike[@]}" --set "Bird/Particle spacing=0.005" --ratio 1.4 --levels 4 --order 1 --output both
require "its limit stands in the table" 'head -n 1 both/converge.csv | grep -q ",known order .-.,extrapolated by known order,half of its 95 % interval,p-value of known order .-.,still rising,ladder$" && grep -qE "^Plasticity: plastic work,.*,1,[0-9.e-]+,[0-9.e-]+,[0-9.e-]+,no,[a-z ]+$" both/converge.csv'
ask "means over places of the lattice" 0 "3 levels at 2 places, 6 runs, 0 of them" "one run" "means over 2 places" -- "${strike[@]}" --set "Bird/Particle spacing=0.006" --vary step --places 2 --output places
require "a run a place, and a value a level" '[ -s "places/Step-scale=0.9-Bird-step-scale=1/summary.json" ] && [ -s "places/Step-scale=0.9-Bird-step-scale=1-Lattice-shift=-0.2451--0.4302/summary.json" ] && [ "$(tail -n +2 places/levels.csv | wc -l)" = 6 ] && [ "$(head -n 1 places/converge.csv | grep -o "at h = " | wc -l)" = 3 ]'
ask "points through the thickness" 0 "3 levels" -- "${strike[@]}" --set "Bird/Particle spacing=0.008" --vary points --output points
sheathed=("${strike[@]}" --set "Bird/Particle spacing=0.008" --set "Blade/Section 1/Material ids=1" --set "Blade/Section 1/Material/Name=Al 2024 Johnson-Cook" --vary mesh)
ask "cells that a box takes or leaves are another blade" 0 "not of one blade, .*section 0 .* to .*, section 1 .* to " -- "${sheathed[@]}" --set "Blade/Mesh/Material boxes=0 -1 -1 1 -0.03 1: 1" --output boxes
ask "a patch is the same on each mesh" 0 "3 levels" -- "${sheathed[@]}" --set "Blade/Mesh/Material patches=0 1 0 0.1667: 1" --output patches
require "and nothing is said of it" '! grep -q "of one blade" out.txt'
ask "a lost level" 3 "lost: The energy balance" "Lost: 'Step scale=" -- "${strike[@]}" --set "Bird/Particle spacing=0.008" --set "Time/Energy error limit=1e-12" --vary step --output lost

refuse "no file" "FILE" --
refuse "what is to be refined" "mesh\|particles\|both\|step\|points" -- "${strike[@]}" --vary time
refuse "two levels" "3 to 12" -- "${strike[@]}" --levels 2
refuse "thirteen levels" "3 to 12" -- "${strike[@]}" --levels 13
refuse "an interval of three levels" "4 to 12" -- "${strike[@]}" --order 1
refuse "an order of none" "above 0" -- "${strike[@]}" --levels 4 --order 0
refuse "bounds the wrong way round" "bounds as 1:2" -- "${strike[@]}" --levels 4 --order 2:1
refuse "no place" "1 to 64" -- "${strike[@]}" --places 0
refuse "places of half a bird" "half a bird" -- "${strike[@]}" --set "Case/Symmetry plane=y" --set "Blade/Mesh/Elements along chord=8" --places 2
refuse "a ratio of one" "ratio" -- "${strike[@]}" --ratio 1
refuse "levels that are the same" "Two levels are the same" -- "${strike[@]}" --set "Blade/Mesh/Elements along span=3" --set "Blade/Mesh/Elements along chord=1" --ratio 1.1 --vary mesh
refuse "no bird" "no bird" -- "$strip" --vary particles
refuse "a mesh of a file" "comes from a file" -- "${strike[@]}" --set "Blade/Mesh/Generator=file" --set "Blade/Mesh/File=$top/meshes/README.md" --vary mesh
require "refusals leave nothing" '[ ! -e runs ]'

echo "$n_failed failed"
[ $n_failed -eq 0 ]
