#!/usr/bin/env python3
"""The headline figures of every shipped strike on a blade, in shells and in bricks, with their error bars.

    bash tests/studies/error_bars.sh                         # all, into build/error_bars; two hours on one idle core
    bash tests/studies/error_bars.sh fan-row sheath:solid    # these alone

Of each case `birdstrike converge` climbs three ladders, one thread a run: particles (five levels 1.2 apart, the case's in the middle: far
coarser ones are not in the asymptotic range where an edge cuts the bird), mesh (three, the finest 1.5 times finer along span and chord)
and time steps (three, the coarsest the case's). A cell is what the finest
level adds to the value as shipped, and half the error bar of the finest level, both in percent of the shipped value; "in x" instead of
a bar where the ladder gives none: all that the three finest levels are apart. A plus behind a value: still rising at the end, no peak.

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

LADDERS = {"particles": ("--levels", "5", "--finer", "2", "--ratio", "1.2"), "mesh": ("--levels", "3", "--finer", "1"),
           "step": ("--levels", "3")}
SHIPPED = {"particles": -3, "mesh": -2, "step": 0}  # the case's own level of the ladder

QUANTITIES = {"Tip: peak (mid-chord)": ("tip peak", "mm", 1e3), "Tip: permanent deflection": ("permanent deflection", "mm", 1e3),
              "Root: peak bending moment": ("root moment", "N m", 1.), "Plasticity: plastic work": ("plastic work", "J", 1.),
              "Contact: impulse (norm)": ("impulse", "N s", 1.)}

QUIET = ("Time/Threads=1", "Output/Blade fields=false", "Output/Bird fields=false", "Output/Checkpoint/At the end=false")


class Ladder:
    """converge.csv of a case: by quantity its values from the coarsest on, and the rest of its row."""

    def __init__(self, path, name):
        self.name = name
        with open(path, newline="") as file:
            self.rows = {row["quantity"]: row for row in csv.DictReader(file)}

    def values(self, quantity):
        """None where a level has none."""
        found = [text for key, text in self.rows.get(quantity, {}).items() if key.startswith("at h = ")]
        return [float(text) for text in found] if found and all(found) else None

    def shipped(self, quantity):
        values = self.values(quantity)
        return values and values[SHIPPED[self.name]]

    def rises(self, quantity):
        return self.rows.get(quantity, {}).get("still rising") == "yes"

    def cell(self, quantity):
        values = self.values(quantity)
        if not values:
            return ""
        scale = 100. / abs(self.shipped(quantity))
        added = f"{scale * (values[-1] - self.shipped(quantity)):+.1f}"
        bar = self.rows[quantity]["error bar"]
        spread = max(values[-3:]) - min(values[-3:])
        return f"{added} ± {scale * float(bar):.1f}" if bar else f"{added} in {scale * spread:.1f}"


def folder_of(folder, case, kind, name):
    return os.path.join(folder, case.replace("/", "-") + "-" + kind, name)


def read(folder, case, kind, name):
    """None where there is none."""
    table = os.path.join(folder_of(folder, case, kind, name), "converge.csv")
    return Ladder(table, name) if os.path.exists(table) else None


def climb(program, folder, case, kind, name, extra):
    output = folder_of(folder, case, kind, name)
    command = [program, "converge", os.path.join(TOP, "prm", case + ".prm"), "--vary", name, *LADDERS[name], "--jobs", "1",
               "--output", output]
    for setting in (f"Blade/Kind={kind}", *QUIET, *extra):
        command += ["--set", setting]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        print(f"{case}, {kind}, {name}: exit code {done.returncode}\n{done.stdout[-600:]}", file=sys.stderr)
    return read(folder, case, kind, name) if done.returncode in (0, 3) else None  # 3: levels were lost, and its table says so


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
    """A line a quantity: value as shipped, and a cell a ladder."""
    for quantity, (name, unit, _) in QUANTITIES.items():
        value = value_of(quantity, ladders)
        if value is None:
            continue
        cells = [ladder.cell(quantity) if ladder else "lost" for ladder in ladders.values()]
        yield f"| {case}, {kind} | {name} {value} {unit} | {' | '.join(cells)} |"


SUMMARY = ("Tip: peak (mid-chord)", "Root: peak bending moment", "Plasticity: plastic work", "Contact: impulse (norm)")
HEADS = {"error_bars.md": ["case", "as shipped", *LADDERS],
         "summary.md": ["case", "as shipped: tip, mm; root moment, N m; plastic work, J; impulse, N s", "particles 1.44 times finer",
                        "mesh 1.5 times finer", "steps 0.44 times as long"]}


def summary_of(case, kind, ladders):
    values = [value_of(quantity, ladders) for quantity in SUMMARY]
    cells = [", ".join("–" if value is None or not ladder or not ladder.values(quantity) else ladder.cell(quantity).split()[0]
                       for quantity, value in zip(SUMMARY, values)) for ladder in ladders.values()]
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
        ladders = {name: climb(arguments.program, arguments.output, case, kind, name, arguments.set) for name in LADDERS}
        print("\n".join(lines_of(case, kind, ladders)), flush=True)
        write_tables(arguments.output)


if __name__ == "__main__":
    main()
