#!/usr/bin/env python3
"""Inputs drawn at random, each with an answer that is known beforehand: inputs.py PROGRAM [--seed 1] [--count 40]

mesh    a plate of quadrilaterals in Gmsh 2.2, LS-DYNA, Abaqus or VTK text, in any order of nodes and cells, turned and shifted, sound or
        with one defect. Sound ones have the mass rho L C t; defects are refused (exit code 2), or warned of where the blade may be meant.
deck    a sound LS-DYNA or Abaqus plate with keywords that say nothing of the blade (skipped) or that move, join or thicken its nodes
        (refused by name), with SPH elements of a bird (`Blade/Mesh/Parts`), or with its thickness on the elements.
column  a cantilever pressed along its span by a share of Euler's load pi^2 E I / 4 L^2: stable below it, unstable above.
study   a study that a signal stops at a random time (exit code 130, or done), and that the same command completes.

A row an input; exit code 1 if one is answered otherwise. The answer never comes from the program.
"""
import argparse
import json
import math
import os
import random
import signal
import subprocess
import sys
import tempfile
import time

DENSITY = 4430.0  # Ti-6Al-4V, kg/m^3


class Plate:
    """nx x ny quadrilaterals on length x chord, thickness t; ids in a random order with gaps."""

    def __init__(self, draw):
        self.nx, self.ny = draw.randint(4, 12), draw.randint(3, 7)
        self.length, self.chord, self.t = draw.uniform(0.1, 0.4), draw.uniform(0.05, 0.12), draw.uniform(2e-3, 5e-3)
        n = (self.nx + 1) * (self.ny + 1)
        ids = draw.sample(range(1, 3 * n), n)
        shift = [draw.uniform(-1, 1) for _ in range(3)]
        a = draw.uniform(-math.pi, math.pi)
        self.nodes, self.at = {}, {}
        for i in range(self.nx + 1):
            for j in range(self.ny + 1):
                x, y = self.length * i / self.nx, self.chord * (j / self.ny - 0.5)
                self.at[i, j] = ids.pop()
                self.nodes[self.at[i, j]] = [x * math.cos(a) - y * math.sin(a) + shift[0],
                                             x * math.sin(a) + y * math.cos(a) + shift[1], shift[2]]
        cells = []
        for i in range(self.nx):
            for j in range(self.ny):
                corners = [self.at[i, j], self.at[i + 1, j], self.at[i + 1, j + 1], self.at[i, j + 1]]
                k = draw.randrange(4)
                cells.append(corners[k:] + corners[:k])
        draw.shuffle(cells)
        self.cells = dict(zip(draw.sample(range(1, 3 * len(cells)), len(cells)), cells))
        self.root = [self.at[0, j] for j in range(self.ny + 1)]
        self.tip = [self.at[self.nx, j] for j in range(self.ny + 1)]

    def mass(self):
        return DENSITY * self.length * self.chord * self.t

    def new_node(self, place):
        self.nodes[max(self.nodes) + 1] = place
        return max(self.nodes)


def mean(*points):
    return [sum(c) / len(points) for c in zip(*points)]


# Defects. Each says what the answer holds: exit code and words of the message or warning.
def sound(plate, draw):
    return 0, []


def missing_node(plate, draw):
    cell = draw.choice(list(plate.cells))
    del plate.nodes[draw.choice(plate.cells[cell])]
    return 2, []


def doubled_cell(plate, draw):
    cell = draw.choice(list(plate.cells))
    plate.cells[max(plate.cells) + 1] = list(plate.cells[cell])
    return 2, ["same nodes"]


def folded_cell(plate, draw):
    cell = plate.cells[draw.choice(list(plate.cells))]
    cell[1], cell[2] = cell[2], cell[1]
    return 2, []


def no_number(plate, draw):
    plate.nodes[draw.choice(list(plate.nodes))][draw.randrange(3)] = float("nan")
    return 2, []


def hanging_node(plate, draw):
    """A cell inside is split in two across one of its sides, whose neighbour keeps it whole."""
    i, j = draw.randrange(1, plate.nx - 1), draw.randrange(1, plate.ny - 1)
    a, b, c, d = (plate.at[i, j], plate.at[i + 1, j], plate.at[i + 1, j + 1], plate.at[i, j + 1])
    cell = next(k for k, v in plate.cells.items() if sorted(v) == sorted([a, b, c, d]))
    lower, upper = (plate.new_node(mean(plate.nodes[p], plate.nodes[q])) for p, q in ((a, b), (d, c)))
    del plate.cells[cell]
    first = max(plate.cells) + 1
    plate.cells[first], plate.cells[first + 1] = [a, lower, upper, d], [lower, b, c, upper]
    return 2, [str(lower), "node"]


def near_seam(plate, draw):
    """Two neighbouring columns of cells have nodes of their own, apart by at most a thousandth of a cell; its first edge is joined."""
    i, gap = draw.randrange(1, plate.nx), draw.choice([0.0, 1e-9, 1e-6, 1e-5]) * draw.uniform(0.5, 1.0)
    copies = {}
    for j in range(2, plate.ny + 1):
        x = plate.nodes[plate.at[i, j]]
        copies[plate.at[i, j]] = plate.new_node([x[0] + gap, x[1], x[2]])
    right = {plate.at[k, j] for k in range(i + 1, plate.nx + 1) for j in range(plate.ny + 1)}
    for cell in plate.cells.values():
        if right & set(cell):
            cell[:] = [copies.get(n, n) for n in cell]
    return 0, ["not joined"]


DEFECTS = [sound, sound, missing_node, doubled_cell, folded_cell, no_number, hanging_node, near_seam]


# Formats, by the name of the file.
def write_msh(plate, name):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3", '1 1 "root"', '1 2 "tip"', '2 3 "blade"',
             "$EndPhysicalNames", "$Nodes", str(len(plate.nodes))]
    lines += [f"{n} {x[0]!r} {x[1]!r} {x[2]!r}" for n, x in plate.nodes.items()]
    elements = [f"1 2 {k} {k} {side[j]} {side[j + 1]}" for k, side in ((1, plate.root), (2, plate.tip)) for j in range(len(side) - 1)]
    last = max(plate.cells)
    lines += ["$EndNodes", "$Elements", str(len(elements) + len(plate.cells))]
    lines += [f"{last + k + 1} {e}" for k, e in enumerate(elements)]
    lines += [f"{c} 3 2 3 3 " + " ".join(map(str, v)) for c, v in plate.cells.items()] + ["$EndElements", ""]
    open(name, "w", encoding="ascii").write("\n".join(lines))


def k_lines(plate, card="*ELEMENT_SHELL", extra=lambda: []):
    lines = ["*KEYWORD", "*PART", "blade", f"{1:10d}{1:10d}{1:10d}", "*NODE"]
    lines += [f"{n:8d}" + "".join(f"{v:16.9e}" for v in x) for n, x in plate.nodes.items()]
    lines += [card]
    for c, v in plate.cells.items():
        lines += ["".join(f"{k:8d}" for k in [c, 1] + v)] + extra()
    for k, (title, side) in enumerate((("root", plate.root), ("tip", plate.tip))):
        lines += ["*SET_NODE_LIST_TITLE", title, f"{k + 1:10d}"]
        lines += ["".join(f"{n:10d}" for n in side[m:m + 8]) for m in range(0, len(side), 8)]
    return lines


def write_k(plate, name):
    open(name, "w", encoding="ascii").write("\n".join(k_lines(plate) + ["*END", ""]))


def inp_lines(plate):
    lines = ["*HEADING", "*NODE"] + [f"{n}, {x[0]!r}, {x[1]!r}, {x[2]!r}" for n, x in plate.nodes.items()]
    lines += ["*ELEMENT, TYPE=S4R, ELSET=blade"] + [f"{c}, " + ", ".join(map(str, v)) for c, v in plate.cells.items()]
    for title, side in (("root", plate.root), ("tip", plate.tip)):
        lines += [f"*NSET, NSET={title}"] + [", ".join(map(str, side[m:m + 10])) + "," for m in range(0, len(side), 10)]
    return lines


def write_inp(plate, name):
    open(name, "w", encoding="ascii").write("\n".join(inp_lines(plate) + [""]))


WRITERS = {"plate.msh": write_msh, "plate.k": write_k, "plate.inp": write_inp}

CASE = """subsection Blade
  subsection Mesh
    set Generator = file
    set File = {file}
  end
  subsection Thickness
    set Value = {t!r}
  end
  subsection Supports
    set Clamped = root
    set Tip = tip
  end
  subsection Material
    set Name = Ti-6Al-4V
    set Hardening = perfect
  end
end
subsection Bird
  set Enabled = false
end
subsection Time
  set End time = 1e-5
end
"""


class Trial:
    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), folder

    def run(self, *words):
        done = subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, timeout=300)
        return done.returncode, done.stdout + done.stderr

    def write_case(self, file, t):
        with open(os.path.join(self.folder, "case.prm"), "w", encoding="ascii") as out:
            out.write(CASE.format(file=file, t=t))

    def judge(self, wanted, words, mass=None, arguments=()):
        code, said = self.run("explain", "case.prm", *arguments)
        faults = [] if code == wanted else [f"exit code {code}, expected {wanted}"]
        faults += [f"'{w}' is not said" for w in words if w.lower() not in said.lower()]
        if code == 0 and mass is not None:
            row = next((line for line in said.splitlines() if line.strip().startswith("mass")), "mass 0 kg")
            value, unit = float(row.split()[1]), row.split()[2]
            value *= {"kg": 1.0, "g": 1e-3}[unit]
            if abs(value / mass - 1.0) > 2e-3:
                faults.append(f"mass {value:.6g} instead of {mass:.6g} kg")
        return faults, said


def draw_mesh(trial, draw):
    plate = Plate(draw)
    defect, name = draw.choice(DEFECTS), draw.choice(list(WRITERS))
    mass = plate.mass()
    wanted, words = defect(plate, draw)
    WRITERS[name](plate, os.path.join(trial.folder, name))
    trial.write_case(name, plate.t)
    return f"{defect.__name__} {name}", *trial.judge(wanted, words, mass)


# Keywords and whether they may be skipped; what may not is refused by its name.
KEYWORDS_K = [("*CONTROL_TERMINATION\n     0.001", True), ("*DATABASE_GLSTAT\n    1.0E-5", True), ("*MAT_RIGID\n         7  7.8E-09", True),
              ("*DEFINE_CURVE\n         1\n                 0.0                 1.0", True),
              ("*BOUNDARY_SPC_SET\n         1         0         1         1         1", True), ("*TITLE\nsomebody's blade", True),
              ("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n         1         2", True),
              ("*PART_MOVE\n         1       0.1", False), ("*NODE_TRANSFORM\n         1         1", False),
              ("*NODE_MERGE_SET\n         1", False), ("*PERTURBATION_NODE\n         1         0", False),
              ("*CONSTRAINED_ADAPTIVITY\n         1         2         3", False)]
KEYWORDS_INP = [("*MATERIAL, NAME=TI\n*ELASTIC\n113.8E9, 0.342", True), ("*BOUNDARY\nroot, 1, 6", True),
                ("*AMPLITUDE, NAME=A\n0., 0., 1., 1.", True), ("*STEP\n*STATIC\n*END STEP", True),
                ("*IMPERFECTION, SYSTEM=R\n1, 0., 0., 0.02", False), ("*NODAL THICKNESS\nroot, 0.01", False)]


def draw_deck(trial, draw):
    plate = Plate(draw)
    kind = draw.choice(["keyword of .k", "keyword of .inp", "bird of SPH", "thickness of elements"])
    if kind == "keyword of .inp":
        text, may_skip = draw.choice(KEYWORDS_INP)
        name, lines = "plate.inp", inp_lines(plate) + [text]
    elif kind == "keyword of .k":
        text, may_skip = draw.choice(KEYWORDS_K)
        name, lines = "plate.k", k_lines(plate) + [text, "*END"]
    elif kind == "bird of SPH":
        text, may_skip, name = "Parts", draw.random() < 0.5, "plate.k"
        first = max(plate.nodes) + 1
        lines = k_lines(plate) + ["*PART", "bird", f"{2:10d}{2:10d}{2:10d}", "*NODE"]
        lines += [f"{first + n:8d}" + f"{0.01 * n:16.9e}" * 3 for n in range(5)]
        lines += ["*ELEMENT_SPH"] + [f"{first + n:8d}{2:8d}{1e-4:16.9e}" for n in range(5)] + ["*END"]
    else:
        card = draw.choice(["_THICKNESS", "_BETA", "_MCID"])
        text, may_skip, name = card, True, "plate.k"
        lines = k_lines(plate, "*ELEMENT_SHELL" + card, lambda: ["".join(f"{plate.t:16.9e}" for _ in range(4))]) + ["*END"]
    open(os.path.join(trial.folder, name), "w", encoding="ascii").write("\n".join(lines) + "\n")
    mass = plate.mass()
    trial.write_case(name, plate.t if kind != "thickness of elements" else 0.0123)
    arguments = ("--set", "Blade/Mesh/Parts=blade") if kind == "bird of SPH" and may_skip else ()
    word = text.split("\n")[0].split(",")[0]
    return f"{kind} {word}", *trial.judge(0 if may_skip else 2, [] if may_skip else [word], mass, arguments)


def draw_column(trial, draw):
    length, width, t, young = draw.uniform(0.2, 0.4), draw.uniform(0.015, 0.03), draw.uniform(1.5e-3, 3e-3), draw.uniform(50e9, 200e9)
    share = draw.choice([draw.uniform(0.5, 0.985), draw.uniform(1.015, 2.0)])
    force = -share * math.pi ** 2 * young * width * t ** 3 / 12.0 / (4.0 * length ** 2)
    half = width / 2.0
    loads = "|".join(f"{length!r} {y!r} 0: {force * part!r}; 0; 0" for y, part in ((-half, 0.25), (0.0, 0.5), (half, 0.25)))
    sets = [f"Blade/Material/{k}={v}" for k, v in (("Name", "custom"), ("Density", 2700), ("Young's modulus", young),
                                                  ("Poisson's ratio", 0), ("Hardening", "elastic"))]
    sets += [f"Blade/Mesh/{k}={v}" for k, v in (("Length", length), ("Chord", width), ("Elements along span", 40),
                                              ("Elements along chord", 2))]
    sets += [f"Blade/Thickness/Value={t!r}", f"Blade/Loads/Point loads={loads}", "Bird/Enabled=false"]
    open(os.path.join(trial.folder, "column.prm"), "w", encoding="ascii").write("subsection Time\n  set Threads = 1\nend\n")
    code, said = trial.run("static", "column.prm", "--output", "out", *[w for s in sets for w in ("--set", s)])
    faults = [] if code == 0 else [f"exit code {code}"]
    if code == 0:
        stability = json.load(open(os.path.join(trial.folder, "out", "static.json"), encoding="utf-8"))["stability"]
        if stability["is_stable"] != (share < 1.0):
            faults.append(f"stable: {stability['is_stable']}")
        if (share > 1.0) != ("unstable" in said):
            faults.append("the warning is missing, or false")
    return f"{share:.3f} of Euler's load", faults, said


def draw_study(trial, draw):
    top = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    words = [trial.program, "study", os.path.join(top, "prm", "quickstart.prm"), "--output", "study", "--jobs", "1",
             "--set", "Bird/Particle spacing=8 mm", "--set", "Time/End time=0.3 ms", "--set", "Blade/Mesh/Elements along span=14",
             "--set", "Blade/Mesh/Elements along chord=4", "--vary", "Bird/Speed=100, 140, 180", "--set", "Bird/Velocity=default",
             "--set", "Bird/Angle to surface=90"]
    wait = draw.uniform(0.0, 2.0)
    process = subprocess.Popen(words, cwd=trial.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    while not os.path.exists(os.path.join(trial.folder, "study")) and process.poll() is None:
        time.sleep(0.01)  # the loader is at work
    time.sleep(wait)
    process.send_signal(draw.choice([signal.SIGTERM, signal.SIGINT, signal.SIGHUP]))
    said = process.communicate(timeout=300)[0]
    faults = [] if process.returncode in (0, 130) else [f"exit code {process.returncode} of a stopped study"]
    done = subprocess.run(words, cwd=trial.folder, capture_output=True, text=True, timeout=600)
    table = os.path.join(trial.folder, "study", "study.csv")
    if done.returncode != 0:
        faults.append(f"exit code {done.returncode} of the same command again")
    elif sum("done" in row for row in open(table, encoding="utf-8")) != 3:
        faults.append("not three points in the table")
    return f"stopped after {wait:.2f} s", faults, said + done.stdout + done.stderr


KINDS = {"mesh": (draw_mesh, 10), "deck": (draw_deck, 6), "column": (draw_column, 3), "study": (draw_study, 1)}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=40)
    options.add_argument("--only", nargs="*", choices=KINDS, default=list(KINDS))
    given = options.parse_args()
    n_failed = 0
    for seed in range(given.seed, given.seed + given.count):
        draw = random.Random(seed)
        kind = draw.choices(given.only, [KINDS[k][1] for k in given.only])[0]
        with tempfile.TemporaryDirectory() as folder:
            what, faults, said = KINDS[kind][0](Trial(given.program, folder), draw)
        print(f"{seed} {kind}: {what}: {'; '.join(faults) if faults else 'as expected'}", flush=True)
        if faults:
            n_failed += 1
            print("\n".join("    " + line for line in said.splitlines()[-12:]))
    print(f"{given.count - n_failed} of {given.count} as expected")
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main())
