#!/usr/bin/env python3
"""Two benchmark files (Google Benchmark's JSON) as ratios after/before of the smallest repetition.

    python3 tests/benchmarks/compare.py before.json after.json [--threshold 0.05] [--fail-above 1.10] [--filter bird]

Lines beyond the threshold are marked. With --fail-above R the exit status is 1 if any ratio exceeds R. Bad input: 2.
"""

import argparse
import json
import re
import sys


class BadInput(Exception):
    """What is wrong with a file, in a line."""


def short_name(name):
    """A benchmark's name without how often it ran: these may differ between the files."""
    return re.sub(r"/(iterations:\d+|repeats:\d+|min_time:[\d.]+|real_time|process_time)", "", name)


def read_benchmarks(path):
    """(context, {name: entry of the fastest repetition}), with "time" and the smallest "real_time" in ns."""
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except OSError as error:
        raise BadInput(f"{path}: cannot be read ({error.strerror}).") from error
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise BadInput(f"{path}: is not JSON ({error}).") from error
    if not isinstance(data, dict) or not isinstance(data.get("benchmarks"), list):
        raise BadInput(f'{path}: has no list "benchmarks"; write it with --benchmark_out=FILE.')
    nanoseconds = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    fastest = {}
    for entry in data["benchmarks"]:
        if not isinstance(entry, dict) or "name" not in entry or entry.get("run_type", "iteration") != "iteration":
            continue
        name = short_name(entry["name"])
        try:
            # several threads are timed by the clock, one by its processor time
            which = "real_time" if "/real_time" in entry["name"] else "cpu_time"
            unit = nanoseconds[entry.get("time_unit", "ns")]
            time, entry["real_time"] = float(entry[which]) * unit, float(entry["real_time"]) * unit
        except (KeyError, TypeError, ValueError) as error:
            raise BadInput(f"{path}: benchmark {name} has no time.") from error
        if not time > 0.0:
            raise BadInput(f"{path}: benchmark {name} took {time} ns.")
        clock = min(entry["real_time"], fastest[name]["real_time"]) if name in fastest else entry["real_time"]
        if name not in fastest or time < fastest[name]["time"]:
            fastest[name] = dict(entry, time=time)
        fastest[name]["real_time"] = clock
    return data.get("context", {}), fastest


def format_time(nanoseconds):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("us", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.4g} {unit}"
    return f"{nanoseconds:.4g} ns"


def describe(context):
    return ", ".join(str(context[key]) for key in ("machine", "compiler", "flags", "simd_doubles", "commit") if key in context)


def compare(before, after, threshold):
    """Lines of the table and the largest ratio of the benchmarks that both files have."""
    common = [name for name in before if name in after]
    if not common:
        raise BadInput("The two files have no benchmark in common.")
    width = max(map(len, common))
    lines = [f"{'benchmark':<{width}}  {'before':>10}  {'after':>10}   ratio"]
    largest = 0.0
    for name in common:
        old, new = before[name]["time"], after[name]["time"]
        ratio = new / old
        largest = max(largest, ratio)
        mark = "  slower" if ratio > 1.0 + threshold else "  faster" if ratio < 1.0 / (1.0 + threshold) else ""
        lines.append(f"{name:<{width}}  {format_time(old):>10}  {format_time(new):>10}  {ratio:6.3f}{mark}")
    for names, where in ((before.keys() - after.keys(), "before"), (after.keys() - before.keys(), "after")):
        if names:
            lines.append(f"only {where}: {len(names)} ({sorted(names)[0]}{', ...' if len(names) > 1 else ''})")
    return lines, largest


def main():
    parser = argparse.ArgumentParser(description="Ratios after/before of two benchmark files.")
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--threshold", type=float, default=0.05, help="mark beyond this relative change (default 0.05)")
    parser.add_argument("--fail-above", type=float, metavar="R", help="exit status 1 if a ratio exceeds R")
    parser.add_argument("--filter", default="", help="only names that contain this")
    arguments = parser.parse_args()
    try:
        sides = [read_benchmarks(path) for path in (arguments.before, arguments.after)]
        chosen = [{n: e for n, e in entries.items() if arguments.filter in n} for _, entries in sides]
        lines, largest = compare(*chosen, arguments.threshold)
    except BadInput as error:
        print(error, file=sys.stderr)
        return 2
    if describe(sides[0][0]) != describe(sides[1][0]):
        print(f"before: {describe(sides[0][0])}\nafter:  {describe(sides[1][0])}")
    print("\n".join(lines))
    if arguments.fail_above is not None and largest > arguments.fail_above:
        print(f"The largest ratio, {largest:.3f}, is above {arguments.fail_above}.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
