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
    """N s, of a ladder's runs: by level's folder name those of its places, that of the case first."""
    found = {}
    for path in sorted(pathlib.Path(folder).glob("*/summary.json")):
        level = path.parent.name.split("-Lattice-shift")[0]
        found.setdefault(level, []).append(math.hypot(*json.loads(path.read_text())["contact"]["impulse"]))
    return found


def check_limits(expect, ladder):
    """Of a ladder with `--order 1`: the intercepts of straight lines over h."""
    for quantity, row in ladder.rows.items():
        values, limit = ladder.values(quantity), row["extrapolated by known order"]
        expect(f"{quantity}: a limit where there are values", bool(limit) == bool(values))
        if limit:
            line = statistics.linear_regression([float(key.split()[3]) for key in row if key.startswith("at h = ")], values)
            expect(f"{quantity}: {limit}, {line}", abs(float(limit) - line.intercept) <= 1e-9 * max(map(abs, values)))  # of round-off
    expect("some quantity has a limit", any(row["extrapolated by known order"] for row in ladder.rows.values()))


class OneRow:
    """A ladder from 1.5 at the case, whose run had 1.25."""

    def __init__(self, limit="1.2", p="0.4", trend="scatters"):
        self.rows_of_limit = {"tip": {"extrapolated by known order": limit, "half of its 95 % interval": "0.02", "p-value of known order [-]": p,
                                      "ladder": trend}}

    def shipped(self, _):
        return 1.25

    def at_case(self, _):
        return 1.5


def check_cells(expect):
    for ladder, wanted in ((OneRow(), "-24.0 ± 1.6"), (OneRow(p="0.04"), "no order"), (OneRow(trend="diverges"), "–"), (OneRow(limit=""), "–"),
                           (None, "–")):
        cell = error_bars.limit_cell(ladder, "tip")
        expect(f"its cell: {cell}, not {wanted}", cell == wanted)


def main():
    faults = []

    def expect(what, holds):
        if not holds:
            faults.append(what)
    error_bars.PLACES = 2
    with tempfile.TemporaryDirectory() as folder:
        ladders = {name: error_bars.converge(sys.argv[1], folder, "sheath", "shell", name, COARSE) for name in error_bars.LADDERS}
        for name, shipped, finest in (("particles", "Particle-spacing=0.008", "Particle-spacing=0.00321502"),
                                      ("mesh", "Elements-along-span=20-Elements-along-chord=6", "Elements-along-span=44-Elements-along-chord=13")):
            runs = impulses(pathlib.Path(folder) / "sheath-shell" / name)
            n_levels = int(error_bars.ladder_of("sheath", "shell", name)[1])
            expect(f"{name}: {runs}", len(runs) == n_levels and {len(each) for each in runs.values()} == {2})
            at_case = next((runs[run] for run in runs if run == shipped), [math.nan])
            at_finest = next((runs[run] for run in runs if run.startswith(finest)), [math.nan])
            added = 100 * (statistics.mean(at_finest) - statistics.mean(at_case)) / at_case[0]
            cell = ladders[name].cell("Contact: impulse (norm)")
            expect(f"{name}: {cell}, runs {runs}", cell.startswith(f"{added:+.1f} "))
            scatter = math.sqrt(statistics.mean(statistics.variance(each) for each in runs.values()))
            places = f"{100 * (statistics.mean(at_case) / at_case[0] - 1):+.1f} ± {100 * scatter / at_case[0]:.1f}"
            cell = ladders[name].places_cell("Contact: impulse (norm)")
            expect(f"{name}: {cell}, {places}", cell == places)
        step = ladders["step"]
        expect("the step's ladder begins at the case", step.shipped("Contact: impulse (norm)") == step.values("Contact: impulse (norm)")[0])
        check_cells(expect)
        lines = list(error_bars.lines_of("sheath", "shell", ladders))
        print("\n".join(lines))
        expect("no plastic work and no permanent deflection yet", len(lines) == 3)
        expect("a tip that still rises says so", "+ mm |" in lines[0] and "+" not in lines[2].split("|")[2])
        error_bars.write_tables(folder)
        whole = (pathlib.Path(folder) / "error_bars.md").read_text(), (pathlib.Path(folder) / "summary.md").read_text()
        expect("the tables have the ladders that are there", [len(text.splitlines()) for text in whole] == [5, 3])
        expect(f"the summary has what the finest levels add: {whole[1]}",
               all(ladders[name].cell("Contact: impulse (norm)").split()[0].replace("-", "−") in whole[1] for name in ladders))
        expect("a ladder that was lost says so", "| lost |" in "".join(error_bars.lines_of("sheath", "shell", {**ladders, "mesh": None})))
        error_bars.ORDERS = "1"
        check_limits(expect, error_bars.converge(sys.argv[1], folder, "sheath", "shell", "particles", COARSE))
    for fault in faults:
        print("fault:", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
