#!/usr/bin/env bash
# meshio 5.0.0 (Debian 7.0.0-3) writes odd element types to an Abaqus deck.
# Guess: a quadrilateral is written as S4, a triangle as S3, a hexahedron as
# C3D8, or the types of the deck that was read are kept.
# Seen: meshio knows many Abaqus types for one shape and writes the last one. A
# deck with S4, S3 and C3D8 comes back with CAX4P (axisymmetric, with pore
# pressure), R3D3 (rigid!) and C3D8RH (hybrid, one integration point).
# Why it matters: reading a deck and writing it back, to merge or to scale it,
# changes the physics of all elements. A skin of triangles becomes rigid.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(python3-meshio=7.0.0-3)
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

cat > in.inp <<'EOF'
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*ELEMENT,TYPE=S4,ELSET=SKIN
1,1,2,3,4
*ELEMENT,TYPE=S3,ELSET=RIB
2,1,2,5
*ELEMENT,TYPE=C3D8,ELSET=BIRD
3,1,2,3,4,5,6,7,8
EOF
/usr/bin/python3 -c 'import meshio; meshio.read("in.inp").write("out.inp")'
echo "in:";  grep '^\*ELEMENT' in.inp
echo "out:"; grep '^\*ELEMENT' out.inp
types=$(grep -o 'TYPE=[A-Z0-9]*' out.inp | tr '\n' ' ')
[ "$types" = "TYPE=CAX4P TYPE=R3D3 TYPE=C3D8RH " ]
