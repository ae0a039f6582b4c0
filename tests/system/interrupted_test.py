#!/usr/bin/env python3
"""Every command that computes ends with exit code 130 when SIGINT, SIGTERM or SIGHUP stops it, in words, and leaves what it says it leaves.
Usage: interrupted_test.py PROGRAM TOP"""

import glob
import os
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, TOP = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
STRIKE = os.path.join(TOP, "prm", "quickstart.prm")
BLADE = os.path.join(TOP, "tests", "data", "spinning-blade.prm")
LONG = ("--set", "Bird/Particle spacing=0.008", "--set", "Time/End time=10", "--set", "Time/Maximum wall time=60")
FINE = ("--set", "Blade/Mesh/Elements along span=300", "--set", "Blade/Mesh/Elements along chord=100")

# What runs, a file (or a pattern) that is there once it does, and words of its end.
COMMANDS = {
    "run": (("run", STRIKE, *LONG, "--output", "run"), "run/parameters.prm", "Continue with: birdstrike resume run"),
    "study": (("study", STRIKE, *LONG, "--vary", "Bird/Mass=0.1, 0.11", "--output", "study"), "study/Mass=0.1/parameters.prm",
              "Complete points will be reused"),
    "converge": (("converge", STRIKE, *LONG, "--vary", "step", "--output", "ladder"), "ladder/Step-scale=0.9-Bird-step-scale=1/parameters.prm",
                 "The ladder was stopped"),
    "compare": (("compare", STRIKE, *LONG, "--output", "compare"), "compare/quickstart/parameters.prm", "Complete cases will be reused"),
    "target": (("run", STRIKE, *LONG, "--target-error", "impulse = 5 %", "--output", "target"), "target/*/parameters.prm", "The climb was stopped"),
    "static": (("static", BLADE, *FINE, "--output", "static"), None, "Interrupted by a signal."),
    "modes": (("modes", BLADE, *FINE, "--output", "modes"), None, "Interrupted by a signal."),
    "explain": (("explain", STRIKE, "--set", "Bird/Particle spacing=0.0004"), None, "Interrupted by a signal."),
}


def is_listening(number):
    """Whether the program has been loaded and catches SIGTERM."""
    with open(f"/proc/{number}/status") as status:
        caught = next(line.split()[1] for line in status if line.startswith("SigCgt"))
    return int(caught, 16) >> (signal.SIGTERM - 1) & 1 == 1


def stop(arguments, is_running, number):
    process = subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    begin = time.monotonic()
    while time.monotonic() < begin + 60. and process.poll() is None:
        time.sleep(0.1)
        if is_listening(process.pid) and is_running():
            break
    assert process.poll() is None, (arguments, "ended before it was stopped", process.communicate()[0][-1000:])
    time.sleep(0.3)
    process.send_signal(number)
    return process.communicate(timeout=60)[0], process.returncode


def main():
    os.chdir(tempfile.mkdtemp())
    numbers = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
    for k, (name, (arguments, file, words)) in enumerate(COMMANDS.items()):
        number = signal.SIGTERM if name == "study" else numbers[k % 3]
        said, code = stop(arguments, lambda pattern=file: pattern is None or glob.glob(pattern), number)
        assert code == 130, (name, code, said[-1000:])
        assert words in said and "Internal error" not in said, (name, said[-1000:])
    # what was stopped is as it was said, and another signal ends it alike
    assert all(os.path.exists(f"study/Mass={mass}/summary.json") for mass in ("0.1", "0.11")), os.listdir("study")
    said, code = stop(COMMANDS["study"][0], lambda: not os.path.exists("study/Mass=0.11/summary.json"), signal.SIGHUP)
    assert code == 130 and "2 will continue from a checkpoint" in said, (code, said)


main()
