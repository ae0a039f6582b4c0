"""Damaged input of every kind:  python3 fuzz.py PROGRAM TOP [--seconds 20] [--seed 1]

Takes shipped meshes, parameter files and a checkpoint, changes bytes, numbers or lines at random, and asks `validate` or `resume`
what it makes of them. Allowed: exit code 0, 2 or 3, and where it is not 0 a sentence without a dump; within 20 s and 4 GiB. What
fails is left in the folder ./fuzz-failures, with the seed of the round in its name.
"""
import argparse
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

SECONDS, BYTES = 20, 4 << 30
NUMBERS = [b"0", b"-1", b"1", b"nan", b"inf", b"1e308", b"1e-308", b"-2147483648", b"4294967295", b"4000000000",
           b"9223372036854775807", b"1e155", b"0.5", b"", b"x", b"7"]


def change(data, random):
    """One to three changes; what changes and where is drawn."""
    for _ in range(random.randint(1, 3)):
        kind = random.choice(("byte", "number", "number", "number", "line out", "line twice", "lines swapped", "cut"))
        lines = data.split(b"\n")
        k, j = random.randrange(len(lines)), random.randrange(len(lines))
        numbers = list(re.finditer(rb"-?\d[\d.eE+-]*", data)) if kind == "number" else []
        if kind == "byte" and data:
            at = random.randrange(len(data))
            data = data[:at] + bytes([random.randrange(256)]) + data[at + 1:]
        elif numbers:
            found = random.choice(numbers)
            data = data[:found.start()] + random.choice(NUMBERS) + data[found.end():]
        elif kind == "cut":
            data = data[:random.randrange(len(data) + 1)]
        elif kind in ("line out", "line twice"):
            data = b"\n".join(lines[:k] + (lines[k:k + 1] * 2 if kind == "line twice" else []) + lines[k + 1:])
        elif kind == "lines swapped":
            lines[k], lines[j] = lines[j], lines[k]
            data = b"\n".join(lines)
    return data


def ask(program, arguments, folder):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    try:
        answer = subprocess.run([program, *arguments], cwd=folder, preexec_fn=limit, timeout=SECONDS, text=True, errors="replace",
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired:
        return f"no answer within {SECONDS} s"
    said = answer.stdout
    if answer.returncode not in (0, 2, 3):
        return f"exit code {answer.returncode}: {said[-400:]}"
    if re.search("HDF5-DIAG|stacktrace|error occurred in line|terminate called|Internal error", said):
        return f"a dump: {said[:400]}"
    return "" if answer.returncode == 0 or said.strip() else "no word"


def prepare(program, top, folder):
    """name -> (path of what is changed, command)"""
    kinds = {}
    none = [argument for entry in ("Clamped", "Hub", "Tip", "Free") for argument in ("--set", f"Blade/Supports/{entry}=")]
    for mesh in sorted((top / "tests/data/gmsh").glob("*.*")) + sorted((top / "meshes").glob("*.msh")):
        if mesh.suffix in (".msh", ".inp", ".key", ".vtk"):
            is_solid = mesh.stem.startswith("body") or mesh.stem.endswith("x1")
            kinds[f"mesh {mesh.name}"] = (mesh, ["validate", str(top / "prm/quickstart.prm"), "--set", "Blade/Mesh/Generator=file", "--set",
                                                 "Blade/Mesh/File=changed" + mesh.suffix, "--set",
                                                 f"Blade/Kind={'solid' if is_solid else 'shell'}", *none])
    ucd = folder / "plate.inp"
    ucd.write_text("6 4 0 0 0\n" + "".join(f"{n + 1} {0.1 * (n % 3)} {0.09 * (n // 3)} 0\n" for n in range(6)) +
                   "1 5 quad 1 2 5 4\n2 5 quad 2 3 6 5\n3 1 line 1 4\n4 2 line 3 6\n")
    kinds["mesh ucd"] = (ucd, kinds["mesh plate.inp"][1])
    for case in sorted((top / "prm").glob("*.prm")):
        kinds[f"case {case.name}"] = (case, ["validate", "changed.prm"])
    subprocess.run([program, "run", str(top / "prm/quickstart.prm"), "--set", "Time/End time=2e-5", "--output", str(folder / "run")],
                   stdout=subprocess.DEVNULL, check=True)
    for checkpoint in (folder / "run/checkpoints").glob("*.h5"):
        kinds["checkpoint"] = (checkpoint, ["resume", "run", "--set", "Time/End time=3e-5"])
    assert len(kinds) > 20 and "checkpoint" in kinds, sorted(kinds)
    return kinds


def one_round(program, top, folder, kinds, seed):
    """What is wrong, empty if nothing, and the file that was changed."""
    draw = random.Random(seed)
    groups = sorted({name.split()[0] for name in kinds})
    group = draw.choices(groups, [{"mesh": 12, "case": 4, "checkpoint": 1}[name] for name in groups])[0]
    name = draw.choice([name for name in sorted(kinds) if name.startswith(group)])
    original, command = kinds[name]
    data = original.read_bytes()
    changed = change(data, draw)
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        place = pathlib.Path(scratch) / ("changed" + original.suffix)
        if name == "checkpoint":
            shutil.copytree(folder / "run", pathlib.Path(scratch) / "run")
            place = pathlib.Path(scratch) / "run/checkpoints" / original.name
        place.write_bytes(changed)
        fault = ask(program, command, scratch)
    return name, fault, changed, original.suffix


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("top", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    program, top = str(arguments.program.resolve()), arguments.top.resolve()
    n_failed, n, start = 0, 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        kinds = prepare(program, top, pathlib.Path(folder))
        while time.monotonic() - start < arguments.seconds:
            seed = arguments.seed * 1000000 + n
            name, fault, changed, suffix = one_round(program, top, pathlib.Path(folder), kinds, seed)
            n += 1
            if fault:
                n_failed += 1
                kept = pathlib.Path("fuzz-failures")
                kept.mkdir(exist_ok=True)
                (kept / f"{seed}{suffix}").write_bytes(changed)
                print(f"FAILED {seed}, {name}: {fault}", flush=True)
    print(f"{n} inputs, {n_failed} failed")
    return 1 if n_failed or n < 10 else 0


if __name__ == "__main__":
    sys.exit(main())
