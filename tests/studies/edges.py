#!/usr/bin/env python3
"""Edges of contact: tables of impulse against particle spacing.

    edges.py PROGRAM [--case half-jet,oblique,edge-on,leading-edge] [--spacing 5,4,3,2.5,2,1.5] [--threads N]

half-jet      A cylinder flies along the normal at a rigid plate whose edge passes through its axis, the lattice shifted
              across the flight by -3/8, -1/8, 1/8, 3/8 of a spacing against the edge: the mean, and the four. Half of the
              momentum, 8.91 N s, is that of the mass in the way; the jet that turns round the edge takes some with it.
oblique       The same for prm/oblique.prm on a rigid plate (--half-thickness, m). plane_jet.py has an exact reference
              for the plane flow of both.
leading-edge  prm/oblique.prm to 0.9 ms, shell and solid: impulse, tip, plastic work.
edge-on       A bird of 100.5 g flies along the chord at the middle of the leading edge, shell and solid. Free streamlines
              (Kirchhoff, drag coefficient 0.88 on the thickness) give about 1.05 N s.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parents[2]
SHIFTS = (-0.375, -0.125, 0.125, 0.375)
SINE = 179.2710 / 302.1  # of the angle between flight and plate in prm/oblique.prm
QUIET = {"Output/Field interval": "0", "Output/Bird fields": "false", "Output/Blade fields": "false",
         "Output/History interval": "1e-5"}


def run(arguments, prm, entries):
    with tempfile.TemporaryDirectory() as folder:
        command = [arguments.program, "run", str(prm), "--output", folder]
        for name, value in {**QUIET, "Time/Threads": str(arguments.threads), **entries}.items():
            command += ["--set", f"{name}={value}"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return json.loads((pathlib.Path(folder) / "summary.json").read_text())


def mean_over_shifts(arguments, name, prm, spacing, entries, entry, value):
    impulses = [run(arguments, prm, {**entries, "Bird/Particle spacing": spacing, entry: value(shift * spacing)})
                ["contact"]["impulse"] for shift in SHIFTS]
    normal = [impulse[2] for impulse in impulses]
    print(f"{name:12s} {1e3 * spacing:4g} mm  normal {sum(normal) / 4:7.3f} N s  along the plate "
          f"{sum(impulse[1] for impulse in impulses) / 4:6.3f} N s   " + " ".join(f"{value:.3f}" for value in normal), flush=True)


def half_jet(arguments, spacing):
    mean_over_shifts(arguments, "half-jet", HERE / "prm/rigid-plate.prm", spacing,
                     {"Blade/Rigid/Width": "0.2", "Blade/Rigid/Centre": "0, 0.1, 0", "Contact/Pressure patches": "",
                      "Blade/Rigid/Half thickness": arguments.half_thickness, "Time/End time": "0.9e-3"},
                     "Bird/Aim point", lambda shift: f"0, {shift}, 0")


def oblique(arguments, spacing):
    mean_over_shifts(arguments, "oblique", HERE / "prm/oblique.prm", spacing,
                     {"Blade/Kind": "rigid", "Blade/Probes": "", "Blade/Rigid/Length": "0.3112",
                      "Blade/Rigid/Width": "0.0889", "Blade/Rigid/Centre": "0.1556, 0, 0",
                      "Blade/Rigid/Half thickness": arguments.half_thickness, "Time/End time": "0.9e-3"},
                     "Bird/Chordwise offset", lambda shift: str(-0.04445 + shift / SINE))


def deformable(arguments, name, prm, spacing, entries):
    for kind in ("shell", "solid"):
        summary = run(arguments, prm, {**entries, "Blade/Kind": kind, "Bird/Particle spacing": spacing})
        impulse = summary["contact"]["impulse"]
        print(f"{name:12s} {kind} {1e3 * spacing:4g} mm  normal {impulse[2]:7.3f}  along the chord {impulse[1]:6.3f} N s  "
              f"tip {1e3 * summary['tip']['peak']:6.2f} mm  plastic {summary['plastic']['work']:6.1f} J", flush=True)


def leading_edge(arguments, spacing):
    deformable(arguments, "leading-edge", HERE / "prm/oblique.prm", spacing, {"Time/End time": "0.9e-3"})


def edge_on(arguments, spacing):
    deformable(arguments, "edge-on", HERE / "prm/frontal.prm", spacing,
               {"Blade/Mesh/Elements along span": "31", "Blade/Mesh/Elements along chord": "9", "Case/Symmetry plane": "none",
                "Bird/Velocity": "0, 177.4, 0", "Bird/Aim point": "0.2, -0.04445, 0", "Time/End time": "0.8e-3"})


def main():
    cases = {"half-jet": half_jet, "oblique": oblique, "leading-edge": leading_edge, "edge-on": edge_on}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--case", default=",".join(cases))
    parser.add_argument("--spacing", default="5,4,3,2.5", help="mm")
    parser.add_argument("--half-thickness", default="0.002", help="m, of the rigid plates")
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    for case in arguments.case.split(","):
        for spacing in arguments.spacing.split(","):
            cases[case](arguments, 1e-3 * float(spacing))


if __name__ == "__main__":
    main()
