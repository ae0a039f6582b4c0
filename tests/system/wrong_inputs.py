"""What the program says to wrong input:  python3 wrong_inputs.py PROGRAM TOP [NAME...]

Every case of tests/data/wrong_inputs/cases.txt must be refused with exit code 2, in at most six lines, without a dump, within
ten seconds, in words that hold what the case expects.
"""
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

SECONDS = 10


def read_cases(path):
    """name -> list of (key, value)"""
    cases, lines = {}, None
    for line in path.read_text().splitlines():
        if match := re.fullmatch(r"\[(.*)\]", line):
            assert match[1] not in cases, f"two cases are called '{match[1]}'"
            lines = cases[match[1]] = []
        elif line and not line.startswith("#"):
            key, value = line.split(":", 1)
            assert key in ("set", "prm", "file", "args", "mesh", "says", "valid"), f"unknown key in '{line}'"
            lines.append((key, value.removeprefix(" ")))
    return cases


def unescape(text):
    return re.sub(r"\\(r|0|x[0-9A-F]{2})", lambda m: {"r": "\r", "0": "\0"}.get(m[1]) or chr(int(m[1][1:], 16)), text).encode("latin-1")


def judge(program, top, lines):
    """What is wrong with the answer; empty if nothing is."""
    def values(key):
        return [value.replace("TOP", str(top)) for k, value in lines if k == key]

    with tempfile.TemporaryDirectory() as folder:
        file = str(top / "prm/quickstart.prm")
        if values("file") or values("prm"):
            file = (values("file") or ["case.prm"])[0]
        if values("prm"):
            (pathlib.Path(folder) / file).write_bytes(b"\n".join(unescape(text) for text in values("prm")) + b"\n")
        command = values("args")[0].split() if values("args") else ["validate", file]
        if meshes := values("mesh"):
            (pathlib.Path(folder) / meshes[0]).write_text("\n".join(meshes[1:]) + "\n")
            command += ["--set", "Blade/Mesh/Generator=file", "--set", f"Blade/Mesh/File={meshes[0]}"]
        for setting in values("set"):
            command += ["--set", setting]
        try:
            answer = subprocess.run([program] + command, cwd=folder, timeout=SECONDS, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace")
        except subprocess.TimeoutExpired:
            return f"no answer within {SECONDS} s"
    said = "\n".join(line for line in answer.stdout.splitlines() if not line.startswith("Warning"))
    expected = 0 if values("valid") else 2
    faults = [f"exit code {answer.returncode}, not {expected}"] if answer.returncode != expected else []
    faults += [f"no \"{text}\"" for text in values("says") if text not in said]
    if expected == 2 and len(said.splitlines()) > 6:
        faults.append("more than six lines")
    if re.search("stacktrace|error occurred in line|terminate called|Internal error", said):
        faults.append("a dump")
    return "; ".join(faults) + (":\n" + said[:1500] if faults else "")


def main():
    program, top = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    cases = read_cases(top / "tests/data/wrong_inputs/cases.txt")
    chosen = sys.argv[3:] or list(cases)
    assert len(cases) >= 40, "the table is not read as expected"
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        answers = dict(zip(chosen, pool.map(lambda name: judge(program, top, cases[name]), chosen)))
    failed = {name: fault for name, fault in answers.items() if fault}
    for name, fault in failed.items():
        print(f"FAILED {name}: {fault}")
    print(f"{len(answers)} inputs, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
