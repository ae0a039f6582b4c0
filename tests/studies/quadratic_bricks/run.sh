#!/usr/bin/env bash
# Does a quadratic brick pay? Frequencies, stable step, cost and a plastic impulse of the plate of prm/frontal.prm in every
# kind of element: tables, CSV and a chart of error against time. Takes some minutes on one core.
# Usage: run.sh BUILD_FOLDER [OUTPUT_FOLDER]; the build needs -DBIRDSTRIKE_BENCHMARKS=ON, the chart gnuplot.
#   bash tests/studies/quadratic_bricks/run.sh build quadratic-bricks
# References of the chart: tip 76.26 mm, of 112 x 32 x 8 one-point bricks and of 56 x 16 x 2 quadratic ones alike, plastic
# work 267 J, to which 261 J of the former and 266.5 J of the latter converge; good to 0.5 % and 1 %.
# FINE=yes runs these two again (two minutes more).
set -euo pipefail
build=$1
output=${2:-quadratic-bricks}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$build/bin/quadratic_bricks
[ -x "$program" ] || cmake --build "$build" --target quadratic_bricks
mkdir -p "$output"
csv=$output/quadratic-bricks.csv
: >"$csv"
study() { "$program" "$@" | tee -a "$csv"; }

for kind in one-point quadratic-g2xg3 quadratic-gl3 quadratic-g3; do study check $kind 3x3x3; done
for rule in g2-bare g2xg3-bare g2xg3 gl3 g3; do study modes "quadratic-$rule" 4x4x1; done
for rule in g2xg3 g3 gl3; do
  for mesh in 7x2x1 14x4x1 28x8x1; do study frequencies "quadratic-$rule" $mesh; done
done
for mesh in 14x4x1 28x8x1 56x16x1; do study frequencies one-point $mesh; done
for mesh in 28x8x1 56x16x1; do study frequencies shell $mesh; done
study frequencies b-bar 28x8x2
for kind in shell one-point b-bar; do
  study step $kind 28x8x1
  study cost $kind 32x16x1
done
for rule in g2 g2xg3 g2xg5 gl3 g3; do
  study step "quadratic-$rule" 14x4x1
  study cost "quadratic-$rule" 16x8x1
done
for mesh in 14x4x1 28x8x1 56x16x1 112x32x1; do study impulse shell $mesh; done
for mesh in 14x4x1 28x8x1 56x16x1 14x4x4 28x8x4 56x16x4; do study impulse one-point $mesh; done
study impulse b-bar 28x8x4
for mesh in 7x2x1 14x4x1 28x8x1; do
  for rule in g2xg5 g2xg3 g3 gl3; do study impulse "quadratic-$rule" $mesh; done
done
for mesh in 7x2x2 14x4x2 28x8x2; do
  for rule in g2xg3 g3 gl3; do study impulse "quadratic-$rule" $mesh; done
done
if [ "${FINE:-}" = yes ]; then
  study impulse one-point 112x32x8
  study impulse quadratic-g2xg5 56x16x2
fi

command -v gnuplot >/dev/null || { echo "no chart without gnuplot: apt-get install gnuplot-nox"; exit 1; }
gnuplot -e "csv='$csv'; chart='$output/quadratic-bricks.svg'; tip=76.26; work=267" "$here/chart.gp"
echo "$csv, $output/quadratic-bricks.svg"
