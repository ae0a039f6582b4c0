#!/usr/bin/env bash
# Gmsh 4.8.4 gives new numbers when it saves MSH 2.2, and only then.
# Guess: reading a mesh and saving it keeps the numbers of nodes and elements,
# as they are part of the format and may have gaps.
# Seen: saved as MSH 2.2, nodes 101, 205, 309, 4000 become 1, 2, 3, 4 and element
# 77 becomes 1. Saved as MSH 4.1, Abaqus or Nastran, all keep their numbers.
# Why it matters: a list of nodes for strain gauges or for a support, made from
# the old file, points at other nodes afterwards. The new numbers exist as well
# (in a larger mesh), so nothing fails.
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

cat > in.msh <<'EOF'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 7 "bird"
$EndPhysicalNames
$Nodes
4
101 0 0 0
205 1 0 0
309 0 1 0
4000 0 0 1
$EndNodes
$Elements
1
77 4 2 7 3 101 205 309 4000
$EndElements
EOF
for format in msh22 msh41 inp bdf; do
  gmsh in.msh -save -format "$format" -o "out.$format" -v 1
done
echo "MSH 2.2:"; sed -n '/^\$Elements/,/^\$EndElements/p' out.msh22
echo "MSH 4.1:"; sed -n '/^\$Elements/,/^\$EndElements/p' out.msh41
echo "Abaqus:";  grep -A1 '^\*ELEMENT' out.inp
echo "Nastran:"; grep '^CTETRA' out.bdf
grep -q '^1 4 2 7 3 1 2 3 4 *$' out.msh22 &&
  grep -q '^77 101 205 309 4000' out.msh41 &&
  grep -q '^77, 101, 205, 309, 4000' out.inp &&
  grep -Eq '^CTETRA +77 +3 +101 +205 +309 +4000' out.bdf
