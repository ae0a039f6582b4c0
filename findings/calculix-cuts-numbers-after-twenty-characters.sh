#!/usr/bin/env bash
# CalculiX ccx 2.20 reads only the first 20 characters of a number.
# Guess: 1.234567890123456789e-05 in a deck is read as 1.23e-05. It is a
# plain decimal number, in the format that numpy.savetxt writes by default.
# Seen: the exponent stands behind the 20th character and is dropped without a
# word. The coordinate is read as 1.23, that is 100000 times too large. A load
# of 1.234567890123456789e-01 is read as 1.23 too, ten times too large.
# Why it matters: a deck that a script writes with full precision has another
# geometry and other loads, and the run ends with no error.
# The check: a bar of length L, E = 1 and area 1 under a force F moves F L / E.
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

cat > bar.inp <<'EOF'
*NODE,NSET=NALL
1,0,0,0
2,1.234567890123456789e-05,0,0
*ELEMENT,TYPE=T3D2,ELSET=BAR
1,1,2
*MATERIAL,NAME=M
*ELASTIC
1.0,0.3
*SOLID SECTION,MATERIAL=M,ELSET=BAR
1.0
*BOUNDARY
1,1,3
2,2,3
*STEP
*STATIC
*CLOAD
2,1,1.234567890123456789e-01
*NODE FILE
U
*NODE PRINT,NSET=NALL
U
*END STEP
EOF
ccx bar > bar.log
echo "nodes as read:"
grep -A2 '^    2C' bar.frd | tail -n 2
moved=$(awk '$1 == 2 && NF == 4 { print $2 }' bar.dat)
echo "end moved by $moved; right would be 1.524158E-06"
if grep -qi 'error\|warning' bar.log; then echo "ccx complained"; exit 1; fi
awk -v u="$moved" 'BEGIN { exit !(u > 1.52415 && u < 1.52417) }'
