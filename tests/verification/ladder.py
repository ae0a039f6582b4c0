#!/usr/bin/env python3
"""The verification ladder: every benchmark case as a row of tables/*.toml, run, judged and set out in one table.

    python3 tests/verification/ladder.py build/bin/birdstrike --size ci            # small scenes, as CTest does
    python3 tests/verification/ladder.py build/bin/birdstrike --output build/verification --update

The second runs everything at full size, unit tests included (their programs stand beside birdstrike), writes ladder.md, ladder.csv
and ladder.svg, and with --update puts table and figure into tests/verification. What a row of the tables may say stands in README.md.
Exit code 1 where a row misses whose table does not say so, or meets what its table calls a miss; 2 for tables that cannot be read.
"""

import argparse
import concurrent.futures
import glob
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tomllib

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
sys.path += [HERE, os.path.join(TOP, "tests", "scenes")]
import figures  # noqa: E402
import meshes  # noqa: E402
import report  # noqa: E402

QUIET = ("Time/Threads=1", "Output/Blade fields=false", "Output/Bird fields=false", "Output/HDF5=false", "Output/Checkpoint/At the end=false")
KEYS = {"case", "what", "scene", "value", "test", "property", "ctest", "reference", "tolerance", "low", "high", "at_most", "standing",
        "level", "why", "miss", "ci", "only", "not_covered"}
STANDINGS = {"exact", "published", "peer", "recalled", "bound", "seed"}


def read_tables():
    """Scenes by name, and rows in the order of the cases."""
    scenes, rows = {}, []
    for name in sorted(glob.glob(os.path.join(HERE, "tables", "*.toml"))):
        with open(name, "rb") as file:
            table = tomllib.load(file)
        scenes.update(table.get("scene", {}))
        for row in table["row"]:
            wrong = set(row) - KEYS
            if wrong or ("not_covered" not in row and (row.get("standing") not in STANDINGS or "why" not in row)):
                raise SystemExit(f"{name}: the row '{row.get('what')}' needs standing and why, and has {wrong or 'neither'}")
            rows.append(row)
    return scenes, sorted(rows, key=lambda row: (row["case"][0], int(row["case"][1:])))


def expected(row):
    """(reference, low, high) that the figure must lie within."""
    if "at_most" in row:
        return row["at_most"], -math.inf, row["at_most"]
    if "low" in row:
        return row.get("reference", 0.5 * (row["low"] + row["high"])), row["low"], row["high"]
    margin = row["tolerance"] * abs(row["reference"])
    return row["reference"], row["reference"] - margin, row["reference"] + margin


def run_scene(program, name, scene, size, folder):
    """Runs a scene in a folder of its own, unless it is there; returns what went wrong, or nothing."""
    if os.path.exists(os.path.join(folder, "run", "summary.json")):
        return ""
    os.makedirs(folder)
    prm = os.path.join(folder, os.path.basename(scene["file"]))
    shutil.copy(os.path.join(TOP, scene["file"]), prm)
    settings = [*QUIET, *scene.get("settings", []), *scene.get(size, [])]
    if "mesh" in scene:
        getattr(meshes, scene["mesh"])(*scene["mesh_arguments"]).write(os.path.join(folder, "mesh.msh"))
    command = [program, "run", prm, "--output", os.path.join(folder, "run")]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return "" if done.returncode == 0 else f"scene '{name}': {done.stdout.strip()[-400:]}"


def run_scenes(program, scenes, size, output, jobs):
    """All of them side by side; runs by name, and what could not be run."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        faults = {name: pool.submit(run_scene, program, name, scene, size, os.path.join(output, name))
                  for name, scene in scenes.items()}
    runs = {}
    for name in scenes:
        if not faults[name].result():
            runs[name] = figures.Run(os.path.join(output, name, "run"), runs)
    return runs, {name: fault.result() for name, fault in faults.items() if fault.result()}


def run_tests(folder, rows, output):
    """Properties and verdicts of unit tests by (program, test): {'property': value, 'passed': bool}."""
    found = {}
    for program in sorted({row["test"].split()[0] for row in rows if "test" in row}):
        names = sorted({row["test"].split()[1] for row in rows if row.get("test", "").startswith(program + " ")})
        file = os.path.join(output, program + ".json")
        if not os.path.exists(file):
            subprocess.run([os.path.join(folder, program), "--gtest_filter=" + ":".join(names), "--gtest_output=json:" + file],
                           stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT)
        with open(file) as json_file:
            suites = json.load(json_file)["testsuites"]
        for suite in suites:
            for test in suite["testsuite"]:
                found[f"{program} {suite['name']}.{test['name']}"] = {**test, "passed": "failures" not in test}
    return found


def run_ctests(folder, rows):
    names = sorted({row["ctest"] for row in rows if "ctest" in row})
    done = subprocess.run(["ctest", "--test-dir", os.path.dirname(folder), "-R", "^(" + "|".join(map(re.escape, names)) + ")$"],
                          stdout=subprocess.PIPE, text=True) if names else None
    return {name: bool(re.search(rf" {re.escape(name)} \.+ +Passed", done.stdout)) for name in names}


def judge(row, runs, tests, ctests):
    """Adds found, reference, low, high, verdict ('met', 'missed', 'passes', 'fails', 'not covered') to the row."""
    if "not_covered" in row:
        return {**row, "verdict": "not covered"}
    if "ctest" in row or ("test" in row and "property" not in row):
        passed = ctests[row["ctest"]] if "ctest" in row else tests.get(row["test"], {"passed": False})["passed"]
        return {**row, "verdict": "passes" if passed else "fails"}
    reference, low, high = expected(row)
    try:
        found = (runs[row["scene"]].value(row["value"]) if "scene" in row else float(tests[row["test"]][row["property"]]))
    except (KeyError, IndexError, ValueError, ZeroDivisionError, FileNotFoundError) as error:
        found = math.nan
        print(f"{row['case']} {row['what']}: no figure: {type(error).__name__} {error}")
    met = low <= found <= high
    return {**row, "found": found, "reference": reference, "low": low, "high": high, "verdict": "met" if met else "missed"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--size", choices=("ci", "full"), default="full")
    parser.add_argument("--cases", default="", help="only cases that begin with one of these, e.g. 'C F10'")
    parser.add_argument("--output", default="build/verification")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--reuse", action="store_true", help="judge what an earlier call has left in the output, run what is missing")
    arguments = parser.parse_args()
    program, folder = os.path.abspath(arguments.program), os.path.dirname(os.path.abspath(arguments.program))

    scenes, rows = read_tables()
    is_ci = arguments.size == "ci"
    wanted = tuple(arguments.cases.split())
    rows = [r for r in rows if not wanted or r["case"].startswith(wanted)]
    if is_ci:  # unit tests are tests already
        rows = [{**r, "miss": None, **r.get("ci", {})} for r in rows if "scene" in r and r.get("only") != "full"]
    needed = {r["scene"] for r in rows if "scene" in r}
    needed |= {other for r in rows for other in re.findall(r"run\('([^']+)'\)", r.get("value", ""))}
    output = os.path.abspath(arguments.output)
    if not arguments.reuse:
        shutil.rmtree(output, ignore_errors=True)
    os.makedirs(output, exist_ok=True)
    runs, faults = run_scenes(program, {n: s for n, s in scenes.items() if n in needed}, arguments.size, os.path.join(output, "runs"),
                              arguments.jobs)
    for fault in faults.values():
        print(fault)
    tests = run_tests(folder, rows, output)
    ctests = {} if is_ci else run_ctests(folder, rows)
    judged = [judge(row, runs, tests, ctests) for row in rows]
    surprises = [r for r in judged if (r["verdict"] in ("missed", "fails")) != bool(r.get("miss")) and r["verdict"] != "not covered"]
    report.write(judged, output)
    if arguments.update:
        report.update(judged, output, HERE)
    for row in judged:
        print(report.line(row))
    for row in surprises:
        print(f"NOT EXPECTED: {row['case']} {row['what']}: {row['verdict']}")
    return 1 if surprises else 0


if __name__ == "__main__":
    sys.exit(main())
