#!/usr/bin/env bash
# meshio 5.0.0 (Debian 7.0.0-3) keeps only the last part of an Abaqus node set.
# Guess: several *NSET cards of one name add up to one set, as CalculiX ccx 2.20
# reads them and as *ELEMENT cards with one ELSET do in meshio too.
# Seen: the set has the nodes of the last card only. No warning is given.
# Why it matters: pre-processors write the support in pieces, one card a part.
# After the conversion the plate is held on one side only.
# The check: a set of the nodes 1, 2 and then 3, in both programs.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(python3-meshio=7.0.0-3 calculix-ccx=2.20-1)
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

cat > set.inp <<'EOF'
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
*ELEMENT,TYPE=S4,ELSET=SKIN
1,1,2,3,4
*NSET,NSET=FIX
1,2
*NSET,NSET=FIX
3
*MATERIAL,NAME=M
*ELASTIC
70000.,0.3
*SHELL SECTION,MATERIAL=M,ELSET=SKIN
0.1
*BOUNDARY
FIX,1,6
*STEP
*STATIC
*CLOAD
4,3,1.0
*NODE PRINT,NSET=FIX
U
*END STEP
EOF
ccx set > set.log
ccx_nodes=$(awk 'NF == 4 { printf "%s ", $1 }' set.dat)
meshio_nodes=$(/usr/bin/python3 -c '
import meshio
print(*(int(i) + 1 for i in meshio.read("set.inp").point_sets["FIX"]), end=" ")')
echo "nodes of FIX in ccx: $ccx_nodes, in meshio: $meshio_nodes"
[ "$ccx_nodes" = "1 2 3 " ] && [ "$meshio_nodes" = "3 " ]
