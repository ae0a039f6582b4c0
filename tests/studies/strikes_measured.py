"""The strikes of work_precision.py: how each is run, and its figures."""

import csv
import json
import math
import os
import resource
import shutil
import subprocess
import sys

import soft_body_pressure

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
QUIET = ("Time/Threads=1", "Output/Blade fields=false", "Output/Bird fields=false", "Output/HDF5=false", "Output/Checkpoint/At the end=false")

STRIKES = {"frontal": ("prm/frontal.prm", "Time/End time=0.016", "Time/Stop at tip peak=true"),
           "to rest": ("prm/frontal.prm", "Time/End time=0.06"),
           "leading edge": ("prm/oblique.prm", "Time/End time=0.9e-3")}
COARSE = "31x9/3"  # elements along span and chord, span grading: of the long run to rest where the bird is refined (nearly frontal-fast.prm's)

SAMPLES = [k * 0.02e-3 for k in range(1, 51)]  # s, of the history of the impulse

# By closed forms; of the pressure of the first touch the largest mean over 4 us on the middle fifth of the radius.
EXACT = {"rigid plate": {"Hugoniot pressure": 1., "stagnation pressure": 1.}}


def columns_of(folder):
    with open(os.path.join(folder, "history.csv")) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in ("time", "tip_mid_chord", "contact_impulse_z")}


def interpolate(times, values, t):
    for k in range(1, len(times)):
        if times[k] >= t:
            return values[k - 1] + (values[k] - values[k - 1]) * (t - times[k - 1]) / (times[k] - times[k - 1])
    return values[-1]


def permanent_deflection(times, tip):
    """Mean over the last whole period: between the last two crossings, upwards, of the mean since the largest deflection."""
    begin = max(range(len(tip)), key=lambda k: abs(tip[k]))
    middle = soft_body_pressure.mean(times, tip, times[begin], times[-1])
    crossings = [k for k in range(begin + 1, len(tip)) if tip[k - 1] < middle <= tip[k]]
    apart = [k for n, k in enumerate(crossings) if n == 0 or times[k] - times[crossings[n - 1]] > 5e-3]  # not its wiggles
    return soft_body_pressure.mean(times, tip, times[apart[-2]], times[apart[-1]]) if len(apart) > 1 else math.nan


def figures(strike, folder):
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    columns = columns_of(folder)
    if strike == "to rest":
        return {"permanent deflection": permanent_deflection(columns["time"], columns["tip_mid_chord"])}
    samples = " ".join(f"{interpolate(columns['time'], columns['contact_impulse_z'], t):.7g}" for t in SAMPLES)
    return {"tip peak": summary["tip"]["peak"], "impulse": math.hypot(*summary["contact"]["impulse"]), "impulse history": samples,
            "root moment": summary["root"]["peak_moment"], "plastic work": summary["plastic"]["work"]}


def run(program, folder, strike, level, settings):
    """Exit code and text."""
    spacing, mesh = level
    file, *entries = STRIKES[strike]
    counts, _, grading = mesh.partition("/")
    span, chord = counts.split("x")
    entries += [f"Bird/Particle spacing={spacing} mm", f"Blade/Mesh/Elements along span={span}", f"Blade/Mesh/Elements along chord={chord}",
                f"Blade/Mesh/Span grading={grading or 'default'}", *QUIET, *settings]
    command = [program, "run", "--force", os.path.join(TOP, file), "--output", folder]
    done = subprocess.run(command + [w for s in entries for w in ("--set", s)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def on_rigid_plate(program, folder, level, settings):
    """Over Hugoniot's and over the stagnation pressure. Half the bird, whose rows lie as the discs suppose, but of what has no half."""
    p_h, _, _ = soft_body_pressure.hugoniot()
    has_half = not {"Bird/Packing=fcc", "Bird/Formulation=standard"} & set(settings)
    whole = () if has_half else ("Case/Symmetry plane=none",)
    result = soft_body_pressure.run(program, folder, "cylinder", 1e-3 * float(level[0]), 0.31e-3, 2, (*whole, *settings))
    found = soft_body_pressure.figures_of("cylinder", result, p_h)
    return {"Hugoniot pressure": found["peak"], "stagnation pressure": found["stagnation"]}


def measure(program, folder, strike, level, settings):
    """State, processor seconds and figures."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    where, found, code, text = os.path.join(folder, "run"), {}, 0, ""
    shutil.rmtree(where, ignore_errors=True)
    if strike == "rigid plate":
        try:
            found = on_rigid_plate(program, where, level, settings)
        except SystemExit as failure:
            code, text = 3, str(failure)
    else:
        code, text = run(program, where, strike, level, settings)
        found = figures(strike, where) if code == 0 else {}
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if code != 0:
        print(f"{strike}, {level[0]} mm, {level[1]}, {'; '.join(settings)}: exit code {code}\n{text[-600:]}", file=sys.stderr)
    return {"state": "done" if code == 0 else f"exit code {code}", "cpu": f"{cpu:.2f}", **found}
