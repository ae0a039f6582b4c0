#!/usr/bin/env bash
# VTK 9.1.0: the volume of a hexahedron with warped faces is not its volume.
# Guess: vtkCellSizeFilter and vtkIntegrateAttributes give the volume of the
# trilinear hexahedron, the shape that VTK's own interpolation uses and that a
# finite element code integrates.
# Seen: the cell is cut into five tetrahedra with flat faces. The cut depends on
# the node that comes first, so the same cell has two volumes.
# Why it matters: mass and density of a crushed bird, found from the output, are
# off by several percent, and do not add up to those that the solver prints.
# The check: a unit cube with one corner raised by 1 has the volume 5/4 (the
# mean of x y is 1/4). VTK says 4/3, or 7/6 after a turn of the node numbers.
set -euo pipefail
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT

# Unpacks the pinned packages, and what they need and is missing here, in $tmp.
packages=(python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1)
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

/usr/bin/python3 - <<'EOF'
import vtk
vtk.vtkObject.GlobalWarningDisplayOff()
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def grid(points, cells):
    mesh = vtk.vtkUnstructuredGrid()
    at = vtk.vtkPoints()
    at.SetDataTypeToDouble()
    for p in points:
        at.InsertNextPoint(p)
    mesh.SetPoints(at)
    for kind, nodes in cells:
        mesh.InsertNextCell(kind, len(nodes), nodes)
    return mesh


def volumes(order):
    points = CUBE[:6] + [(1, 1, 2)] + CUBE[7:]
    mesh = grid(points, [(12, order)])
    size = vtk.vtkCellSizeFilter()
    size.SetInputData(mesh)
    size.Update()
    total = vtk.vtkIntegrateAttributes()
    total.SetInputData(mesh)
    total.Update()
    return [round(task.GetOutput().GetCellData().GetArray(name).GetValue(0), 6)
            for task, name in ((size, "Volume"), (total, "Volume"))]


first = volumes([0, 1, 2, 3, 4, 5, 6, 7])
turned = volumes([1, 2, 3, 0, 5, 6, 7, 4])
print("exact 1.25, first numbering:", first, "turned by 90 degrees:", turned)
raise SystemExit(not (first == [1.333333] * 2 and turned == [1.166667] * 2))
EOF
