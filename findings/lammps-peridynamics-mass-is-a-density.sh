#!/usr/bin/env bash
# LAMMPS of 29 September 2021: in peridynamics the "mass" has no volume in it.
# Guess: with atom_style peri, set density 2200 and set volume 1.25e-10 in SI
# units, mass(all) is density times volume, and ke is in joule.
# Seen: mass(all) is the sum of the densities. The kinetic energy is one half of
# density times velocity squared, summed over points, whatever the volume is.
# Why it matters: the energy balance of a brittle target (a windshield, ice) is
# read from ke. It is off by the volume of a point, here a factor of 8e9.
# The check: 8 points at 1 m/s. Right would be 2.2e-6 kg and 1.1e-6 J.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(lammps=20220106.git7586adbb6a+ds1-2+b2)
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

cat > ice.in <<'EOF'
units si
boundary s s s
atom_style peri
atom_modify map array
neighbor 0.001 bin
region all block 0 0.001 0 0.001 0 0.001 units box
create_box 1 all
lattice sc 0.0005 origin 0.5 0.5 0.5
create_atoms 1 region all
pair_style peri/pmb
pair_coeff * * 1.6863e22 0.0015001 0.0005 0.25
set group all density 2200
set group all volume 1.25e-10
velocity all set 1.0 0 0 units box
fix 1 all nve
thermo_style custom step ke atoms
variable m equal mass(all)
variable k equal ke
variable n equal count(all)
run 0
print "points ${n} mass ${m} energy ${k}"
EOF
lmp -in ice.in -log none > ice.log
line=$(grep '^points' ice.log)
echo "$line (density * volume * 8 = 2.2e-06, energy 1.1e-06)"
[ "$line" = "points 8 mass 17600 energy 8800" ]
