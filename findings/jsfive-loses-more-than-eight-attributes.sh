#!/usr/bin/env bash
# jsfive 0.4.2 (npm) sees no attributes where a group has more than eight.
# Guess: all attributes of a group are read, in an HDF5 file of any version.
# Seen: from the ninth attribute on, a file written with the new HDF5 format
# keeps them in a dense storage of its own. jsfive then gives {} for the group,
# as if it had none. With eight it gives all eight. h5wasm 0.10.3 reads nine.
# Why it matters: units, time step, material names and version of a run are
# attributes. A viewer in the browser shows them until the ninth is added.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
npm pack --silent jsfive@0.4.2 h5wasm@0.10.3 > packed.txt
while read -r file; do # unpack each as npm would, by the name in it
  mkdir one && tar -xzf "$file" -C one
  to=node_modules/$(node -p 'require("./one/package/package.json").name')
  mkdir -p "$(dirname "$to")" && mv one/package "$to" && rmdir one
done < packed.txt

cat > attributes.mjs <<'EOF'
import fs from "node:fs";
import h5wasm from "h5wasm/node";
import * as jsfive from "jsfive";

await h5wasm.ready;
const seen = {};
for (const count of [8, 9]) {
  const file = new h5wasm.File(`run${count}.h5`, "w", { libver: "latest" });
  const run = file.create_group("run");
  for (let i = 0; i < count; i++) run.create_attribute(`a${i}`, i + 0.5);
  file.close();
  const again = new h5wasm.File(`run${count}.h5`, "r");
  const wasm = Object.keys(again.get("run").attrs).length;
  again.close();
  const bytes = fs.readFileSync(`run${count}.h5`);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const five = Object.keys(new jsfive.File(buffer, "run.h5").get("run").attrs).length;
  console.log(`attributes written ${count}, read by h5wasm ${wasm}, by jsfive ${five}`);
  seen[count] = [wasm, five];
}
process.exit(JSON.stringify(seen) === '{"8":[8,8],"9":[9,0]}' ? 0 : 1);
EOF
node attributes.mjs
