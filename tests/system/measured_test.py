#!/usr/bin/env python3
"""`birdstrike compare RUN --measured` from outside: a run is held against its own curves, scaled, shifted and in other units, and what
cannot be compared is refused. Usage: measured_test.py PROGRAM TOP"""

import csv
import math
import os
import shutil
import subprocess
import sys
import tempfile

PROGRAM, TOP = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
sys.path.append(os.path.join(TOP, "source", "python"))
from birdstrike import Run  # noqa: E402

FAST = ("Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=14", "Blade/Mesh/Elements along chord=4", "Time/End time=1e-3",
        "Output/Field interval=0", "Output/Histories/Gauges=root: 0.02 0 0")


def call(*arguments):
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def compare(*arguments):
    done = call("compare", "run", "--measured", *arguments, "--output", "measured")
    if done.returncode != 0:
        return done.returncode, done.stdout, []
    with open("measured/ratings.csv") as file:
        rows = list(csv.DictReader(file))
    return 0, done.stdout, [{k: float(v) if k not in ("run", "column", "quantity", "unit") and v else v for k, v in row.items()}
                            for row in rows]


def near(a, b, tolerance):
    assert abs(a - b) <= tolerance, (a, b)


def compare_with_itself():
    columns = Run("run").columns
    with open("run/history.csv") as file:
        history = list(csv.DictReader(line for line in file if not line.startswith("#")))
    assert columns and len(history) > 100
    with open("test.csv", "w") as file:  # the tip 25 % larger, in mm over ms, 0.2 ms late; a spreadsheet's semicolons; a comment
        file.write("# rig 3\nT;sensor: tip;load cell\n[ms];[mm];[N]\n")
        for row in history:
            force = math.hypot(*(float(row["contact_impulse_" + axis]) for axis in "xyz"))
            file.write(f"{1e3 * float(row['time']) + 0.2!r};{1.25e3 * float(row['tip_mid_chord'])!r};{force!r}\n")
    code, text, (tip,) = compare("test.csv", "sensor: tip: tip", "--time-offset", "-0.2 ms")
    assert code == 0, text
    # rows are printed to all digits, only the milliseconds and the shift round
    near(tip["sprague_geers_magnitude"], -0.2, 1e-9)
    near(tip["sprague_geers_phase"], 0., 1e-6)
    near(tip["peak_ratio"], 0.8, 1e-9)
    assert tip["iso_phase"] == 1. and tip["unit"] == "m" and "Sprague" in text
    near(tip["iso_slope"], 1. - 0.2 / 2., 1e-6)
    near(tip["end"], 1e-3, 1e-9)
    compare_as_others_write_it(tip)
    _, _, (late,) = compare("test.csv", "sensor: tip: tip", "--time-offset", "0")
    assert late["iso_phase"] < 1. and late["sprague_geers_phase"] > 0.01, late
    near(late["begin"], 0.2e-3, 1e-9)
    _, _, (turned,) = compare("test.csv", "sensor: tip: -tip_mid_chord", "--time-offset", "-0.2 ms")
    near(turned["sprague_geers_phase"], 1., 1e-6)
    for name in ("measurement.svg", "measurement.csv", "ratings.csv", "figures.gp"):
        assert os.path.getsize("measured/" + name) > 100, name


def compare_as_others_write_it(tip):
    """The same table as a spreadsheet ("Unicode text", sep=) and a logger write it, units in round brackets."""
    with open("test.csv") as file:
        rows = file.read().split("\n", 3)[3]
    forms = (("utf-16", "T\tsensor: tip\tload cell\n[ms]\t[mm]\t[N]\n" + rows.replace(";", "\t")),
             ("utf-8-sig", "sep=;\nT (ms);sensor: tip (mm);load cell (N)\n" + rows),
             ("utf-8", "Logger 7\nOperator;Smith\nRate;100000\n\nT (ms);sensor: tip (mm);load cell (N)\n" + rows))
    for encoding, text in forms:
        with open("form.csv", "w", encoding=encoding, newline="\r\n") as file:
            file.write(text)
        code, said, found = compare("form.csv", "sensor: tip: tip", "--time-offset", "-0.2 ms")
        assert code == 0 and found == [tip], (encoding, said)


def compare_several():
    """Two quantities, a gauge and a profile; two runs."""
    run = Run("run")
    with open("gauge.csv", "w") as file:
        table = list(csv.reader(line for line in open("run/gauges.csv") if not line.startswith("#")))
        name = table[0][1]
        file.write("time,strain\n" + "".join(f"{row[0]},{row[1]}\n" for row in table[1:]))
    code, text, rows = compare("gauge.csv", "strain: gauges/" + name)
    assert code == 0, text
    assert rows[0]["iso_overall"] > 1. - 1e-9 and rows[0]["peak_ratio"] == 1., rows
    profile = run.profile("root_normal_stress_at_peak")
    with open("profile.csv", "w") as file:
        file.write("place [mm]\tstress [MPa]\n")
        dense = 4  # four places an element
        chord, stress = profile.axes["chord"], profile.values[0]
        for k in range(dense * (len(chord) - 1) + 1):
            e, s = min(k // dense, len(chord) - 2), k / dense - min(k // dense, len(chord) - 2)
            file.write(f"{1e3 * (chord[e] + s * (chord[e + 1] - chord[e]))!r}\t{2e-6 * (stress[e] + s * (stress[e + 1] - stress[e]))!r}\n")
    code, text, rows = compare("profile.csv", "stress: root profile")
    assert code == 0, text
    near(rows[0]["sprague_geers_magnitude"], -0.5, 1e-9)
    assert rows[0]["iso_overall"] == "" and rows[0]["unit"] == "Pa"
    with open("raw.csv", "w") as file:  # strains in um/m, which nothing says
        file.write("time,strain\n" + "".join(f"{row[0]},{1e6 * float(row[1])!r}\n" for row in table[1:]))
    code, text, _ = compare("raw.csv", "strain: gauges/" + name)
    assert code == 0 and "Is it in um/m?" in text, text
    code, text, _ = compare("gauge.csv", "strain: gauges/" + name)
    assert code == 0 and "Is it in" not in text, text
    code, text, _ = compare("gauge.csv", "strain: " + name)
    assert code == 2 and "gauges/" + name in text and "full name" in text, text
    code, text, _ = compare("gauge.csv", "strain: strain")
    assert code == 2 and "gauges/" + name in text, text
    code, text, _ = compare("gauge.csv", "strain: -gauges/" + name)
    assert code == 0 and f'"strain: gauges/{name}" turns' in text, text
    code, text, _ = compare("gauge.csv", "strain: gauges/" + name)
    assert code == 0 and "opposed" not in text, text
    compare_rig(table, name)
    shutil.copytree("run", "other")
    done = call("compare", "run", "other", "--measured", "test.csv", "load cell: -force", "sensor: tip: tip", "--time-offset", "-0.2 ms",
                "--output", "measured")
    assert done.returncode == 0, done.stdout
    with open("measured/ratings.csv") as file:
        assert [row["run"] for row in csv.DictReader(file)] == ["run", "other"] * 2


def compare_rig(table, name):
    """As a rig writes it: foreign columns, Greek units, gaps; the sign of the gauge turned."""
    for unit in ("\u00b5m/m", "\u03bcm/m", "um/m", "\u00b5\u03b5", "microstrain"):
        with open("rig.csv", "w", encoding="utf-8") as file:
            file.write(f"time,Trigger [V],g1 [{unit}],note,note\n")
            for k, row in enumerate(table[1:]):
                strain = "" if k in (3, 7) else repr(-1e6 * float(row[1]))
                file.write(f"{row[0]},{'' if k % 2 else 4.9},{strain},ok,\n")
        code, text, rows = compare("rig.csv", "g1: -gauges/" + name)
        assert code == 0 and f"2 of {len(table) - 1} rows have no 'time' or no 'g1'" in text, text
        near(rows[0]["peak_ratio"], 1., 1e-9)
    code, text, _ = compare("rig.csv", "g1: gauges/" + name)
    assert code == 0 and f'"g1: -gauges/{name}" turns' in text, text
    for column, words in (("Trigger", "'V' of column 'Trigger' is no unit"), ("note", "two columns are called 'note'")):
        code, text, _ = compare("rig.csv", column + ": gauges/" + name)
        assert code == 2 and words in text, text


def refuse():
    names = []

    def write(text):
        names.append(f"bad-{len(names)}.csv")
        with open(names[-1], "w") as file:
            file.write(text)
        return names[-1]

    rows = "".join(f"{k * 1e-5},{k}\n" for k in range(50))
    cases = (("no pair", [write("time,tip\n" + rows), "tip"], "column: quantity"),
             ("no pairs at all", ["test.csv"], "needs a file and pairs"),
             ("no file", ["absent.csv", "tip: tip"], "no such file"),
             ("unknown column", [write("time,tip\n" + rows), "tap: tip"], "no column 'tap'.*time, tip"),
             ("unknown quantity", [write("time,tip\n" + rows), "tip: tap"], "no column 'tap'.*history.csv"),
             ("another dimension", [write("time,tip [kN]\n" + rows), "tip: tip"], "in kN.*in m"),
             ("a length against a strain", [write("time,strain [mm]\n" + rows), "strain: gauges/root.strain"], "in mm.*in -"),
             ("no unit", [write("time,tip [furlong]\n" + rows), "tip: tip"], "line 1: 'furlong'.*no unit"),
             ("no unit below the names", [write("time,tip\ns,furlong\n" + rows), "tip: tip"], "line 2: 'furlong'.*no unit"),
             ("no unit in a comment", [write("# 1: time [s]\n# 2: tip [ell]\ntime,tip\n" + rows), "tip: tip"], "line 2: 'ell'.*no unit"),
             ("a word", [write("time,tip\n" + rows + "1,oops\n"), "tip: tip"], "line 52.*'oops'"),
             ("a missing field", [write("time,tip\n" + rows + "1\n"), "tip: tip"], "line 52: 1 fields"),
             ("decimal commas", [write("time;tip\n0;1\n0,1;2\n"), "tip: tip"], "decimal point"),
             ("time that falls", [write("time,tip\n" + rows + "0,1\n"), "tip: tip"], "does not rise"),
             ("a time twice", [write("time,tip\n0,1\n1e-5,2\n1e-5,3\n2e-5,4\n"), "tip: tip"], "line 4: 'time' does not rise.*of line 3"),
             ("a head twice", [write("time,tip\n" + rows + "time,tip\n" + rows), "tip: tip"], "line 52: 'time'.*no number"),
             ("a workbook", [write("PK\3\4\0\0"), "tip: tip"], "save the sheet"),
             ("a name twice", [write("time,tip,tip\n0,1,1\n"), "tip: tip"], "two columns"),
             ("no overlap", [write("time [s],tip\n" + "".join(f"{k + 1},{k}\n" for k in range(50))), "tip: tip"], "--time-offset"),
             ("all zero", [write("time,tip\n" + "".join(f"{k * 1e-5},0\n" for k in range(50))), "tip: tip"], "zero"),
             ("an open quotation mark", [write('time,"tip\n' + rows), "tip: tip"], "line 1: a quotation mark.*not closed"),
             ("a bad offset", [write("time,tip\n" + rows), "tip: tip", "--time-offset", "3 mm"], "no time"))
    for name, arguments, words in cases:
        code, text, _ = compare(*arguments)
        head, _, tail = words.partition(".*")
        assert code == 2 and head in text and tail in text and len(text.splitlines()) <= 6, (name, code, text)
    done = call("compare", TOP, "--measured", write("time,tip\n" + rows), "tip: tip", "--output", "measured")
    assert done.returncode == 2 and "no run in" in done.stdout, done.stdout
    for of_cases in (("--blade", "solid"), ("--set", "Bird/Mass=1")):
        code, text, _ = compare("test.csv", "sensor: tip: tip", *of_cases)
        assert code == 2 and of_cases[0] in text and "excludes" in text, text
    shutil.copytree("run", "sparse")
    with open("run/history.csv") as file:
        lines = file.readlines()
    first = next(k for k, line in enumerate(lines) if not line.startswith("#"))
    with open("sparse/history.csv", "w") as file:
        file.writelines(lines[:first + 2] + lines[-1:])
    done = call("compare", "sparse", "--measured", "test.csv", "sensor: tip: tip", "--output", "measured")
    assert done.returncode == 2 and "has fewer than 10 rows (1) from" in done.stdout, done.stdout


def read_what_spreadsheets_write():
    """Names with separators in quotation marks, empty rows, a unit for one column alone."""
    columns = [("time [ms]", "time", 1e3), ('"tip, mid ""chord"" [mm]"', "tip_mid_chord", 1e3)]
    with open("run/history.csv") as file:
        history = list(csv.DictReader(line for line in file if not line.startswith("#")))
    with open("sheet.csv", "w") as file:
        file.write('"# from DAQ, v2"\n' + ",".join(name for name, _, _ in columns) + "\n,\n")
        for row in history:
            file.write(",".join(f'"{factor * float(row[name])!r}"' for _, name, factor in columns) + "\n")
        file.write(',\n"",""\n')
    code, text, (tip,) = compare("sheet.csv", 'tip, mid "chord": tip')
    assert code == 0, text
    near(tip["peak_ratio"], 1., 1e-9)
    near(tip["iso_overall"], 1., 1e-6)
    with open("sheet.csv") as file:
        body = file.read().split("\n", 2)[2]
    with open("sheet.csv", "w") as file:  # a row of units that leaves out what the header says
        file.write("time,tip [mm]\n[ms],\n" + body)
    code, text, (tip,) = compare("sheet.csv", "tip: tip")
    assert code == 0, text
    near(tip["peak_ratio"], 1., 1e-9)


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    made = call("run", os.path.join(TOP, "prm", "quickstart.prm"), "--output", "run", *(w for s in FAST for w in ("--set", s)))
    assert made.returncode == 0, made.stdout
    compare_with_itself()
    compare_several()
    refuse()
    read_what_spreadsheets_write()
print("a run against its own curves, in other units and late; refusals in words")
