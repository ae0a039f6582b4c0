#!/usr/bin/env python3
"""Error against processor time of every choice of method: is the default on the front?

    bash tests/studies/work_precision.sh                  # all of it, into build/work_precision
    bash tests/studies/work_precision.sh packing kernel   # these groups
    bash tests/studies/work_precision.sh --spacing 2.5    # of groups that refine the bird this level alone

Four strikes (strikes_measured.py): frontal.prm to the tip's first peak; oblique.prm (leading edge) until the bird has gone by, 0.9 ms; the
frontal strike until the blade has come to rest about its permanent deflection; the bird on a rigid plate. A group of choices
changes one thing of the shipped cases and climbs a ladder: of particle spacings, of meshes, or both. One thread; seconds are the
processor's. Errors are differences from a reference that is finer than any point of the group: the shipped choice at 1.25 mm on the
shipped mesh where the bird is refined; 124 x 36 elements where the mesh is, with 15 points through the thickness; 1.5 mm on these where both
are; on the rigid plate Hugoniot's and the stagnation pressure. "Worst" is the largest error over what is aimed at
(AIMS): at 1 every figure is as good as asked.

Writes runs.csv (a line a run, in SI units; what stands there is not run again: delete it after a change of the program),
work_precision.md (tables) and, with gnuplot, a chart a group (GROUP.svg).
"""

import argparse
import csv
import math
import os
import shutil
import subprocess
import sys

import strikes_measured

# Largest error that a decision bears, in percent.
AIMS = {("frontal", "tip peak"): 0.5, ("frontal", "impulse"): 2, ("frontal", "impulse history"): 2, ("frontal", "root moment"): 2,
        ("frontal", "plastic work"): 3, ("to rest", "permanent deflection"): 2, ("leading edge", "impulse"): 2,
        ("leading edge", "plastic work"): 5, ("rigid plate", "Hugoniot pressure"): 10, ("rigid plate", "stagnation pressure"): 5}

SPACINGS = ("5", "4", "3", "2.5", "2")  # mm
MESHES = ("16x5", "31x9", "62x18")
BIRD_REFERENCE, MESH_REFERENCE = ("1.25", "62x18"), ("1.5", "124x36")
MANY_POINTS = ("Blade/Element/Points through thickness=15",)


def blade(kind, layers=1):
    solid = ("Blade/Kind=solid", f"Blade/Mesh/Layers={layers}") if layers else ()
    return solid + (f"Blade/Element/Formulation={kind}",)


def entry(name, *values):
    return {value: (f"{name}={value}",) for value in values}


# Group: what it is about, what it refines, its choices; the first choice is the shipped one.
GROUPS = {
    "formulation": ("particle formulation", "spacing", {
        "riemann": (), "standard": ("Bird/Formulation=standard",),
        "standard, summation": ("Bird/Formulation=standard", "Bird/Density by=summation")}),
    "reconstruction": ("reconstruction at the mid-point of a pair, gradient correction", "spacing", {
        "none": (), "linear": ("Bird/Reconstruction=linear",), "none, uncorrected": ("Bird/Gradient correction=false",),
        "corrected at every step": ("Bird/Correction interval=1",)}),
    "precision": ("precision of pairs", "spacing", {"float": (), "double": ("Bird/Pair precision=double",)}),
    "kernel": ("kernel of the standard formulation", "spacing", {
        "riemann, wendland": (), **{f"standard, {kernel}": ("Bird/Formulation=standard", f"Bird/Kernel={kernel}")
                                    for kernel in ("cubic spline", "wendland")}}),
    "smoothing": ("smoothing length over spacing", "spacing",
                  {"1.3": (), **entry("Bird/Smoothing length ratio", "1.1", "1.2", "1.5", "1.7")}),
    "packing": ("packing", "spacing", {"cubic": (), "fcc": ("Bird/Packing=fcc",)}),
    "courant": ("Courant number of the bird", "spacing", {"0.35": (), **entry("Bird/Courant number", "0.2", "0.28", "0.42", "0.5")}),
    "multirate": ("largest ratio of the two steps", "spacing", {
        "50": (), "1": ("Time/Multirate=false",), **entry("Time/Maximum ratio", "2", "5", "10")}),
    "contact": ("contact: scale of spring and damper", "spacing", {
        "1, 1": (), **{f"{k}, {c}": (f"Contact/Stiffness scale={k}", f"Contact/Damping scale={c}")
                       for k, c in (("0.3", "1"), ("3", "1"), ("1", "0.3"), ("1", "3"))}}),
    "points": ("points through the thickness", "mesh", {
        "7 Gauss": (), **{f"{n} {rule}": (f"Blade/Element/Points through thickness={n}", f"Blade/Element/Points rule={rule}")
                          for n, rule in ((3, "Gauss"), (5, "Gauss"), (11, "Gauss"), (5, "Lobatto"), (7, "Lobatto"))}}),
    "elements": ("elements", "mesh", {
        "physical shell": (), "Belytschko-Tsay shell": blade("Belytschko-Tsay", 0), "fully integrated shell": blade("fully integrated", 0),
        "1 solid-shell": blade("solid-shell"), "2 one-point bricks": blade("one point", 2), "4 one-point bricks": blade("one point", 4)}),
    "bird-and-mesh": ("particles and mesh together", "both", {
        "uniform": (), "graded 3": ("Blade/Mesh/Span grading=3",)}),
}


class Runs:
    """The table of runs, kept in a file: SPACING and MESH are levels, SETTINGS what differs from the shipped case."""

    FIELDS = ("strike", "spacing", "mesh", "settings", "state", "cpu", *dict.fromkeys(quantity for _, quantity in AIMS))

    def __init__(self, program, folder):
        self.program, self.folder, self.path = program, folder, os.path.join(folder, "runs.csv")
        self.rows = []
        if os.path.exists(self.path):
            with open(self.path, newline="") as file:
                self.rows = list(csv.DictReader(file))

    def find(self, strike, level, settings):
        key = (strike, *level, "; ".join(settings))
        for row in self.rows:
            if (row["strike"], row["spacing"], row["mesh"], row["settings"]) == key:
                return row
        row = dict(zip(self.FIELDS, key), **strikes_measured.measure(self.program, self.folder, strike, level, settings))
        self.rows.append(row)
        with open(self.path, "w", newline="") as file:
            writer = csv.DictWriter(file, self.FIELDS)
            writer.writeheader()
            writer.writerows(self.rows)
        return row


def levels(refines, spacings):
    return {"spacing": [(spacing, "62x18") for spacing in spacings], "mesh": [("2.5", mesh) for mesh in MESHES],
            "both": [(spacing, mesh) for mesh in MESHES for spacing in SPACINGS]}[refines]


def reference_level(refines):
    return {"spacing": BIRD_REFERENCE, "mesh": ("2.5", "124x36"), "both": MESH_REFERENCE}[refines]


def error(quantity, row, reference):
    """In percent of the reference; NaN where a run was lost."""
    if row["state"] != "done":
        return math.nan
    if quantity == "impulse history":  # largest difference over the impulse at the end
        one, two = ([float(text) for text in which[quantity].split()] for which in (row, reference))
        return 100 * max(abs(a - b) for a, b in zip(one, two)) / two[-1]
    return 100 * (float(row[quantity]) / float(reference[quantity]) - 1)


def strikes_of(refines):
    """A rigid plate has no mesh to refine."""
    return [strike for strike in dict.fromkeys(of for of, _ in AIMS) if strike != "rigid plate" or refines == "spacing"]


def level_for(strike, refines, level):
    return (level[0], strikes_measured.COARSE) if strike == "to rest" and refines == "spacing" else level


def collect(runs, name, spacings):
    """A line a point: choice, level, processor time and errors by (strike, quantity), worst error over its aim."""
    _, refines, choices = GROUPS[name]
    points, strikes = [], strikes_of(refines)
    references = {strike: strikes_measured.EXACT.get(strike) or
                  runs.find(strike, level_for(strike, refines, reference_level(refines)), () if refines == "spacing" else MANY_POINTS) for strike in strikes}
    for choice, settings in choices.items():
        for level in levels(refines, spacings):
            point = {"choice": choice, "spacing": level[0], "mesh": level[1], "cpu": {}}
            for strike in strikes:
                row = runs.find(strike, level_for(strike, refines, level), settings)
                point["cpu"][strike] = float(row["cpu"])
                for aim in AIMS:
                    if aim[0] == strike:
                        point[aim] = error(aim[1], row, references[strike])
                point[strike, "worst"] = max((abs(point[aim]) / AIMS[aim] for aim in AIMS if aim[0] == strike), key=lambda e: (math.isnan(e), e))
            points.append(point)
    return points


def as_markdown(name, points):
    about, refines, _ = GROUPS[name]
    head = ["choice", "spacing, mm", "mesh"]
    for strike in strikes_of(refines):
        head += [f"{strike}: time, s", *(f"{quantity}, %" for of, quantity in AIMS if of == strike), "worst over aim"]
    lines = [f"## {about.capitalize()}", "", "| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for point in points:
        cells = [point["choice"], point["spacing"], point["mesh"]]
        for strike in strikes_of(refines):
            cells += [f"{point['cpu'][strike]:.2f}", *(f"{point[aim]:+.2f}" for aim in AIMS if aim[0] == strike), f"{point[strike, 'worst']:.2f}"]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")  # Okabe and Ito (2008)
SMALLEST = 0.01  # percent: less is drawn there


def draw(folder, name, points):
    about, refines, choices = GROUPS[name]
    lines = [(choice, [p for p in points if p["choice"] == choice]) for choice in choices]
    if refines == "both":  # a line a mesh and choice
        lines = [(f"{mesh}, {choice}", [p for p in points if p["mesh"] == mesh and p["choice"] == choice]) for choice in choices for mesh in MESHES]
    aims = [aim for aim in AIMS if aim[0] in strikes_of(refines)]
    rows = -(-len(aims) // 4)
    high = 1. / (rows + 0.44)  # of a row of panels, in shares of the picture
    script = [f"reset\nset terminal svg size 1500,{250 * rows + 110} font 'DejaVu Sans,13' background rgb 'white'\nset output '{name}.svg'\n"
              "set logscale xy\nset grid lc rgb '#d0d0d0'\nset format y '%g'\nset xlabel 'processor time, one core [s]'\nset ylabel '|error| [%]'\n"
              f"set title noenhanced\nunset key\nset multiplot title 'Error against run time: {about}'\n"]
    styles = [f"with linespoints linewidth 1.5 linecolor '{COLORS[k]}' pointtype {k + 4}" for k in range(len(lines))]
    aim_style = "with lines dashtype 3 linecolor '#404040'"
    for number, aim in enumerate(aims):
        left, top = 0.05 + 0.245 * (number % 4), 1. - 0.3 * high - high * (number // 4)
        script.append(f"set title '{aim[0]}: {aim[1]}'\nset lmargin at screen {left}\nset rmargin at screen {left + 0.18}\n"
                      f"set tmargin at screen {top}\nset bmargin at screen {top - 0.6 * high}\n")
        plots = [f"{AIMS[aim]} {aim_style}"]
        for k, (_, of) in enumerate(lines):
            script.append(f"$d{number}_{k} << EOD\n" + "".join(
                f"{p['cpu'][aim[0]]} {max(abs(p[aim]), SMALLEST)}\n" for p in of if not math.isnan(p[aim])) + "EOD\n")
            if any(not math.isnan(p[aim]) for p in of):
                plots.append(f"$d{number}_{k} using 1:2 {styles[k]}")
        script.append("plot " + ", ".join(plots) + "\n")
    script.append(f"set lmargin at screen 0.03\nset rmargin at screen 0.97\nset tmargin at screen {0.2 * high}\nset bmargin at screen 0.01\n"
                  "unset logscale\nunset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset title\nset xrange [0:1]\nset yrange [0:1]\n"
                  "set key center center horizontal noenhanced\nplot " +
                  ", ".join([f"-1 {aim_style} title 'aim'"] + [f"-1 {style} title '{title}'" for style, (title, _) in zip(styles, lines)]) + "\n")
    with open(os.path.join(folder, name + ".gp"), "w") as file:
        file.write("".join(script) + "unset multiplot\n")
    if shutil.which("gnuplot"):
        subprocess.run(["gnuplot", "--default-settings", name + ".gp"], cwd=folder, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--output", required=True, help="folder of tables and charts")
    parser.add_argument("--only", nargs="+", default=list(GROUPS), choices=list(GROUPS), metavar="GROUP", help=", ".join(GROUPS))
    parser.add_argument("--spacing", nargs="+", default=SPACINGS, choices=SPACINGS, metavar="MM", help="of " + ", ".join(SPACINGS))
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    runs = Runs(arguments.program, arguments.output)
    with open(os.path.join(arguments.output, "work_precision.md"), "w") as tables:
        for name in arguments.only:
            points = collect(runs, name, arguments.spacing)
            tables.write(as_markdown(name, points) + "\n")
            tables.flush()
            draw(arguments.output, name, points)
            print(as_markdown(name, points), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
