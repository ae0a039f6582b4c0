#!/usr/bin/env python3
"""The tables "Measured" of tests/README.md from what run.sh has measured: python3 tests/benchmarks/speed_table.py build/speed [BEFORE]

Reads benchmarks.json and the run folders NAME-THREADS-REPEAT, of which the fastest counts. What is missing becomes a dash. BEFORE is such
a folder of another program, measured on the same machine: a column more, and "before → now" in the cells.
"""

import json
import os
import re
import sys

from compare import BadInput, read_benchmarks


class Measured:
    """Access to everything that was measured, None where it was not."""

    def __init__(self, folder):
        self.context, self.benchmarks = read_benchmarks(os.path.join(folder, "benchmarks.json"))
        self.runs = {}
        for name in sorted(os.listdir(folder)):
            match = re.fullmatch(r"(\w+)-(\d+)-\d+", name)
            if match and os.path.exists(os.path.join(folder, name, "summary.json")):
                key, run = (match.group(1), int(match.group(2))), read_run(os.path.join(folder, name))
                if key not in self.runs or run["summary"]["cost"]["wall"] < self.runs[key]["summary"]["cost"]["wall"]:
                    self.runs[key] = run

    def entry(self, name, n, threads=1):
        size = f"/n:{n}" if isinstance(n, int) else f"/{n}"
        return self.benchmarks.get(f"{name}{size}/threads:{threads}")

    def per_unit(self, name, n, threads=1):
        """ns per unit of work of the fastest repetition."""
        entry = self.entry(name, n, threads)
        return entry["time"] / entry["units"] if entry else None

    def gain(self, name, n):
        """By a second thread: by the clock for both, while one thread's cost is its processor time."""
        one, two = self.entry(name, n, 1), self.entry(name, n, 2)
        return one["real_time"] / one["units"] / (two["real_time"] / two["units"]) if one and two else None

    def value(self, name, n, key, threads=1):
        entry = self.entry(name, n, threads)
        return entry.get(key) if entry else None

    def run(self, name, threads=1):
        return self.runs.get((name, threads))

    def wall(self, name, threads=1):
        run = self.run(name, threads)
        return run["summary"]["cost"]["wall"] if run else None


def read_run(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    sections, in_table = {}, False
    with open(os.path.join(folder, "log.txt"), encoding="utf-8") as file:
        for line in file:
            in_table = in_table or line.startswith("section ")
            match = re.match(r"(\S.*?)\s{2,}([\d.]+)\s+([\d.]+)%\s+(\d*)\s*$", line) if in_table else None
            if match:
                sections[match.group(1)] = float(match.group(2))
    return {"summary": summary, "sections": sections}


def combine(function, *values):
    return None if any(value is None for value in values) else function(*values)


def text(value, pattern="{:.0f}"):
    return "–" if value is None else pattern.format(value)


def beside(rows, before):
    """Cells as "before → now" where both have one; the first names the row, and may count what differs."""
    return [[now[0]] + [cell if old in ("–", cell) or cell == "–" else f"{old} → {cell}" for old, cell in zip(past[1:], now[1:])]
            for past, now in zip(before, rows)]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def machine(m):
    c = m.context
    run = m.run("frontal")
    counts = "" if run is None else (f" `frontal.prm` to {1e3 * run['summary']['end']['time']:.0f} ms: {run['summary']['bird']['particles']} "
                                     f"particles, {run['summary']['blade']['elements']} elements, {run['summary']['steps']['bird']} steps.")
    probe = m.gain("machine/fma/double", 1000)
    second = "" if probe is None else f" A second thread's gain on multiply-adds in registers: {probe:.2f}."
    return (f"{c.get('machine', 'unknown machine')}, {c.get('num_cpus', '?')} cores, {c.get('simd_doubles', '?')} doubles a register, "
            f"{c.get('compiler', '?')} (`{c.get('flags', '')}`), commit {c.get('commit', '?')}.{counts}{second}\n")


def targets(m, before=None):
    rows = target_rows(m)
    if before is None:
        return table(["loop, one core", "target", "measured"], rows)
    return table(["loop, one core", "target", "before", "now"], [now[:2] + past[2:] + now[2:] for past, now in zip(target_rows(before), rows)])


def target_rows(m):
    plastic = combine(lambda forces, step, elastic: forces + step - elastic, m.per_unit("shell/forces/physical/plastic_5", 1000),
                      m.per_unit("shell/step/elastic", 1000), m.per_unit("shell/forces/physical/elastic", 1000))
    run = m.run("frontal")
    rest = run and sum(run["sections"].get(name, 0.0) for name in ("balance and output", "other")) / run["summary"]["cost"]["wall"]
    cost = run["summary"]["cost"] if run else {}
    neighbors = text(m.value("bird/step/riemann", 10000, "true_neighbors"))
    ratio = combine(lambda one, two: one / two, m.wall("frontal_20k", 1), m.wall("frontal_20k", 2))
    return [
        [f"particle-step, list, EOS and integration included ({neighbors} true neighbours)", "≤ 150 ns",
         text(m.per_unit("bird/step/riemann", 10000), "{:.0f} ns")],
        ["the same, mean over `frontal.prm`", "≤ 150 ns", text(cost.get("ns_per_particle_step"), "{:.0f} ns")],
        ["element-step, elastic, integration included", "≤ 60 ns", text(m.per_unit("shell/step/elastic", 1000), "{:.0f} ns")],
        ["element-step, 5 points, all plastic", "≤ 180 ns", text(plastic, "{:.0f} ns")],
        ["element-step, mean over `frontal.prm`", "", text(cost.get("ns_per_element_step"), "{:.0f} ns")],
        ["contact, per near point, lists amortised", "≤ 60 ns", text(m.per_unit("contact/step", 1000), "{:.0f} ns")],
        ["everything else in a step (balance, output, rest)", "≤ 5 %", text(rest, "{:.1%}").replace("%", " %")],
        ["`frontal.prm` to 2 ms", "≤ 3 s", text(m.wall("frontal"), "{:.2f} s")],
        ["two threads over one, 20k particles and 5k shells", "≥ 1.8", text(ratio, "{:.2f}")]]


def sizes(m, before=None):
    rows = size_rows(m) if before is None else beside(size_rows(m), size_rows(before))
    return table(["ns on one core / gain by a second", "1e3", "1e4", "1e5", "1e6", "memory by the allocator, at 1e5"], rows)


def size_rows(m):
    rows = []
    for label, name, unit in (("particle-step", "bird/step/riemann", "bytes_per_particle"),
                              ("list build", "bird/list", None),
                              ("element, elastic", "shell/forces/physical/elastic", "bytes_per_element"),
                              ("element, 5 points plastic", "shell/forces/physical/plastic_5", "bytes_per_element"),
                              ("fully integrated shell, elastic", "shell/forces/fully_integrated/elastic", "bytes_per_element"),
                              ("fully integrated shell, 5 points plastic", "shell/forces/fully_integrated/plastic_5", "bytes_per_element"),
                              ("one-point brick, elastic", "solid/forces/one_point/elastic", "bytes_per_element"),
                              ("one-point brick, plastic", "solid/forces/one_point/plastic", "bytes_per_element"),
                              ("solid-shell, elastic", "solid/forces/solid_shell/elastic", "bytes_per_element"),
                              ("solid-shell, 5 points plastic", "solid/forces/solid_shell/plastic", "bytes_per_element"),
                              ("B-bar brick, plastic", "solid/forces/b_bar/plastic", "bytes_per_element"),
                              ("near point", "contact/step", None)):
        cells = [label]
        for n in (1000, 10000, 100000, 1000000):
            one = m.per_unit(name, n)
            cells.append("–" if one is None else f"{one:.0f} / {text(m.gain(name, n), '{:.2f}')}")
        cells.append(text(m.value(name, 100000, unit) if unit else None, "{:.0f} B"))
        rows.append(cells)
    return rows


def phases(m, before=None):
    rows = phase_rows(m) if before is None else beside(phase_rows(m), phase_rows(before))
    return table(["one step of the strike / gain by a second core", "1.7k particles, 0.3k shells", "6.8k, 1.1k", "20k, 5k"], rows)


def phase_rows(m):
    rows = []
    for phase in ("early_impact", "peak_flow", "blade_only"):
        cells = [phase.replace("_", " ")]
        for size in ("particles:1700", "particles:6800", "particles:20000"):
            one = m.entry(f"scene/{phase}", size)
            cells.append("–" if one is None else f"{one['time'] / 1e6:.2f} ms / {text(m.gain(f'scene/{phase}', size), '{:.2f}')}")
        rows.append(cells)
    return rows


def shares(m):
    run = m.run("frontal")
    if run is None:
        return ""
    wall = run["summary"]["cost"]["wall"]
    rows = [[name, f"{seconds:.2f} s", f"{seconds / wall:.1%}".replace("%", " %")] for name, seconds in run["sections"].items()]
    return table(["`frontal.prm` to 2 ms, one core", "time", "share"], rows)


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    measured = []
    for folder in sys.argv[1:]:
        try:
            measured.append(Measured(folder))
        except (BadInput, OSError, KeyError, ValueError) as error:
            print(f"{folder}: {error}", file=sys.stderr)
            return 2
    now = measured[0]
    machines = [prefix + machine(m) for prefix, m in zip(("", "Before: "), measured)]
    print("\n".join(part for part in (*machines, targets(*measured), sizes(*measured), phases(*measured), shares(now)) if part))
    return 0


if __name__ == "__main__":
    sys.exit(main())
