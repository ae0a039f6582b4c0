#!/usr/bin/env python3
"""Draws scenes at random and judges each by what can be said from outside of the program's own ledger.

    python3 tests/scenes/draw.py build/bin/birdstrike --seed 1 --count 30
    python3 tests/scenes/draw.py build/bin/birdstrike --seed 7 --only fold --keep failures     # one scene again, its files kept

Soft and light targets, fast birds, folds, grazing, moving frames, both sides, file orders, tiny and huge scales. Each runs with one thread
and two (every number the same), with another interval of output (the same summary), and once more written down otherwise (twins.py:
the same answer). One row a scene, to be looked at; exit code 1 if one fails. A stop (exit 3) or refusal (2) in words is no failure,
but counted: nearly all of these scenes should run.
"""

import argparse
import math
import os
import random
import shutil
import sys
import tempfile

import draws
import strike
import twins

NEGATIVE, ENERGY, MOMENTUM, DEEP = 1e-4, 1e-2, 1e-9, 0.5


def energy_residual(result):
    """Largest sum of all energies less what there was and came from outside, over the energy at the start."""
    columns = result.columns
    internal = ("bird_elastic", "bird_dissipated") if "bird_elastic" in columns else ("bird_internal",)
    names = [n for n in (*strike.NOT_NEGATIVE, *internal) if n in columns and not n.startswith(("bird_elastic", "bird_dissipated"))]
    names += [n for n in (*internal, "staggering") if n in columns]
    total = [sum(columns[n][k] for n in names) - columns.get("blade_external_work", [0.] * (k + 1))[k]
             for k in range(len(columns["time"]))]
    return max(abs(value - total[0]) for value in total) / total[0]


def momentum_residual(result):
    """Of the bird against contact's impulse, and of the blade and its supports against the same."""
    columns, largest, scale = result.columns, 0., 1e-300
    for axis in "xyz":
        bird, blade, held, given = (columns[f"{name}_{axis}"] for name in ("bird_momentum", "blade_momentum", "support_impulse",
                                                                          "contact_impulse"))
        scale = max(scale, max(map(abs, bird)), max(map(abs, blade)), max(map(abs, given)))
        for k in range(len(given)):
            largest = max(largest, abs(bird[k] - bird[0] + given[k]), abs(blade[k] - blade[0] + held[k] - given[k]))
    return largest / scale


def do_cross(a, b, c, d):
    """Whether the segments a-b and c-d of a plane do."""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0. and side(c, d, a) * side(c, d, b) < 0.


def share_of_crossed_rows(scene, columns):
    """Of a hundred rows, in how many the middle lines of the leaves (y = 0) cut one another."""
    line, gap, rows = scene.info["line"], scene.info["gap"], len(columns["time"])
    chosen = range(0, rows, max(1, rows // 100))

    def leaf(name, height, row):
        return [(x + columns[f"probe_{name}{k}_ux"][row], height + columns[f"probe_{name}{k}_uz"][row]) for k, x in enumerate(line)]
    n_crossed = 0
    for row in chosen:
        upper, lower = leaf("upper", gap, row), leaf("lower", 0., row)
        n_crossed += any(do_cross(*upper[i:i + 2], *lower[j:j + 2]) for i in range(len(line) - 1) for j in range(len(line) - 1))
    return n_crossed / len(chosen)


def judge(scene, result):
    """Figures of the row, and faults."""
    columns, scale, faults = result.columns, result.initial_energy(), []
    if any(not math.isfinite(v) for values in columns.values() for v in values):
        return {}, ["a number of history.csv is not finite"]
    fall = result.largest_fall("contact_dissipated") / scale
    figures = {"taken": columns["contact_dissipated"][-1] / scale, "error": result["energy/max_relative_error"],
               "sum": energy_residual(result), "momentum": momentum_residual(result),
               "depth": result["contact/max_penetration_over_spacing"]}
    if fall > 1e-9:
        faults.append(f"contact_dissipated falls by {fall:.2g} E0")
    for name in strike.NOT_NEGATIVE:
        if result.least(name) < -NEGATIVE * scale:
            faults.append(f"{name} {result.least(name) / scale:.2g} E0")
    for name, limit in (("error", ENERGY), ("sum", ENERGY), ("momentum", MOMENTUM), ("depth", DEEP)):
        if not figures[name] < limit:
            faults.append(f"{name} {figures[name]:.2g} above {limit:g}")
    for name, energy in result["energy/error_origins"].items():
        if abs(energy) > ENERGY * scale:
            faults.append(f"made by {name}: {energy / scale:.2g} E0")
    if result.most("blade_kinetic") + result.least("bird_kinetic") > 1.01 * scale:
        faults.append(f"blade_kinetic {result.most('blade_kinetic') / scale:.3g} E0")
    if scene.info.get("fold"):
        figures["crossed"] = share_of_crossed_rows(scene, columns)
        if figures["crossed"] > 0.05:
            faults.append(f"leaves go through one another in {figures['crossed']:.2g} of the rows")
    judge_impulse(scene, result, figures, faults)
    return figures, faults


def judge_impulse(scene, result, figures, faults):
    """A plate in whose way the bird is gets m v, more by restitution: 5 % and what some hundred particles make of it from a rigid
    plate that stands; from an elastic or a free one up to as much again."""
    info = scene.info
    along = info.get("normal", (0., 0., 1.) if scene.kind != "edge" else [v / info["speed"] for v in info["velocity"]])
    brought = abs(sum(v * n for v, n in zip(info["velocity"], along))) * info["mass"]
    given = abs(sum(v * n for v, n in zip(result["contact/impulse"], along)))
    figures["impulse"] = given / brought
    if figures["impulse"] > (1.15 if scene.kind == "rigid" and not info.get("free") else 2.05):
        faults.append(f"impulse {figures['impulse']:.3g} m v")
    wide = scene.kind == "rigid" and not info.get("free") and float(scene.settings["Blade/Rigid/Length"]) > 10. * info["diameter"]
    if wide and info["end"] * info["speed"] > 1.19 * info["length"] and figures["impulse"] < 0.85:
        faults.append(f"impulse only {figures['impulse']:.3g} m v: particles pass the plate")


class Runs:
    def __init__(self, program, folder, limit):
        self.program, self.folder, self.limit = program, folder, limit

    def run(self, scene, name, *settings):
        path = scene.write(self.folder, name)
        result = strike.run(self.program, path, os.path.join(self.folder, name + ".run"), settings, self.limit)
        with open(os.path.join(self.folder, name + ".txt"), "w") as file:
            file.write(result.text)
        return result

    def compare(self, scene, first):
        """Threads, output interval, twin: faults and the twin's words."""
        faults, draw = [], random.Random(f"twin {scene.kind} {scene.seed}")
        threads = self.run(scene, "threads", "Time/Threads=2")
        if threads.code != first.code or threads.history_bytes != first.history_bytes:
            faults.append(f"two threads: exit {threads.code}, another history.csv")
        rows = self.run(scene, "interval", f"Output/History interval={scene.info['end'] / 7.3!r}")
        other = twins.summary_difference(first, rows) if rows.summary else [f"exit {rows.code}"]
        if other:
            faults.append("output interval: " + ", ".join(other))
        name, (twin, factor, tolerance) = twins.choose(scene, draw)
        second = self.run(twin, "twin")
        if second.code != 0:
            return faults + [f"twin {name}: exit {second.code}: {second.stop()}"], name
        more, largest = twins.difference(name, first, second, factor, tolerance)
        return faults + more, f"{name} {largest:.1g}"


def row(scene, first, figures, verdict, twin):
    info = scene.info
    words = [f"{scene.kind:6s} {scene.seed:<5d} {info['speed']:7.4g} m/s dx {1e3 * info['spacing']:.2g} mm {info['law'][:5]:5s}"]
    element = f"h/dx {info['element'] / info['spacing']:.2g} " if "element" in info else ""
    words.append(f"t/dx {info['thickness'] / info['spacing']:.2g} {element}E {info.get('young', math.inf):.1g} {info['formulation'][:9]}")
    words.append(" ".join(f"{name} {value:.2g}" for name, value in figures.items()))
    if first.summary:
        words.append(f"steps {first['steps/bird']}/{first['steps/blade']} twin {twin}")
    return " | ".join(words) + " | " + verdict


def judge_scene(program, kind, seed, limit, keep):
    """Prints the scene's row; 'passed', 'FAILED', 'stopped' or 'refused'."""
    scene = draws.draw_scene(kind, seed)
    folder = tempfile.mkdtemp()
    runs = Runs(program, folder, limit)
    first, figures, twin = runs.run(scene, "scene"), {}, ""
    if first.code == 0:
        figures, faults = judge(scene, first)
        more, twin = runs.compare(scene, first)
        faults += more
        verdict = "FAILED" if faults else "passed"
    else:
        faults = [f"exit {first.code}: {first.stop()}"]
        verdict = {2: "refused", 3: "stopped"}[first.code] if strike.has_words(first) else "FAILED"
    print(row(scene, first, figures, verdict + (": " + "; ".join(faults) if faults else ""), twin), flush=True)
    if keep and verdict != "passed":
        shutil.copytree(folder, os.path.join(keep, f"{kind}-{seed}"), dirs_exist_ok=True)
    shutil.rmtree(folder)
    return verdict


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, default=1, help="of the first scene; the next ones count on")
    parser.add_argument("--count", type=int, default=1)
    parser.add_argument("--only", choices=draws.KINDS, help="one kind of scene; otherwise they take turns")
    parser.add_argument("--keep", help="folder for the files of scenes that fail, stop or are refused")
    parser.add_argument("--limit", type=float, default=60., help="seconds a run may take")
    options = parser.parse_args()
    kinds, verdicts = [options.only] if options.only else list(draws.KINDS), []
    for seed in range(options.seed, options.seed + options.count):
        verdicts.append(judge_scene(os.path.abspath(options.program), kinds[seed % len(kinds)], seed, options.limit, options.keep))
    print(", ".join(f"{verdicts.count(v)} {v}" for v in ("passed", "FAILED", "stopped", "refused")))
    return 1 if "FAILED" in verdicts else 0


if __name__ == "__main__":
    sys.exit(main())
