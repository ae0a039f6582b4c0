#!/usr/bin/env bash
# CalculiX ccx 2.20: SECTION=CIRC takes diameters, SECTION=PIPE takes a radius.
# Guess: *BEAM SECTION, SECTION=CIRC takes the radius, as in Abaqus, whose deck
# format ccx reads, and as SECTION=PIPE takes the outer radius.
# Seen: CIRC with 0.1 is a bar of diameter 0.1. PIPE with 0.1 is a tube of outer
# radius 0.1. A full rod has less volume than the tube of the same number.
# Why it matters: an Abaqus deck with round stiffeners or bolts runs, but with
# a quarter of the area and mass, and a sixteenth of the bending stiffness.
# The check: volume of a rod 1 m long, which is near pi/4 0.1^2 = 0.00785 and
# not pi 0.1^2 = 0.0314. The tube has pi (0.1^2 - 0.08^2) = 0.01131.
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

for section in CIRC PIPE; do
  second=0.1; [ "$section" = PIPE ] && second=0.02
  cat > "$section.inp" <<EOF
*NODE,NSET=NALL
1,0,0,0
2,1,0,0
3,0.5,0,0
*ELEMENT,TYPE=B32R,ELSET=ROD
1,1,3,2
*MATERIAL,NAME=M
*ELASTIC
70000.,0.3
*BEAM SECTION,MATERIAL=M,ELSET=ROD,SECTION=$section
0.1,$second
0,1,0
*BOUNDARY
1,1,6
*STEP
*STATIC
*CLOAD
2,1,1.0
*EL PRINT,ELSET=ROD,TOTALS=ONLY
EVOL
*END STEP
EOF
  ccx "$section" > "$section.log"
  volume=$(grep -A2 'total volume' "$section.dat" | awk 'NF == 1 { print $1 }')
  echo "$section 0.1,$second: volume $volume"
  echo "$volume" >> seen.txt
done
awk 'NR == 1 { rod = $1 > 0.0077 && $1 < 0.0079 }
  NR == 2 { tube = $1 > 0.0113 && $1 < 0.0114 }
  END { exit !(rod && tube) }' seen.txt
