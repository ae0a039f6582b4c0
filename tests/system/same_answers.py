#!/usr/bin/env python3
"""Whether two builds of the program give the same answers: history.csv of every shipped case, byte by byte.

    python3 tests/system/same_answers.py BEFORE AFTER [--only NAME]... [--keep FOLDER] [--whole]

For a change that must not change results. Ends of long cases are shortened (--whole: as shipped); cases of shells run as
solids too, and one of them with an element of every kind, with a symmetry plane and with several rates. A case that
differs names the first row and column that does, and by how much; columns that only one of the two has are named, not
compared, and so are cases whose entries BEFORE does not know. Exit code 1 if any differs.
"""

import argparse
import concurrent.futures
import csv
import pathlib
import subprocess
import sys
import tempfile

PRM = pathlib.Path(__file__).resolve().parents[2] / "prm"

# name: (file, settings)
SOLID = ["Blade/Kind=solid"]
SHORT = ["Time/End time=0.6e-3"]
COARSE = ["Bird/Particle spacing=0.005", "Time/Threads=1"]
ELEMENT = "Blade/Element/Formulation="
CASES = {
    "bird-free": ("bird-free", []),
    "blade-impulse": ("blade-impulse", []),
    "fan-blade": ("fan-blade", SHORT),
    "fan-blade solid": ("fan-blade", SOLID + SHORT),
    "frontal": ("frontal", SHORT),
    "frontal solid": ("frontal", SOLID + SHORT),
    "frontal Belytschko-Tsay": ("frontal", SHORT + COARSE + [ELEMENT + "Belytschko-Tsay"]),
    "frontal fully integrated": ("frontal", SHORT + COARSE + [ELEMENT + "fully integrated"]),
    "frontal one point, two layers": ("frontal", SOLID + SHORT + COARSE + [ELEMENT + "one point", "Blade/Mesh/Layers=2"]),
    "frontal B-bar, two layers": ("frontal", SOLID + ["Time/End time=0.2e-3"] + COARSE + [ELEMENT + "B-bar", "Blade/Mesh/Layers=2"]),
    "frontal mass scaling": ("frontal", SOLID + SHORT + COARSE + ["Blade/Mesh/Layers=4", "Blade/Mass scaling/Method=selective"]),
    "frontal half": ("frontal", SHORT + COARSE + ["Case/Symmetry plane=y"]),
    "frontal solid half": ("frontal", SOLID + SHORT + COARSE + ["Case/Symmetry plane=y"]),
    "oblique": ("oblique", SHORT),
    "oblique solid": ("oblique", SOLID + SHORT),
    "oblique damped, loaded": ("oblique", SHORT + COARSE + ["Blade/Loads/Damping=200", "Blade/Loads/Pressure=1e5"]),
    "oblique standard particles": ("oblique", SHORT + COARSE + ["Bird/Formulation=standard"]),
    "perforation": ("perforation", []),
    "perforation solid": ("perforation", SOLID),
    "quickstart": ("quickstart", []),
    "rigid-plate": ("rigid-plate", []),
    "sheath": ("sheath", []),
    "sheath solid": ("sheath", SOLID),
}


def run(program, case, settings, folder, may_refuse=False):
    command = [program, "run", str(PRM / (case + ".prm")), "--output", str(folder)]
    for setting in settings + ["Output/Field interval=0", "Output/Blade fields=false", "Output/Bird fields=false"]:
        command += ["--set", setting]
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if may_refuse and result.returncode == 2: # input that it cannot read
        return None
    if result.returncode != 0:
        sys.exit(f"{' '.join(command)}\nends with {result.returncode}:\n{result.stdout[-2000:]}")
    with open(folder / "history.csv", newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return rows[0], rows[1:]


def first_difference(before, after):
    """A sentence, or "" where all common columns agree in every character."""
    (head_before, rows_before), (head_after, rows_after) = before, after
    common = [name for name in head_before if name in head_after]
    where_before = [head_before.index(name) for name in common]
    where_after = [head_after.index(name) for name in common]
    for number, (a, b) in enumerate(zip(rows_before, rows_after)):
        for name, i, j in zip(common, where_before, where_after):
            if a[i] != b[j]:
                return f"row {number}, '{name}': {a[i]} before, {b[j]} after"
    if len(rows_before) != len(rows_after):
        return f"{len(rows_before)} rows before, {len(rows_after)} after"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--only", action="append", choices=sorted(CASES), default=[])
    parser.add_argument("--keep", metavar="FOLDER", help="keep the runs here")
    parser.add_argument("--whole", action="store_true", help="run to the ends that the files name")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        top = pathlib.Path(options.keep or scratch)
        n_different = 0
        for name, (case, settings) in CASES.items():
            if options.only and name not in options.only:
                continue
            if options.whole:
                settings = [setting for setting in settings if not setting.startswith("Time/End time")]
            folder = top / name.replace(" ", "-").replace(",", "")
            with concurrent.futures.ThreadPoolExecutor() as both:
                runs = [both.submit(run, options.before, case, settings, folder / "before", True),
                        both.submit(run, options.after, case, settings, folder / "after")]
                before, after = (done.result() for done in runs)
            if before is None:
                print(f"{name:32s} not known to BEFORE", flush=True)
                continue
            difference = first_difference(before, after)
            n_different += difference != ""
            only = sorted(set(before[0]) ^ set(after[0]))
            print(f"{name:32s} {'same' if not difference else 'DIFFERENT: ' + difference}"
                  f"{', columns of one only: ' + ', '.join(only) if only else ''}", flush=True)
    return 1 if n_different else 0


if __name__ == "__main__":
    sys.exit(main())
