#!/usr/bin/env python3
"""The pressure of a soft body on a rigid plate: in time at the middle and along the radius, for four shapes of one mass and speed,
against the closed forms that the method's paper starts from (equations 1 to 4):

    Hugoniot pressure   p_H = rho0 U_s v of the first touch, U_s = v rho1/(rho1 - rho0) from the liquid's law
    its end             R/c1, when the wave that lets go at the rim has come to the middle (c1 the speed of sound behind the shock)
    along the radius    p_H exp(-kappa r/R), kappa fitted to the largest pressure on each ring
    steady flow         rho0 v^2/2 at the middle
    duration            L/v

    python3 tests/studies/soft_body_pressure.py build/bin/birdstrike --output build/soft_body [--spacing 0.002]

prm/rigid-plate.prm, half of it (y = 0 is a plane of symmetry), some two minutes on two cores. Pressures are forces on discs about the middle, in rings their differences, over the
rings' areas, whose radii are chosen so that as many rows of particles stand in them as their area holds. What is called largest is the largest
mean over 4 us, in which the shock runs some three spacings. Short runs with finer and finer particles show what becomes of the first peak. Leaves soft_body.md, soft_body.csv and, with
gnuplot, soft_body.svg. Wilbeck's points (AFML-TR-77-134) are not drawn: no readable source had their numbers.
"""

import argparse
import concurrent.futures
import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MASS, DENSITY, SPEED, MODULUS, EXPONENT = 0.1005, 950., 177.4, 128e6, 7.98
SHAPES = {"cylinder": 2., "hemispherical cylinder": 2., "ellipsoid": 2., "sphere": 1.}  # length over diameter
SPACINGS = (0.004, 0.0028, 0.002, 0.0014, 0.001, 0.0007)
N_RINGS = 5
EARLY = 30e-6  # s, of the runs that refine the first peak
WIDTH = 4e-6  # s, of running means


def hugoniot():
    """p_H, U_s and the speed of sound behind the shock of Murnaghan's liquid: p(rho1) (1 - rho0/rho1) = rho0 v^2."""
    pressure = lambda x: MODULUS * (x ** EXPONENT - 1.)
    low, high = 1. + 1e-9, 3.
    for _ in range(200):
        x = 0.5 * (low + high)
        low, high = (x, high) if pressure(x) * (1. - 1. / x) < DENSITY * SPEED ** 2 else (low, x)
    return pressure(x), SPEED * x / (x - 1.), math.sqrt(MODULUS * EXPONENT * x ** (EXPONENT - 1.) / DENSITY)


def diameter(shape):
    """Of the shape's mass, m."""
    slender = SHAPES[shape]
    share = {"cylinder": math.pi / 4. * slender, "hemispherical cylinder": math.pi / 4. * (slender - 1.) + math.pi / 6.,
             "ellipsoid": math.pi / 6. * slender, "sphere": math.pi / 6.}[shape]
    return (MASS / (DENSITY * share)) ** (1. / 3.)


def snap(radius, spacing):
    """The radius near this one whose disc has the area of the rows of particles in it, four about its middle (a plane of symmetry lies
    between rows), and whose edge is
    between rows: rows that move a little do not change their number."""
    n = int(radius / spacing) + 4
    rows = sorted(math.hypot(i + 0.5, j + 0.5) for i in range(-n, n) for j in range(-n, n))
    fits = [math.sqrt(k / math.pi) for k in range(4, len(rows)) if 1.01 * rows[k - 1] < math.sqrt(k / math.pi) < 0.99 * rows[k]]
    return spacing * min(fits, key=lambda r: abs(r - radius / spacing))


def row_spacing(program, case, shape, spacing):
    """Across the axis, of the bird as packed, m: a cylinder's layers fill its length, in other shapes they are as far apart as rows. Of
    fcc, which has no such rows, that of as many cubes."""
    told = subprocess.run([program, "explain", *case], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    found = re.search(r"particles.* spacing ([0-9.]+) mm", told)
    if not found:
        raise SystemExit(f"{shape}, {spacing}: no spacing is explained:\n{told[-1000:]}")
    packed = 1e-3 * float(found.group(1))
    length = SHAPES[shape] * diameter(shape)
    return math.sqrt(packed ** 3 * round(length / spacing) / length) if shape == "cylinder" and "Bird/Packing=fcc" not in case else packed


def run(program, output, shape, spacing, end, n_rings=N_RINGS, settings=()):
    """Times and, ring by ring from the middle outwards, mean pressures of the steps; two rings are a disc in the middle and the rest. A run
    that is there is taken, whatever its further settings."""
    folder = os.path.join(output, f"{shape.replace(' ', '-')}-{1e3 * spacing:g}mm-{1e6 * end:.0f}us")
    bird = ("Case/Symmetry plane=y", f"Bird/Shape={shape}", f"Bird/Length over diameter={SHAPES[shape]}", f"Bird/Particle spacing={spacing}")
    case = [os.path.join(TOP, "prm", "rigid-plate.prm")] + [w for s in bird for w in ("--set", s)]
    apart = row_spacing(program, case + [w for s in settings for w in ("--set", s)], shape, spacing)
    radii = [0.] + [snap(0.5 * diameter(shape) * k / N_RINGS, apart) for k in range(1, n_rings)] + [0.5 * diameter(shape)]
    discs = "; ".join(f"disc{k}: 0 0 0 {radii[k]:.9g}" for k in range(1, n_rings + 1))
    settings = (f"Contact/Pressure patches={discs}", f"Time/End time={end}", "Time/Threads=1", "Output/History interval=0",
                "Output/Blade fields=false", "Output/Bird fields=false", "Output/HDF5=false", "Output/Checkpoint/At the end=false", *settings)
    if not os.path.exists(os.path.join(folder, "summary.json")):
        command = [program, "run", *case, "--output", folder]
        done = subprocess.run(command + [w for s in settings for w in ("--set", s)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True)
        if done.returncode != 0:
            raise SystemExit(f"{shape}, {spacing}: the run failed:\n{done.stdout[-1000:]}")
    with open(os.path.join(folder, "history.csv")) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    rings = []
    for k in range(1, n_rings + 1):  # the force on a disc less that on the next smaller one
        outer, inner = radii[k] ** 2, radii[k - 1] ** 2
        rings.append([(float(row[f"pressure_disc{k}"]) * outer - (float(row[f"pressure_disc{k - 1}"]) * inner if k > 1 else 0.)) / (outer - inner)
                      for row in rows])
    return {"time": [float(row["time"]) for row in rows], "rings": rings, "impulse": summary["contact"]["impulse"][2],
            "share": [r / radii[-1] for r in radii]}


def mean(time, values, begin, end):
    area = length = 0.
    for k in range(1, len(time)):
        if time[k - 1] >= begin and time[k] <= end:
            area += 0.5 * (values[k] + values[k - 1]) * (time[k] - time[k - 1])
            length += time[k] - time[k - 1]
    return area / length if length else math.nan


def running_mean(time, values, width):
    """Over `width` seconds about each time."""
    smooth, first, last = [], 0, 0
    for t in time:
        while time[first] < t - 0.5 * width:
            first += 1
        while last + 1 < len(time) and time[last + 1] <= t + 0.5 * width:
            last += 1
        smooth.append(mean(time, values, time[first], time[last]) if last > first else values[first])
    return smooth


def fit_decay(radii, pressures, p_h):
    """kappa of p = p_H exp(-kappa r/R), least squares of the logarithms over the rings' middles."""
    return -sum(r * math.log(p / p_h) for r, p in zip(radii, pressures)) / sum(r * r for r in radii)


def figures_of(shape, result, p_h):
    """What the closed forms are held against."""
    length = SHAPES[shape] * diameter(shape)
    duration, time, rings = length / SPEED, result["time"], result["rings"]
    middles = [0.5 * (a + b) for a, b in zip(result["share"], result["share"][1:])]
    smooth = [running_mean(time, ring, WIDTH) for ring in result["rings"]]
    peaks = [max(ring) for ring in smooth]
    steady = [mean(time, ring, 0.35 * duration, 0.65 * duration) for ring in rings]
    at = time[smooth[0].index(peaks[0])]
    areas = [b * b - a * a for a, b in zip(result["share"], result["share"][1:])]
    total = [sum(ring[k] * area for area, ring in zip(areas, rings)) for k in range(len(time))]
    impulse = [0.]
    for k in range(1, len(time)):
        impulse.append(impulse[-1] + 0.5 * (total[k] + total[k - 1]) * (time[k] - time[k - 1]))
    end = next(t for t, i in zip(time, impulse) if i >= 0.95 * impulse[-1])
    return {"shape": shape, "diameter": diameter(shape), "duration": duration, "peak": peaks[0] / p_h, "peak_at": at,
            "kappa": fit_decay(middles, peaks, p_h), "stagnation": steady[0] / (0.5 * DENSITY * SPEED ** 2), "peaks": peaks, "steady": steady, "share": result["share"], "middles": middles,
            "end": end, "impulse": result["impulse"] / (MASS * SPEED)}


def converge(program, output, jobs, p_h, c1, spacings=SPACINGS):
    """The first peak of the cylinder's flat face at the middle, spacing by spacing."""
    radius = 0.5 * diameter("cylinder")
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(lambda s: run(program, output, "cylinder", s, EARLY, 2), spacings))
    rows = []
    for spacing, result in zip(spacings, results):
        time, middle = result["time"], result["rings"][0]
        first = next((k for k in range(1, len(time)) if middle[k] >= 0.5 * p_h), 1)
        end = next((k for k in range(first, len(time)) if time[k] > 0.5 * radius / c1 and middle[k] < 0.5 * p_h), len(time) - 1)
        above = sum(b - a for a, b, p in zip(time, time[1:], middle[1:]) if p > 1.05 * p_h)
        rows.append({"spacing": spacing, "peak": max(middle) / p_h, "rise": time[first], "above": above,
                     "plateau": mean(time, middle, 0.35 * radius / c1, 0.8 * radius / c1) / p_h, "end": time[end] / (radius / c1)})
    return rows, results


def write_tables(output, rows, ladder, p_h, shock, c1):
    stagnation = 0.5 * DENSITY * SPEED ** 2
    with open(os.path.join(output, "soft_body.csv"), "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(("shape", "ring_begin_over_R", "ring_end_over_R", "largest_Pa", "steady_Pa"))
        for row in rows:
            for k in range(N_RINGS):
                table.writerow((row["shape"], row["share"][k], row["share"][k + 1], row["peaks"][k], row["steady"][k]))
    text = [f"Hugoniot {1e-6 * p_h:.1f} MPa (shock {shock:.0f} m/s, sound behind it {c1:.0f} m/s), stagnation {1e-6 * stagnation:.2f} MPa.", "",
            "| shape | diameter, mm | peak at the middle over p_H | at, us | kappa | steady over rho v^2/2 | L/v, us | 95 % of the impulse, us | impulse over m v |",
            "|---|---|---|---|---|---|---|---|---|"]
    text += [f"| {r['shape']} | {1e3 * r['diameter']:.1f} | {r['peak']:.2f} | {1e6 * r['peak_at']:.1f} | {r['kappa']:.2f} | {r['stagnation']:.2f} | "
             f"{1e6 * r['duration']:.0f} | {1e6 * r['end']:.0f} | {r['impulse']:.3f} |" for r in rows]
    text += ["", "| spacing, mm | peak over p_H | half of p_H reached, us | above 1.05 p_H for, us | mean from 0.35 to 0.8 R/c1 over p_H | falls below half of p_H, R/c1 |",
             "|---|---|---|---|---|---|"]
    text += [f"| {1e3 * r['spacing']:g} | {r['peak']:.2f} | {1e6 * r['rise']:.2f} | {1e6 * r['above']:.1f} | {r['plateau']:.3f} | {r['end']:.2f} |" for r in ladder]
    with open(os.path.join(output, "soft_body.md"), "w") as file:
        file.write("\n".join(text) + "\n")
    print("\n".join(text))


def data(columns):
    return "\n".join(" ".join(f"{x:.9g}" for x in row) for row in zip(*columns))


def draw(output, rows, results, ladder, early, p_h, c1):
    if not shutil.which("gnuplot"):
        print("gnuplot is not installed: no soft_body.svg")
        return
    radius, stagnation = 0.5 * diameter("cylinder"), 0.5 * DENSITY * SPEED ** 2
    colours = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
    script = ["set terminal svg size 1300,900 font 'sans,12' background '#ffffff'", f"set output '{output}/soft_body.svg'",
              "set multiplot layout 2,2", "set grid lc '#dddddd'", "set key top right"]
    for k, (row, result) in enumerate(zip(rows, results)):
        smooth = running_mean(result["time"], result["rings"][0], 10e-6)
        script += [f"$time{k} << EOD", data(([1e3 * t for t in result["time"]], [1e-6 * p for p in smooth])), "EOD"]
        script += [f"$radius{k} << EOD", data((row["middles"], [1e-6 * p for p in row["peaks"]],
                                              [1e-6 * p for p in row["steady"]])), "EOD"]
    for k, result in enumerate(early):
        script += [f"$early{k} << EOD", data(([1e6 * t for t in result["time"]], [1e-6 * p for p in result["rings"][0]])), "EOD"]
    script += ["$ladder << EOD", data(([1e3 * r["spacing"] for r in ladder], [r["peak"] for r in ladder], [r["plateau"] for r in ladder])), "EOD"]
    levels = f"{1e-6 * p_h} lc 'black' dt 2 title 'Hugoniot', {1e-6 * stagnation} lc 'black' dt 3 title 'stagnation'"
    end = 1e3 * rows[0]["duration"]
    script += ["set title 'Middle of the plate, mean over 0.2 R and 10 us'", "set logscale y", f"set yrange [1:{2e-5 * p_h}]", f"set xrange [0:{1.4 * end}]",
               "set xlabel 'time since first touch [ms]'", "set ylabel 'pressure [MPa]'",
               f"set arrow 1 from {end}, graph 0 to {end}, graph 1 nohead dt 4 lc '#808080'", f"set label 1 'L/v of the slender ones' at {0.98 * end}, graph 0.06 right",
               "plot " + ", ".join(f"$time{k} with lines lw 2 lc '{colours[k]}' title '{row['shape']}'" for k, row in enumerate(rows)) + ", " + levels,
               "unset arrow 1", "unset label 1"]
    script += ["set key bottom left", "set title 'Along the radius: largest on each ring (points), p_H exp(-k r/R) (lines), steady (crosses)' noenhanced", "set xrange [0:1]",
               "set xlabel 'r/R'", f"set yrange [1:{3e-6 * p_h}]", "plot " + ", ".join(
                   f"$radius{k} using 1:2 with points pt 7 ps 1 lc '{colours[k]}' notitle, {1e-6 * p_h}*exp(-{row['kappa']}*x) lw 1.5 lc '{colours[k]}' "
                   f"title '{row['shape']}, k = {row['kappa']:.2f}', $radius{k} using 1:3 with points pt 1 ps 1 lc '{colours[k]}' notitle"
                   for k, row in enumerate(rows)) + ", " + levels.replace("title 'Hugoniot'", "notitle").replace("title 'stagnation'", "notitle")]
    script += ["set key top right", "unset logscale y", "set title 'Flat face of the cylinder, mean over 0.2 R, by particle spacing'", f"set xrange [0:{1e6 * EARLY}]",
               f"set yrange [0:{1.8e-6 * p_h}]", "set xlabel 'time since first touch [us]'", "set ylabel 'pressure [MPa]'",
               f"set arrow 1 from {1e6 * radius / c1}, graph 0 to {1e6 * radius / c1}, graph 1 nohead dt 4 lc '#808080'",
               f"set label 1 'R/c_1' at {1e6 * radius / c1 + 0.4}, graph 0.05",
               "plot " + ", ".join(f"$early{k} with lines lw 1.5 lc '{colours[k]}' title '{1e3 * row['spacing']:g} mm'" for k, row in enumerate(ladder))
               + f", {1e-6 * p_h} lc 'black' dt 2 title 'Hugoniot'", "unset arrow 1", "unset label 1"]
    script += ["set title 'The same: peak and plateau against spacing'", "set xrange [0:4.2]", "set yrange [0.8:1.6]", "set xlabel 'particle spacing [mm]'",
               "set ylabel 'over the Hugoniot pressure'", "plot $ladder using 1:2 with linespoints pt 7 lw 2 lc '#D55E00' title 'first peak', "
               "$ladder using 1:3 with linespoints pt 7 lw 2 lc '#0072B2' title 'mean from 0.35 to 0.8 R/c_1', 1 lc 'black' dt 2 title 'exact'"]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--output", default="build/soft_body")
    parser.add_argument("--spacing", type=float, default=0.002)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    program, output = os.path.abspath(arguments.program), os.path.abspath(arguments.output)
    os.makedirs(output, exist_ok=True)
    p_h, shock, c1 = hugoniot()
    end = 1.5 * 2. * diameter("cylinder") / SPEED
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(lambda shape: run(program, output, shape, arguments.spacing, end), SHAPES))
    rows = [figures_of(shape, result, p_h) for shape, result in zip(SHAPES, results)]
    ladder, early = converge(program, output, arguments.jobs, p_h, c1)
    write_tables(output, rows, ladder, p_h, shock, c1)
    draw(output, rows, results, ladder, early, p_h, c1)


if __name__ == "__main__":
    sys.exit(main())
