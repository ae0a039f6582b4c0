#!/usr/bin/env bash
# `birdstrike run --target-error` from outside: a claim, its reuse, refusals. Usage: target_error.sh PROGRAM TOP
. "$(dirname "$0")/from_outside.sh" run "$1" "$2"

strike=("$top/prm/quickstart.prm" --set "Bird/Particle spacing=0.005" --set "Time/End time=0.3e-3" --set "Output/Field interval=0")

ask "a claim" 0 "Contact: impulse \(norm\) [0-9.]+ N s \+- [0-9.]+ %" "of the bird [0-9.]+ %, of the mesh [0-9.]+ %, of both together" "runs; this one in claim/Elements|runs; this one in claim/Particle" "altogether" -- "${strike[@]}" --target-error "impulse = 14 %" --output claim
bar=$(sed -nE 's/^Contact: impulse .* \+- ([0-9.]+) %$/\1/p' out.txt)
require "its bar is within the target" 'awk -v bar="${bar:-99}" "BEGIN {exit !(bar > 0 && bar <= 14)}"'
require "every run has its folder and its row" '[ "$(ls -d claim/*/ | wc -l)" -eq "$(($(wc -l <claim/target.csv) - 1))" ] && [ "$(ls -d claim/*/ | wc -l)" -ge 6 ]'
ask "which quantity is told first" 0 "^Target: Contact: impulse \(norm\), with an error of 14 % at most.$" -- "${strike[@]}" --target-error "impulse = 14 %" --output claim
require "the claim is there for scripts" 'python3 -c "import json; c = json.load(open(\"claim/target.json\")); e = c[\"error\"]; assert c[\"quantity\"] == \"Contact: impulse (norm)\" and 0 < e[\"whole\"] <= 0.14 * c[\"value\"] and abs(e[\"whole\"] - e[\"bird\"] - e[\"mesh\"] - e[\"both_together\"]) < 1e-12, c"'
ask "another quantity would lose the table" 2 "tables of another target, with 'Contact: impulse \(norm\)'" "--force" -- "${strike[@]}" --target-error "plastic work = 14 %" --output claim
stamps=$(stat -c %Y.%y claim/*/history.csv)
ask "the same again" 0 "impulse" -- "${strike[@]}" --target-error "impulse = 14 %" --output claim
require "computes nothing" '[ "$stamps" = "$(stat -c %Y.%y claim/*/history.csv)" ]'
ask "an order that the levels contradict" 3 "bird: 5 levels to .*, order 0.5 as given, which they reject \(p = 0.0[0-9]*\)" "another --bird-order, or none" "contact/unfinished at all 8" -- "${strike[@]}" --target-error "impulse = 20 %" --bird-order 0.5 --output claim
ask "with an order that is known" 0 "Contact: impulse \(norm\) [0-9.]+ N s \+- [0-9.]+ %" "a run's [0-9.]+ N s, and -?[0-9.]+ m?N s to h = 0 of the particles" "bird: 5 levels to .*, order 2 as given" "mesh: none, and no error of one" -- "$top/prm/rigid-plate.prm" --set "Bird/Particle spacing=0.005" --set "Output/Field interval=0" --target-error "impulse = 3 %" --bird-order 2 --output rigid
ask "means over places of the lattice" 0 "Contact: impulse \(norm\) [0-9.]+ N s \+- [0-9.]+ %" "Values are means over 3 places of the bird's lattice \(Lattice shift\): standard deviation of one run [0-9.]+ %" "runs; of this value the one with the case's own lattice in places/" -- "${strike[@]}" --target-error "impulse = 30 %" --places 3 --output places
value=$(sed -nE "s/^Contact: impulse \(norm\) ([0-9.]+) N s .*/\1/p" out.txt)
require "the value is the mean of three" 'folder=$(sed -nE "s/.*own lattice in (.*)/\1/p" out.txt); awk -F, -v folder="$folder" -v value="$value" "\$5 == folder {spacing = \$1; size = \$2; sum = \$3; n = 1} \$6 > 1 && \$1 == spacing && \$2 == size {sum += \$3; ++n} END {exit !(n == 3 && sum / 3 - value < 1e-3 * value && value - sum / 3 < 1e-3 * value)}" places/target.csv'
require "every pair of levels has all places, and values that differ" 'awk -F, "NR > 1 {n[\$1 \" \" \$2]++; if (\$6 > 1 && \$3 == last) same = 1; last = \$3} END {for (pair in n) if (n[pair] != 3) same = 1; exit same || NR < 16}" places/target.csv'
# half the 95 % interval of a mean of three: 4.302653 standard deviations over the root of 3
require "the mesh's part holds the interval of its finest mean" 'part=$(sed -nE "s/.*of the mesh ([0-9.]+) %.*/\1/p" out.txt); awk -F, -v value="$value" -v part="$part" "NR > 1 && (coarse == \"\" || \$1 > coarse) {coarse = \$1} NR > 1 {x[NR] = \$1; h[NR] = \$2; f[NR] = \$3} END {for (k in h) if (x[k] == coarse && (fine == \"\" || h[k] < fine)) fine = h[k]; for (k in h) if (x[k] == coarse && h[k] == fine) {++n; sum += f[k]; squares += f[k] * f[k]} exit !(n == 3 && part / 100 * value > 0.99 * 4.302653 * sqrt((squares - sum * sum / n) / (n - 1) / n))}" places/target.csv'
ask "without a bird the mesh alone" 0 "bird: none, and no error of one" -- "$top/prm/blade-impulse.prm" --set "Output/Field interval=0" --target-error "tip deflection at the end = 40 %" --output strip
ask "no claim where there is no order" 3 "is not reached, and none is claimed" "bird: .* levels to" "refined together were not run: the value is the sum of both ladders" -- "${strike[@]}" --set "Time/End time=0.05e-3" --target-error "peak plastic strain = 0.01 %" --output none
require "nor of what no run has measured" '! grep -q "both together add to it: " out.txt'
ask "no claim of a peak that is none yet" 3 "Tip: peak \(mid-chord\) still rises at the end" "a later Time/End time" -- "${strike[@]}" --target-error "tip peak = 10 %" --output rising
require "but what was run" '[ "$(wc -l <none/target.csv)" -ge 6 ]'

ask "no claim by levels of several blades" 3 "cannot be claimed: The levels are not of one blade, .*section 0 .* to " -- "$top/prm/blade-impulse.prm" --set "Output/Field interval=0" --set "Blade/Section 1/Material ids=1" --set "Blade/Section 1/Material/Name=Ti-6Al-4V" --set "Blade/Mesh/Material boxes=0 -1 -1 1 -1e-5 1: 1" --target-error "tip deflection at the end = 40 %" --output several

ask "an unknown quantity, before anything is run" 2 "no quantity of any run" "There are: Tip peak" -- "${strike[@]}" --target-error "tip of the iceberg = 2 %" --output unread
of_file=("$top/prm/quickstart.prm" --set "Blade/Mesh/Generator=file" --set "Blade/Mesh/File=$top/meshes/plate-28x8.msh" --set "Blade/Supports/Clamped=root" --set "Blade/Supports/Tip=tip" --set "Bird/Particle spacing=0.005" --set "Time/End time=0.3e-3" --set "Output/Field interval=0")
ask "a mesh from a file: no claim of the whole" 3 "^Target: Contact: impulse.* Mesh: unknown" "^Contact: impulse \(norm\) [0-9.]+ N s; of the bird [0-9.]+ %, mesh: unknown; no error of the whole is claimed$" "^  mesh: unknown; it comes from a file" "cannot be claimed: the error of the mesh is unknown" -- "${of_file[@]}" --target-error "impulse = 20 %" --output of-file
require "no bar, and no zero of what is unknown" '! grep -qE "of the mesh [0-9]|both together|N s \+-" out.txt'
require "nor for scripts" 'python3 -c "import json; e = json.load(open(\"of-file/target.json\"))[\"error\"]; assert e[\"mesh\"] is None and e[\"whole\"] is None and e[\"both_together\"] is None and e[\"bird\"] > 0, e"'
for words in "tip deflection" "tip" "peak" "peak force" "contact force" "root peak" "displacement"; do
  ask "'$words' may be several" 2 "'$words' is ambiguous" "It may be: .*; " "Action: give one of these names" -- "${strike[@]}" --target-error "$words = 5 %" --output unread
done
ask "what a deflection may be" 2 "It may be: Tip peak \(mid-chord\); Tip deflection at the end; Tip permanent deflection.$" -- "${strike[@]}" --target-error "tip deflection = 5 %" --output unread
ask "no percentage" 2 "no error in percent" -- "${strike[@]}" --target-error "tip peak = 2" --output unread
ask "an impossible target" 2 "above 0" -- "${strike[@]}" --target-error "tip peak = 0 %" --output unread
ask "an order of none" 2 "--bird-order 0" "above 0, at most 4" -- "${strike[@]}" --target-error "impulse = 2 %" --bird-order 0 --output unread
ask "an order of no bird" 2 "no bird whose particles" -- "$top/prm/blade-impulse.prm" --target-error "impulse = 2 %" --bird-order 1 --output unread
ask "an order without a target" 2 "requires --target-error" -- "${strike[@]}" --bird-order 1 --output unread
ask "no place" 2 "--places 0" "1 to 64" -- "${strike[@]}" --target-error "impulse = 2 %" --places 0 --output unread
ask "places of no bird" 2 "--places: there is no bird" -- "$top/prm/blade-impulse.prm" --target-error "tip deflection at the end = 40 %" --places 2 --output unread
ask "places without a target" 2 "requires --target-error" -- "${strike[@]}" --places 2 --output unread
ask "nothing to refine" 2 "neither a bird nor" -- "$top/prm/bird-free.prm" --set "Bird/Enabled=false" --target-error "impulse = 2 %" --output unread
ask "a mesh too coarse" 2 "two coarser ones" -- "${strike[@]}" --set "Blade/Mesh/Elements along chord=1" --set "Blade/Mesh/Elements along span=2" --target-error "impulse = 2 %" --output unread
require "refusals leave nothing" '[ ! -e runs ] && [ ! -e unread ]'

echo "$n_failed failed"
[ $n_failed -eq 0 ]
