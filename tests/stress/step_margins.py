#!/usr/bin/env python3
"""How far the time step may grow before a run breaks: step_margins.py PROGRAM [--quick] [--only TEXT]

For each scene the share of the stable step (Time/Step scale of the blade, Time/Bird step scale of bird and contact) is
raised from its default, by bisection, until the run ends with exit code 3, its energy error exceeds 1 %, or its answer
(impulse of contact, or peak of the tip) departs by 5 % from that of the default; entries go no further than they are
allowed to. Prints a table in Markdown. Exit code 1 where a default is itself beyond, or a margin is none.

--quick: two scenes, coarsely, so that this script is tested.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

PRM = pathlib.Path(__file__).resolve().parents[2] / "prm"
ENERGY_ERROR, DEPARTURE, RESOLUTION = 0.01, 0.05, 0.02

SOLID = ["Blade/Kind=solid", "Blade/Mesh/Layers=2"]
HELD = ["Blade/Supports/Held=0: ux"]  # two layers of held displacements hold a rotation
STRIP = ("blade-impulse", ["Time/End time=0.5e-3"])
DISC = ("rigid-plate", ["Bird/Particle spacing=0.004", "Time/End time=0.3e-3"])
COARSE = ["Bird/Particle spacing=0.005", "Time/End time=0.4e-3"]
BLADE, BIRD = "Time/Step scale", "Time/Bird step scale"

# name: (file, settings), entry
SCENES = {}
for kind in ("physical", "Belytschko-Tsay", "fully integrated"):
    SCENES[f"blade, {kind} shells"] = (STRIP[0], STRIP[1] + [f"Blade/Element/Formulation={kind}"], BLADE)
for kind in ("one point", "B-bar", "solid-shell"):
    SCENES[f"blade, {kind} bricks"] = (STRIP[0], STRIP[1] + SOLID + HELD + [f"Blade/Element/Formulation={kind}"], BLADE)
SCENES["bird, riemann"] = (DISC[0], DISC[1], BIRD)
SCENES["bird, riemann, linear"] = (DISC[0], DISC[1] + ["Bird/Reconstruction=linear"], BIRD)
SCENES["bird, standard"] = (DISC[0], DISC[1] + ["Bird/Formulation=standard"], BIRD)
for case, settings in {"quickstart": ["Time/End time=1e-3"], "frontal": COARSE, "oblique": COARSE,
                       "perforation": ["Bird/Particle spacing=0.004", "Time/End time=0.1e-3"]}.items():
    for multirate in ("true", "false") if case in ("quickstart", "frontal") else ("true",):
        for kind in ("shells", "bricks"):
            for entry, part in ((BLADE, "blade's step"), (BIRD, "bird's step")):
                SCENES[f"{case}, {kind}{'' if multirate == 'true' else ', one rate'}: {part}"] = (
                    case, settings + [f"Time/Multirate={multirate}"] + (SOLID if kind == "bricks" else []), entry)
QUICK = ["blade, physical shells", "bird, riemann"]


class Scene:
    def __init__(self, program, name, folder):
        self.program, self.name, self.folder = program, name, folder
        self.case, self.settings, self.entry = SCENES[name]

    def run(self, factor=None):
        """The summary, or why there is none."""
        command = [self.program, "run", str(PRM / f"{self.case}.prm"), "--force", "--output", self.folder]
        settings = self.settings + ["Output/Field interval=0", "Output/Blade fields=false", "Output/Bird fields=false",
                                    "Output/History interval=1e-4", "Output/Checkpoint/Wall interval=0"]
        for setting in settings + ([] if factor is None else [f"{self.entry}={factor}"]):
            command += ["--set", setting]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode == 0:
            return json.loads((pathlib.Path(self.folder) / "summary.json").read_text()), ""
        if done.returncode == 3:
            return None, "numerical failure"
        sys.exit(f"{' '.join(command)}\nends with {done.returncode}:\n{done.stdout[-2000:]}")

    def breaks(self, factor):
        """Why the run with this factor is no longer the run of the default, or nothing."""
        summary, why = self.run(factor)
        if why:
            return why
        return self.judge(summary)

    def judge(self, summary):
        error = summary["energy"]["max_relative_error"]
        if error > max(ENERGY_ERROR, 2.0 * self.default_error):
            return f"energy error {100 * error:.1f} %"
        change = max(abs(now / then - 1.0) for now, then in zip(answers(summary), self.default_answers) if then != 0.0)
        return f"answer off by {100 * change:.0f} %" if change > DEPARTURE else ""

    def sweep(self, resolution):
        """Default factor, largest stable one, what broke beyond it, what limited the steps by default."""
        default = 0.9 if self.entry == BLADE else 1.0
        summary, why = self.run()
        if why:
            return default, 0.0, why, ""
        self.default_error, self.default_answers = summary["energy"]["max_relative_error"], answers(summary)
        limiter = ", ".join(f"{each['reason'].split(',')[0]} {100 * each['steps'] / steps_of(summary):.0f} %"
                            for each in summary["steps"]["limited_by"][:2])
        if self.default_error > ENERGY_ERROR:
            return default, 0.0, f"energy error {100 * self.default_error:.1f} %", limiter
        # where the entries end: Step scale 1, Courant number 0.35 times Bird step scale 0.5 or 0.7
        good, bad = default, 1.0 if self.entry == BLADE else 2.0 if "Bird/Formulation=standard" in self.settings else 1.42
        why = self.breaks(bad)
        if not why:
            return default, bad, "", limiter
        while bad - good > resolution * default:
            middle = 0.5 * (good + bad)
            broken = self.breaks(middle)
            good, bad, why = (good, middle, broken) if broken else (middle, bad, why)
        return default, good, why, limiter


def steps_of(summary):
    return sum(each["steps"] for each in summary["steps"]["limited_by"])


def answers(summary):
    impulse = sum(x * x for x in summary["contact"]["impulse"]) ** 0.5
    return (impulse,) if impulse > 0.0 else (abs(summary["tip"]["peak"]),)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", default="", help="scenes whose name contains this")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    names = QUICK if options.quick else [name for name in SCENES if options.only in name]
    print("| scene | default | largest stable | margin | beyond | limits steps by default |\n|---|---|---|---|---|---|")
    n_without = 0
    with tempfile.TemporaryDirectory() as scratch:
        for name in names:
            default, largest, why, limiter = Scene(program, name, f"{scratch}/run").sweep(0.25 if options.quick else RESOLUTION)
            n_without += largest <= default
            print(f"| {name} | {default:g} | {'' if why else '≥ '}{largest:.2f} | {100 * (largest / default - 1):+.0f} % | "
                  f"{why or 'as far as the entry goes'} | {limiter} |", flush=True)
    if n_without:
        sys.exit(f"{n_without} without a margin")


if __name__ == "__main__":
    main()
