#!/usr/bin/env python3
"""`birdstrike static` and `birdstrike modes` from outside: a turning disc against its closed form, the Campbell diagram, a strike on a blade
that turns (threads, resumed, without a jump at its start) and what is refused. Usage: steady_test.py PROGRAM TOP"""

import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np

PROGRAM, TOP = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
sys.path += [os.path.join(TOP, "tests", "scenes"), os.path.join(TOP, "prm")]
import meshes  # noqa: E402

YOUNG, POISSON, DENSITY, SPEED = 113.8e9, 0.342, 4430., 1000.
INNER, OUTER = 0.04, 0.1
BAR = os.path.join(TOP, "tests", "data", "spinning-blade.prm")
FAST = ("Bird/Particle spacing=0.008", "Blade/Mesh/Elements along span=16", "Blade/Mesh/Elements along chord=6", "Time/End time=4e-4",
        "Output/Blade fields=false", "Output/Bird fields=false")


def call(*arguments, sets=(), code=0):
    settings = [word for entry in sets for word in ("--set", entry)]
    done = subprocess.run([PROGRAM, *arguments, *settings], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == code, (arguments, done.returncode, done.stdout[-2000:])
    return done.stdout


def write_disc(name, n_radius, n_round):
    points = [(r * math.cos(a), r * math.sin(a), 0.) for r in (INNER + (OUTER - INNER) * i / n_radius for i in range(n_radius + 1))
              for a in (2. * math.pi * k / n_round for k in range(n_round))]
    ring = [(i * n_round, k, (k + 1) % n_round) for i in range(n_radius) for k in range(n_round)]
    cells = [(first + k, first + k + n_round, first + following + n_round, first + following) for first, k, following in ring]
    sides = [(10, k, (k + 1) % n_round) for k in range(n_round)]
    meshes.Mesh(points, cells, sides).write(name)


def disc_displacement(r):
    """Plane stress, u(a) = 0 and no traction at b: u = C r + D/r - (1 - nu^2) rho w^2 r^3/(8 E)."""
    load = DENSITY * SPEED ** 2
    matrix = [[INNER, 1. / INNER], [YOUNG / (1. - POISSON), -YOUNG / (1. + POISSON) / OUTER ** 2]]
    right = [(1. - POISSON ** 2) * load * INNER ** 3 / (8. * YOUNG), (3. + POISSON) / 8. * load * OUTER ** 2]
    c, d = np.linalg.solve(matrix, right)
    return c * r + d / r - (1. - POISSON ** 2) * load * r ** 3 / (8. * YOUNG)


def judge_disc():
    """Within half a per cent on twelve elements over the radius, and to second order."""
    errors = []
    for n in (6, 12):
        write_disc("disc.msh", n, 8 * n)
        with open("disc.prm", "w") as file:
            file.write(f"""subsection Bird
  set Enabled = false
end
subsection Blade
  set Kind = shell
  set Probes = rim: {OUTER} 0 0
  subsection Mesh
    set Generator = file
    set File = disc.msh
  end
  subsection Thickness
    set Value = 0.002
  end
  subsection Material
    set Name = custom
    set Density = {DENSITY}
    set Young's modulus = {YOUNG}
    set Poisson's ratio = {POISSON}
    set Hardening = elastic
  end
  subsection Supports
    set Clamped = 10
    set Tip =
  end
  subsection Spin
    set Speed = {SPEED}
  end
end
""")
        call("static", "disc.prm", "--output", f"disc{n}")
        with open(f"disc{n}/static.json") as file:
            result = json.load(file)
        u = result["probes"]["rim"]["displacement"]
        errors.append(u[0] / disc_displacement(OUTER) - 1.)
        assert abs(u[1]) + abs(u[2]) < 1e-9 * u[0], u
        last = result["solve"]["residuals"]
        assert last[-1] < 1e-9 and last[-1] < 100. * last[-2] ** 2 + 1e-10, last  # quadratic
        assert os.path.exists(f"disc{n}/fields/blade_0000.vtu")
    assert abs(errors[1]) < 5e-3 and abs(errors[1]) < 0.35 * abs(errors[0]), errors


def judge_campbell():
    # MPI's folders are no part of it: such processes would share one, and take it from each other
    with_no_folder = subprocess.run([PROGRAM, "modes", BAR, "--output", "no-folder", "--number", "1"], capture_output=True, text=True,
                                    env=os.environ | {"TMPDIR": "/proc/none"})
    assert with_no_folder.returncode == 0, with_no_folder.stdout + with_no_folder.stderr
    text = call("modes", BAR, "--output", "modes", "--number", "4", "--speeds", "0:600:3")
    assert text.count("Modes at") == 3, text
    with open("modes/modes.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    assert len(rows) == 12
    first = [float(row["frequency"]) for row in rows if row["mode"] == "1"]
    assert first[0] < first[1] < first[2], first  # tension
    # Southwell: f^2 rises with the square of the speed, within some per cent
    assert abs((first[1] ** 2 - first[0] ** 2) / (first[2] ** 2 - first[0] ** 2) - 0.25) < 0.03, first
    assert abs(float(rows[-4]["engine_order"]) * 600. / (2. * math.pi) / first[2] - 1.) < 1e-4
    for name in ("campbell.csv", "figures.gp", "modes_1.pvd", "fields/modes_3_0000.vtu"):
        assert os.path.exists("modes/" + name), name


COARSE = ("Blade/Mesh/Elements along span=12", "Blade/Mesh/Elements along chord=4")


def first_frequency(folder):
    with open(folder + "/modes.csv") as file:
        return [float(row["frequency"]) for row in csv.DictReader(line for line in file if not line.startswith("#")) if row["mode"] == "1"]


def judge_rest_with_slice():
    """Of a blade at rest no other blade cuts the bird: it is none of statics' and modes' business, nor is any other entry of the bird."""
    spin = os.path.join(TOP, "prm", "fan-blade-spin.prm")
    text = call("modes", spin, "--output", "from-rest", "--number", "2", "--speeds", "0:600:3", sets=COARSE)
    assert text.count("Modes at") == 3 and "Warning" not in text, text
    first = first_frequency("from-rest")
    assert first[0] < first[1] < first[2], first
    assert abs((first[1] ** 2 - first[0] ** 2) / (first[2] ** 2 - first[0] ** 2) - 0.25) < 0.05, first  # Southwell
    call("modes", spin, "--output", "no-bird", "--number", "2", sets=COARSE + ("Blade/Spin/Speed=0", "Bird/Enabled=false"))
    assert first_frequency("no-bird")[0] == first[0], first
    for name in ("flock", "large-bird", "medium-bird"):
        case = os.path.join(TOP, "prm", "certification", name + ".prm")
        call("modes", case, "--output", "certified", "--number", "2", "--speeds", "0:600:2", sets=COARSE)
        text = call("static", case, sets=COARSE + ("Blade/Spin/Speed=0",), code=2)
        assert "Nothing loads the blade" in text and "bird" not in text.lower(), text
    pressed = COARSE + ("Blade/Spin/Speed=0", "Blade/Loads/Pressure=1e4")
    for entry in ("Bird/Particle spacing=1", "Bird/Slice/Number of blades=1", "Bird/Formulation=standard", "Bird/Strength/Yield stress=1e5",
                  "Bird/Slice/Between=1, 0", "Bird/Equation of state/Type=porous", "Bird/Velocity=0, 1, 0", "Bird 2/Enabled=true",
                  "Bird/Courant number=0.7", "Bird/Mass=1e9", "Bird/Periodic directions=x"):
        call("modes", spin, "--output", "odd-bird", "--number", "2", sets=COARSE + ("Blade/Spin/Speed=0", entry))
        assert first_frequency("odd-bird")[0] == first[0], entry
        call("static", spin, "--output", "odd-bird-static", sets=pressed + (entry,))
    text = call("validate", spin, sets=("Blade/Spin/Speed=0",), code=2)
    assert "no blade before it cuts the bird" in text, text  # a strike does need it


def judge_sides():
    """Deflections are positive with the bird: the same load has the other sign when the bird comes from the other side."""
    def tip(*entries):
        call("static", BAR, "--output", "side", sets=("Blade/Spin/Speed=0", "Blade/Loads/Pressure=1e3") + entries)
        with open("side/static.json") as file:
            return json.load(file)["tip"]["mid_chord"]
    there, back = tip("Bird/Velocity=0, 0, 100"), tip("Bird/Velocity=0, 0, -100")
    assert there == -back != 0., (there, back)
    assert tip("Bird/Velocity=0, 0, -100", "Bird/Particle spacing=1") == back  # whatever else is wrong with it
    text = call("static", BAR, "--output", "side", sets=("Blade/Spin/Speed=0", "Blade/Loads/Pressure=1e3", "Bird/Velocity=default",
                                                         "Bird/Speed=100"))
    assert "does not tell which side is struck" in text and "Angle to surface" in text, text


def history(run):
    with open(os.path.join(run, "history.csv")) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def judge_strike():
    call("run", BAR, "--output", "one", sets=FAST)
    call("run", BAR, "--output", "two", sets=FAST + ("Time/Threads=2",))
    assert open("one/history.csv").read() == open("two/history.csv").read()
    rows = history("one")
    assert max(abs(float(row["energy_error"])) for row in rows) < 5e-3  # 6.5 particles across the bird
    assert max(abs(float(row["angular_momentum_error"])) for row in rows) < 1e-4
    assert float(rows[-1]["contact_impulse_z"]) ** 2 + float(rows[-1]["contact_impulse_y"]) ** 2 > 0.1
    # the first rows are those of the static equilibrium: nothing rings before the bird is there
    call("run", BAR, "--output", "alone", sets=FAST + ("Bird/Enabled=false", "Output/History interval=0"))
    stored = [float(row["blade_elastic"]) for row in history("alone")]
    assert max(stored) - min(stored) < 1e-4 * stored[0], (min(stored), max(stored))
    kept = FAST + ("Output/Checkpoint/Step interval=50", "Output/Checkpoint/Keep=20")
    call("run", BAR, "--output", "kept", sets=kept)
    shutil.copytree("kept", "again")
    files = sorted(os.listdir("again/checkpoints"))
    assert len(files) > 2, files
    for name in files[1:]:
        os.remove(os.path.join("again/checkpoints", name))
    call("resume", "again")
    assert open("kept/history.csv").read() == open("again/history.csv").read()


def judge_refusals():
    for entry, words in (("Blade/Spin/Axis=0, 0, 0", "no length"), ("Blade/Supports/Driven=0: uz = t", "nodes follow the hub"),
                         ("Blade/Loads/Damping=1", "brake"), ("Blade/Supports/Held=1: uz", "no fixed direction"),
                         ("Blade/Kind=rigid", "does not turn"), ("Output/Histories/Stations=0.5", "turn")):
        text = call("validate", BAR, sets=(entry,), code=2)
        assert words in text, (entry, text)
    for speed in ("0, 0, 0", "0, 1, 0"):  # a slow bird: the scale of the balance is what the hub sees
        call("run", BAR, "--output", "slow", "--force", sets=FAST + (f"Bird/Velocity={speed}",), code=2 if speed == "0, 0, 0" else 0)
    call("run", BAR, "--output", "ringing", sets=FAST + ("Bird/Enabled=false", "Blade/Spin/Prestress=false"))
    assert max(float(row["blade_elastic"]) for row in history("ringing")) > 10. * float(history("ringing")[0]["blade_elastic"]) + 1.
    metal = ("Blade/Material/Hardening=curve", "Blade/Material/Hardening curve=0: 880e6; 0.02: 915e6; 0.1: 970e6")
    call("run", BAR, "--output", "curve", sets=FAST + metal)
    call("validate", "curve/parameters.prm")  # what is written reads back
    # trial steps beyond what the metal bears are taken back
    call("static", BAR, "--output", "brittle", sets=("Blade/Material/Failure=plastic strain", "Blade/Material/Failure strain=0.05",
                                                     "Blade/Spin/Speed=1500", "Blade/Material/Hardening=linear",
                                                     "Blade/Material/Hardening modulus=1.25e9"))
    text = call("modes", BAR, "--output", "half", sets=("Blade/Spin/Speed=0", "Case/Symmetry plane=y"), code=2)
    assert "half of its modes" in text or "symmetr" in text, text
    text = call("static", BAR, sets=("Blade/Spin/Speed=0",), code=2)
    assert "Nothing loads the blade" in text
    assert "none" in call("modes", BAR, sets=("Blade/Kind=none",), code=2)
    assert re.search("third of the unknowns", call("modes", BAR, "--number", "1000", sets=("Blade/Mesh/Elements along span=2",), code=2))


def main():
    os.chdir(tempfile.mkdtemp())
    judge_disc()
    judge_campbell()
    judge_rest_with_slice()
    judge_sides()
    judge_strike()
    judge_refusals()


main()
