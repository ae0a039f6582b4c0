#!/usr/bin/env bash
# Gmsh 4.8.4 labels the parts of an LS-DYNA file with the wrong group names.
# Guess: the elements of a volume in the physical group "bird" are labelled
# "bird" in the .key file that Gmsh writes.
# Seen: the label is found by the number of the volume, not by its group. Volume
# 1 is in group 2 "bird", volume 2 is in group 1 "plate", and the file calls
# volume 1 "plate" and volume 2 "bird". The Abaqus export has them right.
# Why it matters: bird and plate trade materials, and the run does not fail.
# The check: the bird is the box of height 1 at x = 0. The file says "plate" for
# elements with a node at x = 0.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(gmsh=4.8.4+ds2-3)
apt-cache show "${packages[@]}" >/dev/null 2>&1 || apt-get -qq update
mkdir -p "$tmp/debs/partial" "$tmp/unpacked"
apt-get install -qq -y --no-install-recommends --reinstall --download-only \
  -o Debug::NoLocking=1 -o APT::Sandbox::User=root \
  -o Dir::Cache::archives="$tmp/debs" "${packages[@]}" >/dev/null 2>&1
for deb in "$tmp"/debs/*.deb; do dpkg-deb -x "$deb" "$tmp/unpacked"; done
lib=$(echo "$tmp"/unpacked/usr/lib/*-linux-gnu)
export LD_LIBRARY_PATH="$lib:$lib/blas:$lib/lapack:$tmp/unpacked/usr/lib"
export PATH="$tmp/unpacked/usr/bin:$PATH" OMP_NUM_THREADS=1
export PYTHONPATH="$tmp/unpacked/usr/lib/python3/dist-packages"
cd "$tmp"

cat > two.geo <<'EOF'
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {2, 0, 0, 1, 1, 2};
Mesh.MeshSizeMin = 3;
Mesh.MeshSizeMax = 3;
Physical Volume("bird", 2) = {1};
Physical Volume("plate", 1) = {2};
EOF
for format in key inp; do
  gmsh two.geo -3 -format "$format" -o "two.$format" -v 1
done
# Prints the smallest x of the nodes of the elements below a label.
awk -F, '
  /^\*/ { part = "" }
  /SET_ELEMENT=/ { split($0, a, "="); part = a[2]; next }
  /^\*NODE/ { nodes = 1; next }
  /^\*/ { nodes = 0; next }
  nodes && NF == 4 { x[$1 + 0] = $2 }
  part != "" && NF == 10 { for (i = 3; i <= 10; i++)
    if (!(part in low) || x[$i + 0] < low[part]) low[part] = x[$i + 0] }
  END { for (p in low) print "two.key: label", p, "has its lowest x at", low[p] }
' two.key | sort | tee key.txt
awk -F, '
  /^\*/ { set = ""; block = "" }
  /^\*NODE/ { block = "node"; next }
  /^\*ELEMENT/ { block = "element"; next }
  /^\*ELSET/ { split($2, a, "="); set = a[2]; next }
  block == "node" { x[$1 + 0] = $2 }
  block == "element" { for (i = 2; i <= NF; i++)
    if (!($1 + 0 in e) || x[$i + 0] < e[$1 + 0]) e[$1 + 0] = x[$i + 0] }
  set != "" { for (i = 1; i <= NF; i++) if ($i + 0 > 0)
    if (!(set in low) || e[$i + 0] < low[set]) low[set] = e[$i + 0] }
  END { for (p in low) print "two.inp: set", p, "has its lowest x at", low[p] }
' two.inp | sort | tee inp.txt
grep -Eq 'label bird.* at +2' key.txt && grep -Eq 'label plate.* at +0' key.txt &&
  grep -Eq 'set bird .* at +0' inp.txt && grep -Eq 'set plate .* at +2' inp.txt
