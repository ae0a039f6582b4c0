#!/usr/bin/env bash
# Gmsh 4.8.4 with meshio 5.0.0 (Debian 7.0.0-3): a named surface that was
# reversed by a minus sign is empty, and in MSH 4.1 it is not reversed.
# Guess: Physical Surface("bottom", 3) = {-1} gives elements turned round, in
# either version of the mesh format, and meshio has them in the set "bottom".
# Seen: MSH 2.2 has the nodes in reverse order and the tag 3. MSH 4.1 has them in
# the old order, and the tag is -3, to be undone by the reader. meshio takes the
# tag as it is, so "bottom" has no element at all, without a word.
# Why it matters: a pressure or a contact surface that was turned to face the
# bird vanishes from the model, or keeps its old normal.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(gmsh=4.8.4+ds2-3 python3-meshio=7.0.0-3)
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

cat > plate.geo <<'EOF'
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1:4} = 2;
Transfinite Surface {1};
Recombine Surface {1};
Physical Surface("bottom", 3) = {-1};
EOF
gmsh plate.geo -2 -format msh22 -o v2.msh -v 1
gmsh plate.geo -2 -format msh41 -o v4.msh -v 1
/usr/bin/python3 - <<'EOF'
import meshio
seen = {}
for name in ("v2", "v4"):
    mesh = meshio.read(name + ".msh", "gmsh")
    tag = int(mesh.cell_data["gmsh:physical"][0][0])
    quad = mesh.cells_dict["quad"][0]
    a, b, c = (mesh.points[quad[i]] for i in range(3))
    normal = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    sets = {k: sum(len(p) for p in v) for k, v in mesh.cell_sets.items() if k == "bottom"}
    print(name, "quad", quad.tolist(), "normal z", normal, "tag", tag,
          "names", {k: v.tolist() for k, v in mesh.field_data.items()}, "set sizes", sets)
    seen[name] = (normal, tag, sets.get("bottom"))
raise SystemExit(not (seen["v2"][:2] == (-1.0, 3) and seen["v4"] == (1.0, -3, 0)))
EOF
