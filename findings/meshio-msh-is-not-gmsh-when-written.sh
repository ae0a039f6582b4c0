#!/usr/bin/env bash
# meshio 5.0.0 (Debian 7.0.0-3) reads .msh as Gmsh, but writes it as Fluent.
# Guess: mesh.write("out.msh") of a mesh that was read from Gmsh's in.msh writes
# a Gmsh file, with the physical groups.
# Seen: the ending stands for two formats. Reading tries both. Writing takes the
# format of ANSYS Fluent and leaves out all cell data, so the tags of the
# physical groups are gone, with no warning.
# Why it matters: a script that only shifts or scales a mesh loses the names of
# bird, plate and support. meshio itself reads its file back without complaint.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(python3-meshio=7.0.0-3)
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

cat > in.msh <<'EOF'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 7 "bird"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
$EndNodes
$Elements
1
1 4 2 7 3 1 2 3 4
$EndElements
EOF
/usr/bin/python3 - <<'EOF'
import meshio
first = meshio.read("in.msh")
first.write("out.msh")
again = meshio.read("out.msh")
start = open("out.msh", "rb").readline()
print("first line of the written file:", start)
for name, mesh in (("in.msh", first), ("out.msh", again)):
    print(name, mesh.cells, "cell data", list(mesh.cell_data), "names", list(mesh.field_data))
raise SystemExit(not (start.startswith(b'(1 "meshio') and list(first.field_data) == ["bird"]
                      and "gmsh:physical" in first.cell_data
                      and len(again.cells_dict["tetra"]) == 1
                      and not again.cell_data and not again.field_data))
EOF
