#!/usr/bin/env bash
# vtk.js 37.4.3 (npm): a range from getRange changes at the next call.
# Guess: the two numbers from array.getRange(-1), the range of the magnitude,
# are the caller's own, as with GetRange of VTK in Python.
# Seen: all calls hand out the same pair. After getRange(0), the range of x, the
# pair from before has the range of x in it as well.
# Why it matters: a viewer takes the range of the magnitude and that of each
# component first, and then sets the colour scales. All plots get the scale of
# the last component, and the peak velocity in the legend is wrong.
# The check: the velocities (3, 4, 0) and (0, 0, 0) have magnitudes from 0 to 5.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
npm pack --silent @kitware/vtk.js@37.4.3 fast-deep-equal@3.1.3 seedrandom@3.0.5 > packed.txt
while read -r file; do # unpack each as npm would, by the name in it
  mkdir one && tar -xzf "$file" -C one
  to=node_modules/$(node -p 'require("./one/package/package.json").name')
  mkdir -p "$(dirname "$to")" && mv one/package "$to" && rmdir one
done < packed.txt

cat > range.mjs <<'EOF'
import vtkDataArray from "@kitware/vtk.js/Common/Core/DataArray.js";
const velocity = vtkDataArray.newInstance(
  { name: "velocity", numberOfComponents: 3, values: Float64Array.from([3, 4, 0, 0, 0, 0]) });
const magnitude = velocity.getRange(-1);
const before = magnitude.join();
const x = velocity.getRange(0);
console.log("range of the magnitude:", before, "and after asking for x:", magnitude.join());
console.log("range of x:", x.join(), "the same pair:", x === magnitude);
process.exit(before === "0,5" && x.join() === "0,3" && magnitude.join() === "0,3" ? 0 : 1);
EOF
node range.mjs
