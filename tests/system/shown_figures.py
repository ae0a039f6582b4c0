#!/usr/bin/env python3
"""Tables of results that documents show, against the runs that they are of: shown_figures.py PROGRAM TOP

Figures may differ by half of their last digit and 0.5 %: compilers and processors round differently. The energy error, a sum of
round-off and of the scheme's errors, may be half or twice as large.
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SOLID = ("Blade/Kind=solid", f"Blade/Mesh/File={TOP}/meshes/own-blade-solid.msh")
TABLES = (("README.md", "frontal", (), 1), ("prm/manual/own-blade.md", "own-blade", (), 1), ("prm/manual/own-blade.md", "own-blade", SOLID, 2))
UNITS = {"mm": 1e-3, "N s": 1.0, "N m": 1.0, "kN m": 1e3, "J": 1.0, "GPa": 1e9, "MPa": 1e6, "%": 1e-2}
FIGURES = {
    "tip deflection, peak": lambda s: s["tip"]["peak"],
    "impulse on the blade": lambda s: math.hypot(*s["contact"]["impulse"]),
    "impulse on the blade (norm)": lambda s: math.hypot(*s["contact"]["impulse"]),
    "root moment, peak": lambda s: s["root"]["peak_moment"],
    "root normal stress, peak": lambda s: s["root"]["peak_normal_stress"],
    "plastic work": lambda s: s["plastic"]["work"],
    "energy error": lambda s: s["energy"]["max_relative_error"],
    "energy error, largest": lambda s: s["energy"]["max_relative_error"],
}


def rows_of(document):
    """{name: cells} of the tables whose rows are figures."""
    lines = (TOP / document).read_text(encoding="utf-8").splitlines()
    rows = ([cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("|"))
    return {cells[0]: cells for cells in rows if cells[0] in FIGURES}


def is_shown_right(name, cell, value):
    number, unit = re.match(r"([\d.]+) (N s|N m|kN m|\S+)", cell).groups()
    shown, scale = float(number), UNITS[unit]
    if name.startswith("energy error"):
        return shown / 2 <= value / scale <= 2 * shown
    last_digit = 10.0 ** -len(number.partition(".")[2])
    return abs(value / scale - shown) <= 0.5 * last_digit + 0.005 * shown


def main():
    n_compared = n_failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for k, (document, case, entries, column) in enumerate(TABLES):
            run = pathlib.Path(folder) / str(k)
            words = [word for entry in entries for word in ("--set", entry)]
            subprocess.run([PROGRAM, "run", TOP / "prm" / f"{case}.prm", "--output", run, *words, "--set", "Output/Field interval=0"],
                           check=True, stdout=subprocess.DEVNULL)
            summary = json.loads((run / "summary.json").read_text(encoding="utf-8"))
            for name, cells in rows_of(document).items():
                n_compared += 1
                value = FIGURES[name](summary)
                if not is_shown_right(name, cells[column], value):
                    n_failed += 1
                    print(f"FAILED {document}: {name} = {cells[column]}, and {case}.prm {' '.join(entries)} gives {value:.6g} in SI")
    print(f"{n_compared} figures, {n_failed} failed")
    return 1 if n_failed or n_compared < 15 else 0


if __name__ == "__main__":
    sys.exit(main())
