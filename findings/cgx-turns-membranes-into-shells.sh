#!/usr/bin/env bash
# CalculiX cgx 2.17 changes element types when it writes a deck that it read.
# Guess: "read in.inp inp" and "send all abq", the usual way to edit a deck in
# cgx, keep the element types of the deck.
# Seen: C3D8R stays C3D8R, but a membrane M3D4 and a shell with reduced
# integration S4R are both written as S4. There is no message.
# Why it matters: a membrane has no bending stiffness and lets a bird through
# that a shell holds. S4R and S4 differ in cost and in locking.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(calculix-cgx=2.17+dfsg-2+b1)
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
*NODE,NSET=NALL
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
*ELEMENT,TYPE=C3D8R,ELSET=BIRD
1,1,2,3,4,5,6,7,8
*ELEMENT,TYPE=S4R,ELSET=SKIN
2,1,2,3,4
*ELEMENT,TYPE=M3D4,ELSET=FOIL
3,5,6,7,8
EOF
printf 'read in.inp inp\nsend all abq\nquit\n' > convert.fbd
cgx -bg convert.fbd > cgx.log 2>&1
echo "in:";  grep '^\*ELEMENT' in.inp
echo "out:"; sed -n '/^\*ELEMENT/,$p' all.msh
elements=$(sed -n '/^\*ELEMENT/,$p' all.msh | awk -F, '
  /^\*/ { split($2, a, "="); type = a[2]; next }
  NF > 4 { printf "%d %s;", $1, type }')
echo "element and type: $elements"
[ "$elements" = "1 C3D8R;2 S4;3 S4;" ]
