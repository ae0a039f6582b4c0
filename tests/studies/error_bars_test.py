#!/usr/bin/env python3
"""error_bars_test.py PROGRAM: the ladders of a short, coarse strike, whose cells are worked out again from the runs' own summaries."""
import json
import math
import pathlib
import statistics
import sys
import tempfile

import error_bars

COARSE = [text for setting in ("Bird/Particle spacing=0.008", "Blade/Mesh/Elements along span=20", "Blade/Mesh/Elements along chord=6",
                               "Time/End time=0.15e-3") for text in ("--set", setting)]


def impulses(folder):
    """N s, of a ladder's runs by their folder's name."""
    found = {}
    for path in pathlib.Path(folder).glob("*/summary.json"):
        found[path.parent.name] = math.hypot(*json.loads(path.read_text())["contact"]["impulse"])
    return found


def check_limits(expect, ladder, limits):
    """The intercepts of straight lines over h^p, of the quantities whose observed order is near a whole one."""
    for quantity, row in ladder.rows.items():
        order, values = error_bars.whole_order(row["observed order [-]"]), ladder.values(quantity)
        expect(f"{quantity}: a limit where there is an order", (quantity in limits) == bool(order and values))
        if quantity in limits:
            sizes = [float(key.split()[3])**order for key in row if key.startswith("at h = ")]
            line = statistics.linear_regression(sizes, values)
            found = float(limits[quantity]["limit"])
            expect(f"{quantity}: {found}, {line}", abs(found - line.intercept) <= 1e-9 * max(map(abs, values)))  # of round-off
            if ladder.shipped(quantity) == 0.:
                continue  # has no line in the tables
            shipped = ladder.shipped(quantity)
            cell, added = error_bars.limit_cell(limits[quantity], shipped), 100 * (line.intercept - shipped) / abs(shipped)
            expect(f"{quantity}: {cell}", cell.startswith(f"{added:+.1f} ") and f"(order {order})" in cell)
    expect("some quantity has a limit", limits)


def main():
    faults = []

    def expect(what, holds):
        if not holds:
            faults.append(what)
    with tempfile.TemporaryDirectory() as folder:
        ladders = {name: error_bars.climb(sys.argv[1], folder, "sheath", "shell", name, COARSE) for name in error_bars.LADDERS}
        for name, shipped, finest in (("particles", "Particle-spacing=0.008", "Particle-spacing=0.00321502"),
                                      ("mesh", "Elements-along-span=20-Elements-along-chord=6", "Elements-along-span=30-Elements-along-chord=9")):
            runs = impulses(pathlib.Path(folder) / "sheath-shell" / name)
            expect(f"{name}: {len(runs)} runs", len(runs) == int(error_bars.ladder_of("sheath", name)[1]))
            one = next((runs[run] for run in runs if run == shipped), math.nan)
            two = next((runs[run] for run in runs if run.startswith(finest)), math.nan)
            cell = ladders[name].cell("Contact: impulse (norm)")
            expect(f"{name}: {cell}, runs {runs}", cell.startswith(f"{100 * (two / one - 1):+.1f} "))
        step = ladders["step"]
        expect("the step's ladder begins at the case", step.shipped("Contact: impulse (norm)") == step.values("Contact: impulse (norm)")[0])
        expect("orders near whole ones", [error_bars.whole_order(text) for text in ("", "0.6", "0.9", "1.3", "1.4", "1.6", "2.5", "4")] ==
               [None, None, 1, 1, None, 2, 2, None])
        error_bars.whole_order = lambda text: 1 # so short a strike shows none
        error_bars.climb(sys.argv[1], folder, "sheath", "shell", "particles", COARSE)
        limits = error_bars.limits_of(folder, "sheath", "shell")
        check_limits(expect, ladders["particles"], limits)
        lines = list(error_bars.lines_of("sheath", "shell", ladders, limits))
        print("\n".join(lines))
        expect("no plastic work and no permanent deflection yet", len(lines) == 3)
        expect("a tip that still rises says so", "+ mm |" in lines[0] and "+" not in lines[2].split("|")[2])
        error_bars.write_tables(folder)
        whole = (pathlib.Path(folder) / "error_bars.md").read_text(), (pathlib.Path(folder) / "summary.md").read_text()
        expect("the tables have the ladders that are there", [len(text.splitlines()) for text in whole] == [5, 3])
        expect(f"the summary has what the finest levels add: {whole[1]}",
               all(ladders[name].cell("Contact: impulse (norm)").split()[0].replace("-", "−") in whole[1] for name in ladders))
        expect("a ladder that was lost says so", "| lost |" in "".join(error_bars.lines_of("sheath", "shell", {**ladders, "mesh": None}, {})))
    for fault in faults:
        print("fault:", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
