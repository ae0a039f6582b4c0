#!/usr/bin/env python3
"""A plane jet cut in two by a plate whose edge is square, round or elliptic, its nose resolved by facets (plane_jet.py has thin plates).

    rounded_edge.py PROGRAM [--nose square,round,ellipse] [--thickness 0.004] [--angle 19] [--across 8,16] [--shifts 8]

The program ends shells and bricks in a square edge. Blades end in a round or elliptic one, of which a mesh sees nothing: so this plate is
one of solid-shells, too heavy and too stiff to move, whose sides follow a semicircle, or a half of an ellipse twice as long, in steps of
15 to 20 degrees, over which contact takes ridges for round. `rigid` is the square edge of Blade/Kind = rigid, as that of shells.

Force along the plate's normal, N, in rho U^2 D, jet 38 mm wide, 19 degrees, edge in its axis, plate 4 mm thick; means over 8, 4, 2, 2 places
of the lattice (0.0944: exact streamlines of a thin plate, 0.13 and 0.11 by this program at D/8 and D/16):

          rigid   round   ellipse
  D/8     0.082   0.060   0.065
  D/16    0.060   0.051   0.060
  D/24    0.048   0.045   0.059
  D/32    0.043   0.047   0.057

One place is off by 0.026 at D/8, 0.010 at D/16 and 0.004 at D/32. A blunt nose turns the flow aside, which a thin plate would catch, whether
it is square or round: half of the force is gone, and the square edge of the model comes to the round one's figure, 0.01 below the ellipse's.
Particles as large as it is thick see most of that (a thin plate takes 0.131 at D/8), those twice as large little.
"""
import argparse
import dataclasses
import math
import pathlib
import subprocess
import tempfile

import free_streamlines
import plane_jet

LONGER = {"round": 1., "ellipse": 2.}  # the nose's half axes, along the plate over across it
TURNS = (10., 25., 40., 55., 70., 90.)  # of the surface's normal from the plate's direction, degrees
HALF_WIDTH, LENGTH = 0.03, 0.19        # m

AS_A_RIGID = ("Blade/Kind=solid", "Blade/Supports/Clamped=root", "Blade/Supports/Tip=tip", "Blade/Mesh/Generator=file",
              "Blade/Element/Formulation=solid-shell", "Blade/Material/Name=custom", "Blade/Material/Density=1e9",
              "Blade/Material/Young's modulus=2.5e12", "Blade/Material/Poisson's ratio=0", "Blade/Material/Hardening=elastic")


def columns(nose, half_thickness):
    """Distance from the nose's end and half height, m, from there on: elements that grow from 1 to 12 mm follow the nose."""
    at = [(0., half_thickness)]
    if nose in LONGER:
        along = LONGER[nose] * half_thickness
        phases = [math.atan(math.tan(math.radians(turn)) / LONGER[nose]) if turn < 90. else 0.5 * math.pi for turn in TURNS]
        at = [(along * (1. - math.cos(phase)), half_thickness * math.sin(phase)) for phase in phases]
    size = 0.001
    while at[-1][0] < LENGTH:
        at.append((at[-1][0] + size, half_thickness))
        size = min(1.3 * size, 0.012)
    return at


def write_mesh(file, nose, half_thickness, angle):
    """Gmsh 2.2, one layer of hexahedra, in the frame of plane_jet.Jet."""
    at = columns(nose, half_thickness)
    sine, cosine = math.sin(angle), math.cos(angle)
    nodes = [(x, s * sine + side * height * cosine, s * cosine - side * height * sine)
             for x in (-HALF_WIDTH, 0., HALF_WIDTH) for s, height in at for side in (-1, 1)]

    def node(i, k, side):
        return 1 + 2 * (i * len(at) + k) + side

    def face(i, k):  # across the thickness
        return [node(i, k, 0), node(i + 1, k, 0), node(i + 1, k, 1), node(i, k, 1)]

    cells = [(3, 1, face(i, len(at) - 1)) for i in (0, 1)] + [(3, 2, face(i, 0)) for i in (0, 1)]
    cells += [(5, 1, [node(i, k, side) if far == 0 else node(i, k + 1, side)
                      for side in (0, 1) for i, far in ((j, 0), (j, 1), (j + 1, 1), (j + 1, 0))])
              for j in (0, 1) for k in range(len(at) - 1)]
    with open(file, "w", encoding="utf8") as mesh:
        mesh.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"root\"\n2 2 \"tip\"\n3 1 \"blade\"\n$EndPhysicalNames\n")
        mesh.write(f"$Nodes\n{len(nodes)}\n")
        mesh.writelines(f"{n} {x:.17g} {y:.17g} {z:.17g}\n" for n, (x, y, z) in enumerate(nodes, 1))
        mesh.write(f"$EndNodes\n$Elements\n{len(cells)}\n")
        mesh.writelines(f"{n} {kind} 2 {group} {group} {' '.join(map(str, of_cell))}\n" for n, (kind, group, of_cell) in enumerate(cells, 1))
        mesh.write("$EndElements\n")


def measure(program, jet, nose, thickness):
    """The force along the plate's normal, in rho U^2 D."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        entries = [f"{entry}={value}" for entry, value in jet.entries().items() if nose == "rigid" or not entry.startswith("Blade/")]
        if nose == "rigid":
            entries += [f"Blade/Rigid/Half thickness={0.5 * thickness}"]
        else:
            write_mesh(folder / "plate.msh", nose, 0.5 * thickness, jet.angle)
            entries += [*AS_A_RIGID, f"Blade/Mesh/File={folder / 'plate.msh'}", "Output/Blade fields=false"]
        command = [program, "run", str(plane_jet.PRM), "--output", str(folder / "run")]
        for entry in entries:
            command += ["--set", entry]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return plane_jet.contact_force(jet, folder / "run")[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--nose", default="rigid,square,round,ellipse")
    parser.add_argument("--thickness", type=float, default=0.004, help="m")
    parser.add_argument("--angle", type=float, default=19., help="degrees between jet and plate")
    parser.add_argument("--across", default="8,16", help="particles across the jet")
    parser.add_argument("--shifts", type=int, default=8, help="places of the lattice against the edge")
    arguments = parser.parse_args()
    angle = math.radians(arguments.angle)
    print(f"thin, exact: {free_streamlines.edge_flow(angle, 0.).force:.4f}")
    for nose in arguments.nose.split(","):
        for across in map(int, arguments.across.split(",")):
            jet = plane_jet.Jet(angle, 0., across, 177.4, 0.)
            forces = [measure(arguments.program, dataclasses.replace(jet, shift=(place + 0.5) / arguments.shifts - 0.5), nose,
                              arguments.thickness) for place in range(arguments.shifts)]
            print(f"{nose:8s} D/{across:<3d} {sum(forces) / len(forces):.4f}   " + " ".join(f"{force:.4f}" for force in forces), flush=True)


if __name__ == "__main__":
    main()
