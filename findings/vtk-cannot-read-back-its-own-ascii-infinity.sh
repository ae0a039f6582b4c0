#!/usr/bin/env bash
# VTK 9.1.0 writes an infinite value to an ASCII VTU file, and cannot read that
# file.
# Guess: a file that VTK wrote is read back by VTK. NaN does come back as NaN, so
# infinity comes back as infinity.
# Seen: the writer puts the word "Infinity" in the file. The reader stops at it
# and hands on a grid with no points and no cells. The binary forms are fine.
# Why it matters: infinity marks "never", such as the time of failure of an
# element that did not fail, or a safety factor at zero stress. One of them makes
# the whole frame of an animation empty, although mesh and results are sound.
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

/usr/bin/python3 - 2>/dev/null <<'EOF'
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


counts = {}
for value in ("nan", "inf"):
    mesh = grid(CUBE, [(12, range(8))])
    time = vtk.vtkDoubleArray()
    time.SetName("failure")
    for t in (1.0, 2.0, float(value), 4.0, 5.0, 6.0, 7.0, 8.0):
        time.InsertNextValue(t)
    mesh.GetPointData().AddArray(time)
    for mode in ("Ascii", "Binary", "Appended"):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetInputData(mesh)
        getattr(writer, "SetDataModeTo" + mode)()
        writer.SetFileName("mesh.vtu")
        done = writer.Write()
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName("mesh.vtu")
        reader.Update()
        count = reader.GetOutput().GetNumberOfPoints()
        text = open("mesh.vtu", errors="replace").read().split()
        words = [word for word in text if word in ("NaN", "Infinity")]
        print(f"{value} {mode}: write returns {done}, word in the file {words}, points read {count}")
        counts[value, mode] = count
bad = [key for key, count in counts.items() if count != 8]
raise SystemExit(not (bad == [("inf", "Ascii")] and counts["inf", "Ascii"] == 0))
EOF
