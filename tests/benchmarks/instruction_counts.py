#!/usr/bin/env python3
"""Instructions per unit of work of each inner loop, counted by callgrind, against tests/benchmarks/instruction_counts.json.

    python3 tests/benchmarks/instruction_counts.py [--build DIR] [--update]

Counts depend on source, compiler and C library, not on the machine's mood. Exit status: 0 all within 5 % or better,
1 a count grew by more than 5 %, 2 nothing could be counted, 77 not comparable here (no valgrind, no AVX2, another compiler).
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
EXPECTED = os.path.join(HERE, "instruction_counts.json")
TOLERANCE = 0.05
NOT_COMPARABLE = 77


class Failure(Exception):
    """What went wrong, in a few lines."""


class Skip(Exception):
    """Why nothing can be compared here."""


def run(command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    if done.returncode != 0:
        tail = "\n".join(done.stdout.strip().splitlines()[-15:])
        raise Failure(f"{tail}\nFailed ({done.returncode}): {' '.join(command)}")
    return done.stdout


def has_avx2():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        flags = set(re.search(r"^flags\s*:(.*)$", file.read(), re.MULTILINE).group(1).split())
    return {"avx2", "fma", "bmi2"} <= flags


def check_machine():
    if shutil.which("valgrind") is None:
        raise Skip("valgrind is not installed: apt-get install valgrind.")
    if not has_avx2():
        raise Skip("this processor has no AVX2, for which the counts were made.")


def build_program(folder, target="instruction_counts"):
    """Configures and builds a program of the loops for AVX2; returns it."""
    run(["cmake", "-S", TOP, "-B", folder, "-G", "Unix Makefiles", "-DCMAKE_BUILD_TYPE=Release", "-DBIRDSTRIKE_TESTS=OFF",
         "-DBIRDSTRIKE_NATIVE=OFF", "-DCMAKE_CXX_FLAGS=-march=x86-64-v3", "-DBIRDSTRIKE_INSTRUCTION_COUNTS=ON"])
    run(["cmake", "--build", folder, "--target", target, "--parallel", str(os.cpu_count())])
    return os.path.join(folder, "bin", target)


def count_all(program):
    """(what the program was made with, {name: instructions per unit})."""
    with tempfile.TemporaryDirectory() as folder:
        # one process: loading the libraries takes longer than all the loops
        dump = os.path.join(folder, "callgrind")
        report = run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={dump}", "--toggle-collect=count_instructions",
                      "--dump-after=count_instructions", program])
        made_with = re.search(r"^GCC .*$", report, re.MULTILINE).group(0)
        counted = {}
        for k, (name, units) in enumerate(re.findall(r"^(\w+) (\d+)$", report, re.MULTILINE)):
            with open(f"{dump}.{k + 1}", encoding="utf-8") as file:
                total = re.search(r"^totals: (\d+)$", file.read(), re.MULTILINE)
            if total is None or int(total.group(1)) == 0:
                raise Failure(f"callgrind counted nothing of {name}.")
            counted[name] = int(total.group(1)) / int(units)
    return made_with, counted


def judge(expected, counted):
    """Lines of the table and the names of counts that grew too much or have no expected value."""
    lines, bad = [], []
    width = max(map(len, counted))
    for name, now in counted.items():
        if name not in expected:
            lines.append(f"{name:<{width}}  {now:9.1f}  has no stored count")
            bad.append(name)
            continue
        ratio = now / expected[name]
        verdict = ""
        if ratio > 1.0 + TOLERANCE:
            verdict = f"  MORE than the stored {expected[name]:.1f} by over {TOLERANCE:.0%}"
            bad.append(name)
        elif ratio < 1.0 - TOLERANCE:
            verdict = "  fewer: store the new count with --update"
        lines.append(f"{name:<{width}}  {now:9.1f}  stored {expected[name]:9.1f}  {ratio:6.3f}{verdict}")
    for name in expected.keys() - counted.keys():
        lines.append(f"{name} is stored but is no longer counted")
        bad.append(name)
    return lines, bad


def read_expected(path):
    try:
        with open(path, encoding="utf-8") as file:
            stored = json.load(file)
        return stored["made_with"], {name: float(value) for name, value in stored["instructions_per_unit"].items()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise Failure(f"{path} cannot be read ({error}); make it anew with --update.") from error


def main():
    parser = argparse.ArgumentParser(description="Instructions per unit of work, against the stored counts.")
    parser.add_argument("--build", default=os.path.join(TOP, "build", "instruction_counts"), help="build folder")
    parser.add_argument("--expected", default=EXPECTED, help="file of stored counts")
    parser.add_argument("--update", action="store_true", help="store the counts of now")
    arguments = parser.parse_args()
    try:
        check_machine()
        made_with, counted = count_all(build_program(arguments.build))
        if arguments.update:
            rounded = {name: round(value, 1) for name, value in counted.items()}
            with open(arguments.expected, "w", encoding="utf-8") as file:
                json.dump({"made_with": made_with, "instructions_per_unit": rounded}, file, indent=2)
                file.write("\n")
            print(f"Stored {len(counted)} counts in {arguments.expected}")
            return 0
        stored_with, expected = read_expected(arguments.expected)
        lines, bad = judge(expected, counted)
    except Skip as reason:
        print(f"Not counted: {reason}")
        return NOT_COMPARABLE
    except Failure as error:
        print(error, file=sys.stderr)
        return 2
    print("\n".join(lines))
    if made_with != stored_with:
        print(f"Not comparable: stored with {stored_with}, counted with {made_with}.")
        return NOT_COMPARABLE
    if bad:
        print(f"Instructions per unit grew: {', '.join(bad)}. If that is meant, store the new counts and say why:\n"
              "    python3 tests/benchmarks/instruction_counts.py --update", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
