#!/usr/bin/env python3
"""Tip peak of the frontal strike against processor time, for every kind of element and a ladder of meshes.

    python3 tests/studies/tip_peak.py build/bin/birdstrike --output build/tip_peak
    python3 tests/studies/tip_peak.py build/bin/birdstrike --output build/tip_peak --kinds shell "1 brick" --meshes 31x9 62x18

One thread, 4 mm particles, to the tip's first peak. Writes tip_peak.csv and, with gnuplot, tip_peak.svg. Runs whose lines are in the
CSV are not made again: delete the file after a change of the program. The chart is relative to the fully integrated shell on the finest of
its meshes that was run; points of a line are its meshes, from coarse to fine.
"""

import argparse
import csv
import json
import os
import resource
import shutil
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SETTINGS = ("Bird/Particle spacing=0.004", "Time/End time=0.016", "Time/Stop at tip peak=true", "Time/Threads=1",
            "Output/Blade fields=false", "Output/Bird fields=false", "Output/HDF5=false")


def shell(formulation):
    return (f"Blade/Element/Formulation={formulation}",)


def brick(layers, formulation):
    return ("Blade/Kind=solid", f"Blade/Mesh/Layers={layers}", f"Blade/Element/Formulation={formulation}")


def scaled(kind):
    return kind + ("Blade/Mass scaling/Method=selective",)


KINDS = {"shell": shell("physical"), "shell, full": shell("fully integrated"), "shell, Belytschko-Tsay": shell("Belytschko-Tsay"),
         "1 solid-shell": brick(1, "solid-shell"), "1 brick": brick(1, "one point"), "2 bricks": brick(2, "one point"),
         "4 bricks": brick(4, "one point"), "4 bricks, scaled": scaled(brick(4, "one point")), "4 B-bar": brick(4, "B-bar")}
MESHES = ("16x5", "31x9", "62x18", "124x36")
FIELDS = ("kind", "mesh", "peak", "peak_time", "root_moment", "plastic_work", "energy_error", "steps", "cpu")


def run(program, output, kind, mesh):
    """One line of the table; seconds are those of the processor, which a busy machine changes little."""
    span, chord = mesh.split("x")
    settings = SETTINGS + KINDS[kind] + (f"Blade/Mesh/Elements along span={span}", f"Blade/Mesh/Elements along chord={chord}")
    folder = os.path.join(output, "run")
    command = [program, "run", "--force", os.path.join(TOP, "prm", "frontal.prm"), "--output", folder]
    for setting in settings:
        command += ["--set", setting]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{kind}, {mesh}: the run failed:\n{done.stdout[-1000:]}")
    with open(os.path.join(folder, "summary.json")) as file:
        s = json.load(file)
    return {"kind": kind, "mesh": mesh, "peak": s["tip"]["peak"], "peak_time": s["tip"]["peak_time"],
            "root_moment": s["root"]["peak_moment"], "plastic_work": s["plastic"]["work"],
            "energy_error": s["energy"]["max_relative_error"], "steps": s["steps"]["blade"],
            "cpu": round(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, 2)}


def read(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)


def n_elements(row):
    span, chord = row["mesh"].split("x")
    return int(span) * int(chord)


def add_errors(rows):
    """Adds error (%) to each row: relative to the fully integrated shell on its finest mesh, or the finest shell there is."""
    shells = [row for row in rows if row["kind"].startswith("shell")]
    finest = max(shells, key=lambda row: (n_elements(row), row["kind"] == "shell, full"), default=None)
    for row in rows:
        row["error"] = 100.0 * (float(row["peak"]) / float(finest["peak"]) - 1.0) if finest else float("nan")
    return finest


def draw(output, rows, finest):
    kinds = [kind for kind in KINDS if any(row["kind"] == kind for row in rows)]
    colors = ("#0060ad", "#00a0c0", "#808080", "#009e73", "#d55e00", "#e69f00", "#800080", "#cc79a7", "#000000")
    with open(os.path.join(output, "tip_peak.gp"), "w") as script:
        script.write("reset\nset terminal svg size 800,480 font 'DejaVu Sans,13' background rgb 'white'\nset output 'tip_peak.svg'\n"
                     "set logscale x\nset grid\nset key outside right\nset xlabel 'processor time to the tip peak, one core [s]'\n"
                     "set ylabel 'tip peak, difference [%]'\n"
                     f"set title 'frontal strike: tip peak, relative to {finest['kind']}, {finest['mesh']}' noenhanced\n")
        for number, kind in enumerate(kinds):
            script.write(f"$d{number} << EOD\n")
            for row in rows:
                if row["kind"] == kind:
                    script.write(f"{row['cpu']} {row['error']:.4f} {row['mesh']}\n")
            script.write("EOD\n")
        script.write("plot 0 linecolor 'black' notitle, " +
                     ", ".join(f"$d{i} using 1:2 with linespoints linewidth 1.5 linecolor '{colors[i]}' pointtype {i + 4} title '{kind}'"
                               for i, kind in enumerate(kinds)) + "\n")
    if shutil.which("gnuplot"):
        subprocess.run(["gnuplot", "--default-settings", "tip_peak.gp"], cwd=output, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--output", required=True, help="folder of the table and the chart")
    parser.add_argument("--kinds", nargs="+", default=list(KINDS), choices=list(KINDS), metavar="KIND", help=", ".join(KINDS))
    parser.add_argument("--meshes", nargs="+", default=list(MESHES), metavar="SPANxCHORD")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    path = os.path.join(arguments.output, "tip_peak.csv")
    rows = read(path)
    for kind in arguments.kinds:
        for mesh in arguments.meshes:
            if not any(row["kind"] == kind and row["mesh"] == mesh for row in rows):
                rows.append(run(arguments.program, arguments.output, kind, mesh))
                write(path, rows)
    finest = add_errors(rows)
    for row in rows:
        print(f"{row['kind']:<24} {row['mesh']:>7} {1e3 * float(row['peak']):8.2f} mm at {1e3 * float(row['peak_time']):6.2f} ms  "
              f"{float(row['root_moment']):6.1f} N m {float(row['plastic_work']):6.1f} J {int(row['steps']):8d} steps {float(row['cpu']):8.2f} s  "
              f"{row['error']:+7.2f} %")
    if finest:
        draw(arguments.output, rows, finest)
    return 0


if __name__ == "__main__":
    sys.exit(main())
