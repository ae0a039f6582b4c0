#!/usr/bin/env bash
# CalculiX ccx 2.20: RF of *NODE PRINT is no reaction where a load acts too.
# Guess: the RF total over the support of a block is the weight of the block,
# and RF at a free node under a load is 0.
# Seen: RF is the force of the elements on the node, with no loads taken off.
# The part of the weight that acts on the support nodes themselves is missing.
# For a block of one element that is half of it. A free node under a *CLOAD
# shows that load, so a sum over all nodes is 0.
# Why it matters: the force on a frame under a bird strike pressure is read
# from RF. On a coarse mesh it is far too small, and no message says so.
# The check: a block of weight 1 stands on four nodes and shows 0.5.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(calculix-ccx=2.20-1)
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

cat > block.inp <<'EOF'
*NODE,NSET=NALL
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*NSET,NSET=BOT
1,2,3,4
*ELEMENT,TYPE=C3D8,ELSET=EALL
1,1,2,3,4,5,6,7,8
*MATERIAL,NAME=M
*ELASTIC
70000.,0.0
*DENSITY
1.0
*SOLID SECTION,MATERIAL=M,ELSET=EALL
*BOUNDARY
BOT,1,3
*STEP
*STATIC
*DLOAD
EALL,GRAV,1.0,0,0,-1
*NODE PRINT,NSET=BOT,TOTALS=ONLY
RF
*END STEP
EOF
ccx block > block.log
cat block.dat
rf=$(grep -A2 'total force' block.dat | awk 'NF == 3 { print $3 }')
echo "weight 1, RF total of the support $rf"
awk -v f="$rf" 'BEGIN { exit !(f > 0.4999 && f < 0.5001) }'
