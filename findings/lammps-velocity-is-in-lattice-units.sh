#!/usr/bin/env bash
# LAMMPS of 29 September 2021: a velocity is scaled by the lattice, in SI too.
# Guess: after "units si", velocity all set 100 0 0 gives all points 100 m/s.
# Seen: lengths in most commands, the velocity among them, are in multiples of
# the last lattice command, unless "units box" is added. With a point spacing of
# 0.5 mm the points get 0.05 m/s. The output shows no sign of it.
# Why it matters: the bird hits at 0.05 m/s, and the lattice that made its points
# sets the factor. With a finer grid the same input gives a
# slower bird.
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

for spacing in 0.0005 0.00025; do
  for more in "" "units box"; do
    cat > bird.in <<EOF
units si
atom_style atomic
region all block 0 0.001 0 0.001 0 0.001 units box
create_box 1 all
lattice sc $spacing
create_atoms 1 single 0.5 0.5 0.5
mass 1 1.0
velocity all set 100.0 0 0 $more
variable v equal vcm(all,x)
run 0
print "velocity \${v}"
EOF
    lmp -in bird.in -log none > bird.log
    got=$(awk '/^velocity/ { print $2 }' bird.log)
    echo "spacing $spacing m, velocity all set 100.0 0 0 $more: $got m/s"
    results="${results:-}$got "
  done
done
[ "$results" = "0.05 100 0.025 100 " ]
