#!/usr/bin/env python3
"""The headline figures of every shipped strike on a blade, in shells and in bricks, with their error bars.

    bash tests/studies/error_bars.sh                         # all, into build/error_bars; hours on one core
    bash tests/studies/error_bars.sh fan-row sheath:solid    # these alone

Of each case `birdstrike converge` climbs three ladders, one thread a run: particles (levels 1.2 apart, PARTICLES: far coarser ones are
not in the asymptotic range where an edge cuts the bird), mesh (five 1.3 apart along span and chord, three of them finer, four of fan-row; five
1.2 apart of thick blades: MESHES; three 1.5 apart cannot tell an order from scatter), time steps (four 1.5 apart, from the case's on). A cell is what
the finest level adds to the case's own, and half the error bar of the finest level, both in percent of the value as shipped; "in x" instead
of a bar where the ladder gives none: all that the three finest levels are apart. A plus behind a value: still rising at the end, no peak.
Where an edge cuts the bird each level of particles and of the mesh is the mean over four offsets of the lattice (`--places`): "offsets" is
what that mean adds to the run as shipped, and the standard deviation of one run, of the mesh's ladder.
The last columns are what h -> 0 adds by fits of orders from 1 to 2, with what the 95 % confidence intervals of those span that the levels
do not reject (`converge --order 1:2`); "no order" where they reject them all. Where particles resolve a thick edge (RESOLVED),
the limit is that of the finest levels alone.

Writes a folder a ladder, whose runs are reused by the next call, and of all ladders that are there error_bars.md (a line a quantity) and
summary.md (a line a case: what the finest levels add).
"""

import argparse
import csv
import math
import os
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

CASES = {"frontal": "shell solid", "oblique": "shell solid", "perforation": "shell solid", "sheath": "shell solid",
         "fan-blade": "shell solid", "fan-blade-spin": "shell solid", "fan-row": "shell solid", "fan-blade-composite": "shell",
         "certification/large-bird": "shell", "certification/medium-bird": "shell", "certification/flock": "shell"}

# Levels of the particles, and how many of them are coarser than the case: more where an edge cuts the bird.
PARTICLES = {"oblique": (8, 1), "sheath": (6, 0), "fan-row": (6, 1)}
PARTICLES_OF_KIND = {("oblique", "solid"): (7, 1), ("fan-row", "shell"): (7, 0)}
# Where the edge that the bird meets is so thick that particles resolve it (5 mm of fan-row and of the composite), ladders bend on the
# way there and the limit is that of so many finest levels: those below 0.6 of the thickness.
RESOLVED = {("fan-row", "shell"): 6, ("fan-blade-composite", "shell"): 7}
PLACES = 4  # of the lattice, where an edge cuts the bird
LADDERS = ("particles", "mesh", "step")
# The same of the mesh. Where the blade is thick, a third of the shells would be thicker than twice their sides at 2.2 times finer; their levels
# are 1.2 apart from 1.2 times coarser on, for still coarser ones turn away (tip of fan-blade, 1.3 apart: 151.3, 149.2, 147.4, 147.9, 148.3 mm),
# as those of fan-row do on a coarser mesh than its own: 3 % off in the tip's peak, where finer ones change 1 %.
FAN_BLADES = ("fan-blade", "fan-blade-spin", "fan-blade-composite", "certification/large-bird", "certification/medium-bird", "certification/flock")
OTHER_PARTICLES = {case: (7, 2) for case in FAN_BLADES} | {"fan-blade-composite": (9, 0)}  # five of fan-blade-spin have changes that grow
MESHES = {case: (5, 1) for case in FAN_BLADES} | {"fan-row": (5, 0)}
OTHER_MESHES = (5, 1)
FITTED = ("particles", "mesh")  # of four levels and more
ORDERS, SIGNIFICANCE = "1:2", 0.05

QUANTITIES = {"Tip: peak (mid-chord)": ("tip peak", "mm", 1e3), "Tip: permanent deflection": ("permanent deflection", "mm", 1e3),
              "Root: peak bending moment": ("root moment", "N m", 1.), "Plasticity: plastic work": ("plastic work", "J", 1.),
              "Contact: impulse (norm)": ("impulse", "N s", 1.)}

QUIET = ("Time/Threads=1", "Output/Blade fields=false", "Output/Bird fields=false", "Output/Checkpoint/At the end=false")


def read_rows(path):
    """By quantity."""
    with open(path, newline="") as file:
        return {row["quantity"]: row for row in csv.DictReader(file)}


class Ladder:
    """converge.csv of a case: by quantity its values from the coarsest on, and the rest of its row; of levels.csv the run as shipped."""

    def __init__(self, folder, level, of_limit):
        self.level = level  # of the case
        self.rows = read_rows(os.path.join(folder, "converge.csv"))
        self.rows_of_limit = read_rows(os.path.join(folder, of_limit))
        self.places = int(next(iter(self.rows.values()))["places"])
        with open(os.path.join(folder, "levels.csv"), newline="") as file:
            self.run = list(csv.DictReader(file))[level * self.places]

    def values(self, quantity):
        """None where a level has none."""
        found = [text for key, text in self.rows.get(quantity, {}).items() if key.startswith("at h = ")]
        return [float(text) for text in found] if found and all(found) else None

    def finest_size(self):
        """Of the particles, m."""
        row = next(iter(self.rows.values()))
        return min(float(key.split()[3]) for key in row if key.startswith("at h = "))

    def at_case(self, quantity):
        """Of the case's level."""
        values = self.values(quantity)
        return values and values[self.level]

    def shipped(self, quantity):
        """Of the run as shipped; None where it has none."""
        found = [text for key, text in self.run.items() if key.startswith(quantity + " [") and text]
        return float(found[0]) if found else None

    def rises(self, quantity):
        return self.rows.get(quantity, {}).get("still rising") == "yes"

    def cell(self, quantity):
        values = self.values(quantity)
        if not values or not self.shipped(quantity):
            return "–"
        scale = 100. / abs(self.shipped(quantity))
        added = f"{scale * (values[-1] - self.at_case(quantity)):+.1f}"
        bar = self.rows[quantity]["error bar"]
        spread = max(values[-3:]) - min(values[-3:])
        return f"{added} ± {scale * float(bar):.1f}" if bar else f"{added} in {scale * spread:.1f}"

    def places_cell(self, quantity):
        if self.places == 1 or not self.values(quantity) or not self.shipped(quantity):
            return "–"
        scale = 100. / abs(self.shipped(quantity))
        scatter = float(self.rows[quantity]["standard deviation of a run"])
        return f"{scale * (self.at_case(quantity) - self.shipped(quantity)):+.1f} ± {scale * scatter:.1f}"


def levels_of(case, kind, name):
    """How many, and how many of them are coarser than the case."""
    if name == "particles":
        return PARTICLES_OF_KIND.get((case, kind)) or PARTICLES.get(case) or OTHER_PARTICLES.get(case, (5, 2))
    return MESHES.get(case, OTHER_MESHES)


def ladder_of(case, kind, name, finest=None):
    """Arguments of converge, for as many levels as wanted from the finest on."""
    if name == "step":
        return ("--levels", "4")
    n_levels, coarser = levels_of(case, kind, name)
    ratio = "1.2" if name == "particles" or case in FAN_BLADES else "1.3"
    levels = ("--levels", str(finest or n_levels), "--finer", str(n_levels - 1 - coarser), "--ratio", ratio)
    return levels + (("--places", str(PLACES)) if case in PARTICLES else ()) + ("--order", ORDERS)


def level_of_case(case, kind, name):
    """From the coarsest on."""
    return 0 if name == "step" else levels_of(case, kind, name)[1]


def is_resolved(case, kind, name):
    """Whether the limit is that of some finest levels alone."""
    return name == "particles" and (case, kind) in RESOLVED


def folder_of(folder, case, kind, name):
    return os.path.join(folder, case.replace("/", "-") + "-" + kind, name)


def read(folder, case, kind, name):
    """None where there is none."""
    of_ladder = folder_of(folder, case, kind, name)
    of_limit = "resolved.csv" if is_resolved(case, kind, name) else "converge.csv"
    is_there = all(os.path.exists(os.path.join(of_ladder, table)) for table in ("converge.csv", of_limit))
    return Ladder(of_ladder, level_of_case(case, kind, name), of_limit) if is_there else None


def converge(program, folder, case, kind, name, extra):
    """The ladder with what else is asked; None where it was refused."""
    output = folder_of(folder, case, kind, name)

    def climb(finest=None):
        command = [program, "converge", os.path.join(TOP, "prm", case + ".prm"), "--vary", name, *ladder_of(case, kind, name, finest),
                   "--jobs", "1", "--output", output, *extra]
        for setting in (f"Blade/Kind={kind}", *QUIET):
            command += ["--set", setting]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            print(f"{case}, {kind}, {name}: exit code {done.returncode}\n{done.stdout[-600:]}", file=sys.stderr)
        return done.returncode in (0, 3)  # 3: levels were lost, and its table says so

    if is_resolved(case, kind, name) and climb(RESOLVED[case, kind]):
        os.replace(os.path.join(output, "converge.csv"), os.path.join(output, "resolved.csv"))
    return read(folder, case, kind, name) if climb() else None


def limit_cell(ladder, quantity):
    """What h -> 0 adds to the case's level by the fits with orders between ORDERS; none where changes grow or they are rejected."""
    row = ladder and ladder.rows_of_limit.get(quantity)
    if not row or not row["extrapolated by known order"] or not ladder.shipped(quantity) or row["ladder"] == "diverges":
        return "–"
    if float(row["p-value of known order [-]"]) < SIGNIFICANCE:
        return "no order"
    scale = 100. / abs(ladder.shipped(quantity))
    return (f"{scale * (float(row['extrapolated by known order']) - ladder.at_case(quantity)):+.1f} ± "
            f"{scale * float(row['half of its 95 % interval']):.1f}")


def show(value, factor):
    return f"{value * factor:.{max(0, 4 - math.ceil(math.log10(abs(value * factor) + 1e-30)))}f}"


def value_of(quantity, ladders):
    """As shipped, with a plus where it still rises; None where the case has none."""
    factor = QUANTITIES[quantity][2]
    of_it = [ladder for ladder in ladders.values() if ladder and ladder.values(quantity)]
    if not of_it or abs(of_it[0].shipped(quantity)) * factor < 1e-6:
        return None
    return show(of_it[0].shipped(quantity), factor) + ("+" if any(ladder.rises(quantity) for ladder in of_it) else "")


def lines_of(case, kind, ladders):
    """A line a quantity: value as shipped, a cell a ladder, and the limits."""
    for quantity, (name, unit, _) in QUANTITIES.items():
        value = value_of(quantity, ladders)
        if value is None:
            continue
        cells = [ladders["mesh"].places_cell(quantity) if ladders["mesh"] else "–"]
        cells += [ladder.cell(quantity) if ladder else "lost" for ladder in ladders.values()]
        cells += [limit_cell(ladders[name], quantity) for name in FITTED]
        yield f"| {case}, {kind} | {name} {value} {unit} | {' | '.join(cells)} |"


SUMMARY = ("Tip: peak (mid-chord)", "Root: peak bending moment", "Plasticity: plastic work", "Contact: impulse (norm)")
HEADS = {"error_bars.md": ["case", "as shipped", "offsets", *LADDERS, "particles, h → 0", "mesh, h → 0"],
         "summary.md": ["case", "as shipped: tip, mm; root moment, N m; plastic work, J; impulse, N s", "offsets: mean, ± scatter of a run",
                        "particles (finest, mm)", "mesh", "steps", "tip, h → 0 of the particles", "tip, h → 0 of the mesh"]}


def summary_of(case, kind, ladders):
    values = [value_of(quantity, ladders) for quantity in SUMMARY]
    cells = [", ".join("–" if value is None or not ladder or not ladder.values(quantity) else ladder.cell(quantity).split()[0]
                       for quantity, value in zip(SUMMARY, values)) for ladder in ladders.values()]
    particles = ladders["particles"]
    if particles:
        cells[0] += f" ({1e3 * particles.finest_size():.3g})"
    mesh = ladders["mesh"]
    cells.insert(0, ", ".join(mesh.places_cell(quantity) for quantity in SUMMARY) if mesh and mesh.places > 1 else "–")
    cells += [limit_cell(ladders[name], SUMMARY[0]) for name in FITTED]
    yield f"| {case}, {kind} | {'; '.join(value or '–' for value in values)} | {' | '.join(cells)} |"


def write_tables(folder):
    for file, lines in (("error_bars.md", lines_of), ("summary.md", summary_of)):
        table = ["| " + " | ".join(HEADS[file]) + " |", "|---" * len(HEADS[file]) + "|"]
        for case, kinds in CASES.items():
            for kind in kinds.split():
                ladders = {name: read(folder, case, kind, name) for name in LADDERS}
                if any(ladders.values()):
                    table += lines(case, kind, ladders)
        with open(os.path.join(folder, file), "w") as out:
            out.write("\n".join(table).replace(" -", " −") + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("case", nargs="*", help="of prm, without .prm; with :shell or :solid that kind alone")
    parser.add_argument("--output", default="error_bars")
    parser.add_argument("--set", action="append", default=[], help="of all runs (a coarser, faster look)")
    arguments = parser.parse_intermixed_args()
    wanted = [(case, kind) for case, kinds in CASES.items() for kind in kinds.split()
              if not arguments.case or case in arguments.case or f"{case}:{kind}" in arguments.case]
    unknown = [text for text in arguments.case if not any(text in (case, f"{case}:{kind}") for case, kind in wanted)]
    if unknown:
        sys.exit(f"No such case: {', '.join(unknown)}. There are: {', '.join(CASES)}.")
    os.makedirs(arguments.output, exist_ok=True)
    for case, kind in wanted:
        settings = [text for setting in arguments.set for text in ("--set", setting)]
        ladders = {name: converge(arguments.program, arguments.output, case, kind, name, settings) for name in LADDERS}
        print("\n".join(lines_of(case, kind, ladders)), flush=True)
        write_tables(arguments.output)


if __name__ == "__main__":
    main()
