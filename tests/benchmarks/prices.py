#!/usr/bin/env python3
"""The table of prices (include/birdstrike/core/prices.h) against benchmarks: python3 tests/benchmarks/prices.py benchmarks.json

Prices are compared up to one common factor, the median of all ratios measured/table: another machine is faster or slower,
and only their ratios choose the ratio of steps. A price that is off by more than a third beside that factor has aged, and
is named; the exit status is then 1. With --absolute the factor has to be within a third of 1 too. Bytes have no factor.
"""

import argparse
import pathlib
import re
import statistics
import sys

from compare import BadInput, read_benchmarks

HEADER = pathlib.Path(__file__).resolve().parents[2] / "include/birdstrike/core/prices.h"
SIZE = "/n:10000/threads:1"
TOLERANCE = 4.0 / 3.0  # benchmarks of one machine repeat within a tenth; a third moves a choice between two ratios


def read_table(text):
    """[(constant, value, benchmark, counter or None)]"""
    pattern = r"constexpr double (\w+)\s*=\s*([\d.]+);\s*///< ([\w/]+)(?:: (bytes_\w+))?"
    return [(name, float(value), benchmark, counter) for name, value, benchmark, counter in re.findall(pattern, text)]


def compare(table, benchmarks):
    """(factor, [(constant, value, measured, ratio beside the factor)])"""
    rows = []
    for name, value, benchmark, counter in table:
        entry = benchmarks.get(benchmark + SIZE)
        if entry is None or (counter and counter not in entry):
            raise BadInput(f"{benchmark + SIZE}: was not measured; {name} needs it.")
        rows.append((name, value, entry[counter] if counter else entry["time"] / entry["units"], bool(counter)))
    factor = statistics.median(measured / value for _, value, measured, is_bytes in rows if not is_bytes)
    return factor, [
        (name, value, measured, measured / value / (1.0 if is_bytes else factor)) for name, value, measured, is_bytes in rows
    ]


def is_off(ratio):
    return not 1.0 / TOLERANCE <= ratio <= TOLERANCE


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("benchmarks")
    parser.add_argument("--absolute", action="store_true", help="on the machine of the table")
    arguments = parser.parse_args()
    try:
        table = read_table(HEADER.read_text(encoding="utf-8"))
        factor, rows = compare(table, read_benchmarks(arguments.benchmarks)[1])
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
