#!/usr/bin/env bash
# CalculiX ccx 2.20: in an axisymmetric model the load is for the whole ring,
# but the reaction is for a slice of 2 degrees.
# Guess: a ring of CAX4 elements loaded by a total of 2 N on its upper nodes
# shows a reaction of 2 N in *NODE PRINT, RF.
# Seen: the printed total is 0.0111 N, that is 2 N times 2/360. Volume and mass
# (EVOL, EMAS) are those of the slice too, although *CLOAD is not.
# Why it matters: a round impactor on a round plate is often run like this. Its
# peak force read from the output is 180 times too small, with no hint.
# The check: reaction times 180 is the load, volume times 180 is 3 pi.
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

cat > ring.inp <<'EOF'
*NODE,NSET=NALL
1,1.,0,0
2,2.,0,0
3,2.,1.,0
4,1.,1.,0
*NSET,NSET=TOP
3,4
*NSET,NSET=BOT
1,2
*ELEMENT,TYPE=CAX4,ELSET=RING
1,1,2,3,4
*MATERIAL,NAME=M
*ELASTIC
70000.,0.0
*DENSITY
1.0
*SOLID SECTION,MATERIAL=M,ELSET=RING
*BOUNDARY
BOT,2,2
*STEP
*STATIC
*CLOAD
TOP,2,-1.0
*NODE PRINT,NSET=BOT,TOTALS=ONLY
RF
*EL PRINT,ELSET=RING,TOTALS=ONLY
EVOL
*END STEP
EOF
ccx ring > ring.log
cat ring.dat
force=$(grep -A2 'total force' ring.dat | awk 'NF == 3 { print $2 }')
volume=$(grep -A2 'total volume' ring.dat | awk 'NF == 1 { print $1 }')
awk -v f="$force" -v v="$volume" 'BEGIN {
  print "load 2, reaction", f, "times 180 =", 180 * f
  print "ring volume 9.42478, printed", v, "times 180 =", 180 * v
  exit !(180 * f > 1.99 && 180 * f < 2.01 && 180 * v > 9.41 && 180 * v < 9.44) }'
