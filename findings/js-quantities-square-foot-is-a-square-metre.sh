#!/usr/bin/env bash
# js-quantities 1.8.0 (npm): one sqft is one square metre.
# Guess: 1 sqft is 0.09290304 m2, as 1 ft2 is in the same package.
# Seen: "sqft" is known as a unit of area, but its factor was left at 1.
# Why it matters: a pressure of 1000 lbf/sqft on a tail or a windshield comes
# out as 4448 Pa and not 47880 Pa. The unit is accepted and the dimensions fit,
# so nothing warns of the factor of 10.76.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
npm pack --silent js-quantities@1.8.0 > packed.txt
while read -r file; do # unpack each as npm would, by the name in it
  mkdir one && tar -xzf "$file" -C one
  to=node_modules/$(node -p 'require("./one/package/package.json").name')
  mkdir -p "$(dirname "$to")" && mv one/package "$to" && rmdir one
done < packed.txt

cat > area.cjs <<'EOF'
const Qty = require("js-quantities");
const sqft = Qty("1 sqft").to("m2").scalar;
const ft2 = Qty("1 ft2").to("m2").scalar;
const pressure = Qty("1000 lbf/sqft").to("Pa").scalar;
console.log("1 sqft =", sqft, "m2, 1 ft2 =", ft2, "m2, 1000 lbf/sqft =", pressure, "Pa");
const near = (a, b) => Math.abs(a / b - 1) < 1e-4;
process.exit(sqft === 1 && near(ft2, 0.09290304) && near(pressure, 4448.22) ? 0 : 1);
EOF
node area.cjs
