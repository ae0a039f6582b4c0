#!/usr/bin/env bash
# CalculiX ccx 2.20: a shell stands still in spite of its initial velocity.
# Guess: a free S4 plate, all of whose nodes start with 10 m/s, has moved by
# 0.1 m after 0.01 s, as the same body of C3D8 elements does.
# Seen: the plate has not moved at all and its kinetic energy is 0. The nodes'
# velocity is still printed as 10 m/s. ccx turns a shell into solid elements
# with nodes of their own, and these do not get the initial velocity.
# Why it matters: in a bird strike the bird or a fan blade starts with a given
# velocity. Modelled by shells it carries no momentum, and no warning says so.
# The check: the same deck with solids moves 0.1 m, and its energy is 5 J.
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

deck() { # element type, connectivity, section card, thickness line
cat <<EOF
*NODE,NSET=NALL
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
$5*ELEMENT,TYPE=$1,ELSET=EALL
1,$2
*MATERIAL,NAME=M
*ELASTIC
70000.,0.3
*DENSITY
1.0
*$3 SECTION,MATERIAL=M,ELSET=EALL
$4*INITIAL CONDITIONS,TYPE=VELOCITY
NALL,3,10.0
*STEP,INC=100,NLGEOM
*DYNAMIC,DIRECT
0.001,0.01
*NODE PRINT,NSET=NALL,FREQUENCY=10
U,V
*EL PRINT,ELSET=EALL,TOTALS=ONLY,FREQUENCY=10
ELKE
*END STEP
EOF
}
nl=$'\n'
deck S4 1,2,3,4 SHELL "0.1$nl" "" > shell.inp
deck C3D8 1,2,3,4,5,6,7,8 SOLID "" \
  "5,0,0,0.1${nl}6,1,0,0.1${nl}7,1,1,0.1${nl}8,0,1,0.1$nl" > solid.inp
for job in shell solid; do
  ccx "$job" > "$job.log"
  read -r u < <(awk '/displ/ { p = 1 } p && $1 == 1 { print $4; exit }' "$job.dat")
  read -r v < <(awk '/veloc/ { p = 1 } p && $1 == 1 { print $4; exit }' "$job.dat")
  e=$(grep -A2 'kinetic' "$job.dat" | awk 'NF == 1 { print $1 }')
  echo "$job: moved $u m, velocity $v m/s, kinetic energy $e J"
  echo "$u $v $e" >> seen.txt
done
awk 'NR == 1 { shell = $1 == 0 && $2 == 10 && $3 == 0 }
  NR == 2 { solid = $1 > 0.0999 && $1 < 0.1001 && $3 > 4.99 && $3 < 5.01 }
  END { exit !(shell && solid) }' seen.txt
