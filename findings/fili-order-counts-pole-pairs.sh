#!/usr/bin/env bash
# fili 2.0.3 (npm): a Butterworth filter of order 2 has four poles.
# Guess: order 2 means two poles, as in Matlab, scipy and SAE J211, and falls
# by 12 dB an octave.
# Seen: the order counts sections of two poles each. Order 1 has two poles, and
# order 2 falls by 24 dB an octave.
# Why it matters: a channel frequency class of SAE J211 is a filter of two poles
# run forwards and backwards. Built from fili's order 2 it has eight poles in
# all, and cuts the peak of a crash or impact pulse too much.
# The check: far below half the sampling rate, the fall from 4 to 8 times the
# cut-off. The two-pole filter of order 1 loses 12 dB, order 2 loses 24 dB.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
npm pack --silent fili@2.0.3 > packed.txt
while read -r file; do # unpack each as npm would, by the name in it
  mkdir one && tar -xzf "$file" -C one
  to=node_modules/$(node -p 'require("./one/package/package.json").name')
  mkdir -p "$(dirname "$to")" && mv one/package "$to" && rmdir one
done < packed.txt

cat > order.cjs <<'EOF'
const fili = require("fili");
const falls = [1, 2].map((order) => {
  const sections = new fili.CalcCascades().lowpass(
    { order, characteristic: "butterworth", Fs: 1e6, Fc: 1000 });
  const gain = (f) => new fili.IirFilter(sections).responsePoint({ Fr: f, Fs: 1e6 }).dBmagnitude;
  const fall = gain(4000) - gain(8000);
  console.log("order", order, "sections", sections.length, "gain at the cut-off",
    gain(1000).toFixed(2), "dB, fall in an octave", fall.toFixed(2), "dB");
  return Math.round(fall);
});
process.exit(falls[0] === 12 && falls[1] === 24 ? 0 : 1);
EOF
node order.cjs
