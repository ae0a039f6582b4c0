#!/usr/bin/env python3
"""The table of prices (include/birdstrike/core/prices.h) against benchmarks: python3 tests/benchmarks/prices.py benchmarks.json

Prices are compared up to one common factor, the median of all ratios measured/table: another machine is faster or slower,
and only their ratios choose the ratio of steps. A price that is off by more than a third beside that factor has aged, and
is named; the exit status is then 1. With --absolute the factor has to be within a third of 1 too. Bytes have no factor.
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys

from compare import BadInput, read_benchmarks

HEADER = pathlib.Path(__file__).resolve().parents[2] / "include/birdstrike/core/prices.h"
FRONTAL = pathlib.Path(__file__).resolve().parents[2] / "prm/frontal.prm"
SIZE = "/n:10000/threads:1"
EXPLAIN = "explain"  # what building takes is measured on the program itself
TOLERANCE = 4.0 / 3.0  # benchmarks of one machine repeat within a tenth; a third moves a choice between two ratios


def read_table(text):
    """[(constant, value, benchmark, counter or None)]"""
    pattern = r"constexpr double (\w+)\s*=\s*([\d.]+);\s*///< (explain|\w+/[\w/]+)(?:: (bytes_\w+))?"
    return [(name, float(value), benchmark, counter) for name, value, benchmark, counter in re.findall(pattern, text)]


def compare(table, benchmarks):
    """(factor, [(constant, value, measured, ratio beside the factor)])"""
    rows = []
    for name, value, benchmark, counter in table:
        if benchmark == EXPLAIN:
            continue
        entry = benchmarks.get(benchmark + SIZE)
        if entry is None or (counter and counter not in entry):
            raise BadInput(f"{benchmark + SIZE}: was not measured; {name} needs it.")
        rows.append((name, value, entry[counter] if counter else entry["time"] / entry["units"], bool(counter)))
    factor = statistics.median(measured / value for _, value, measured, is_bytes in rows if not is_bytes)
    return factor, [
        (name, value, measured, measured / value / (1.0 if is_bytes else factor)) for name, value, measured, is_bytes in rows
    ]


def peak_memory(program, entries):
    """Largest resident set (bytes) of explain."""
    words = [word for entry in entries for word in ("--set", entry)]
    child = subprocess.Popen([program, "explain", FRONTAL, *words], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        raise BadInput(f"explain with {entries} failed.")
    return 1024.0 * usage.ru_maxrss


def measure_building(program):
    """Bytes of one more particle, shell with its node, brick with its two nodes; the dearest kind of each."""
    blade = ["Bird/Enabled=false"]
    large, small = (["Blade/Mesh/Elements along span=496", "Blade/Mesh/Elements along chord=144"], [])
    n_elements = 496 * 144 - 62 * 18
    slope = lambda more, less, n: (peak_memory(program, more) - peak_memory(program, less)) / n  # noqa: E731
    volume = 0.1005 / 950
    return {
        "particle": slope(["Bird/Particle spacing=0.0008"], ["Bird/Particle spacing=0.004"], volume / 0.0008**3 - volume / 0.004**3),
        "shell": max(slope([*blade, *large, kind], [*blade, *small, kind], n_elements)
                     for kind in ("Blade/Element/Formulation=physical", "Blade/Element/Formulation=fully integrated")),
        "brick": max(slope([*blade, *large, "Blade/Kind=solid", kind], [*blade, *small, "Blade/Kind=solid", kind], n_elements)
                     for kind in ("Blade/Element/Formulation=one point", "Blade/Element/Formulation=B-bar")),
    }


def compare_building(table, measured):
    """The same rows of what the table's sums foretell: a single element cannot be measured without its nodes."""
    value = {name: value for name, value, benchmark, _ in table if benchmark == EXPLAIN}
    element, node = value["building_element"], value["building_node"]
    foretold = {"particle": value["building_particle"], "shell": element + node, "brick": element + 2.0 * node}
    return [(f"building a {kind}", foretold[kind], measured[kind], measured[kind] / foretold[kind]) for kind in foretold]


def is_off(ratio):
    return not 1.0 / TOLERANCE <= ratio <= TOLERANCE


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("benchmarks")
    parser.add_argument("--program", help="birdstrike, whose explain is measured: what building a scene takes")
    parser.add_argument("--absolute", action="store_true", help="on the machine of the table")
    arguments = parser.parse_args()
    try:
        table = read_table(HEADER.read_text(encoding="utf-8"))
        factor, rows = compare(table, read_benchmarks(arguments.benchmarks)[1])
        if arguments.program:
            rows += compare_building(table, measure_building(arguments.program))
    except BadInput as error:
        print(error, file=sys.stderr)
        return 2
    print(f"prices: this machine takes {factor:.2f} of the table's times")
    aged = [row for row in rows if is_off(row[3])]
    for name, value, measured, ratio in aged:
        print(f"  {name}: {measured:.0f} measured, {value:.0f} in the table, {ratio:.2f} of what the others say")
    return 1 if aged or (arguments.absolute and is_off(factor)) else 0


if __name__ == "__main__":
    sys.exit(main())
