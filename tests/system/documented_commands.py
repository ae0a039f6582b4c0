#!/usr/bin/env python3
"""Every command that a document shows, run at a small size: READMEs, heads of shipped parameter files, examples of the program's help, and
commands that its messages advise. Usage: documented_commands.py PROGRAM TOP [--list] [TEXT]

Extraction is in shown_commands.py. A command of the program is run as it stands, with the reductions of SMALL and the names of PLACEHOLDERS
filled in. Scripts of hours are in ELSEWHERE, beside the test that runs them. What is in no list fails; so does an entry of a list that no document
shows. TEXT: only commands that hold it."""

import concurrent.futures
import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

from shown_commands import VERBS, commands_of_documents, commands_of_heads, commands_of_messages, examples_of_help, files_of_heads

PROGRAM, TOP = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
SECONDS = 600

# Sizes of a run of a tenth of a second. A file that needs others has them beside its name.
SMALL = ("Bird/Particle spacing=0.008", "Blade/Mesh/Elements along span=12", "Blade/Mesh/Elements along chord=4", "Time/End time=2e-5",
         "Output/Field interval=0")
SMALL_OF = {
    "prm/bird-free.prm": ("Bird/Particle spacing=0.012", "Time/End time=2e-5", "Output/Field interval=0"),
    "prm/rigid-plate.prm": ("Bird/Particle spacing=0.012", "Time/End time=2e-5", "Output/Field interval=0"),
    "prm/blade-impulse.prm": ("Blade/Mesh/Elements along span=12", "Time/End time=2e-5", "Output/Field interval=0"),
}
LONGER = ("Time/End time=3e-4", "Output/History interval=1e-6")  # runs that are held against a measurement
# Instead of what a document gives a run of hours.
SMALLER = {"Time/End time=20e-3": "Time/End time=3.2e-4", "Output/Field interval=1e-3": "Output/Field interval=0"}

# What stands for something of the reader's own. The first ones that match are replaced, in this order.
PLACEHOLDERS = (
    ("run FILE.prm [arguments]", "run prm/quickstart.prm"),
    ("prm/CASE.prm", "prm/quickstart.prm"),
    ("--finer N", "--finer 2"),
    ("[--number n] [--speeds a:b:n]", "--number 3 --speeds 0:300:2"),
    ("[B.prm ...] [--blade KIND,...]", "B.prm --blade shell,rigid"),
    (r"[--vary mesh\|particles\|both\|step\|points]", "--vary particles"),
    ("[--json]", "--json"),
    ("[FILE.prm]", "FILE.prm"),
    ("compare RUN ... --measured TEST.csv \"column: quantity\" ...", "compare runs/frontal runs/fine --measured test.csv \"load cell: force\""),
    ("\"Section/Entry=a:b:n\" ...", "\"Bird/Mass=0.1:0.12:2\""),
    ("Section/Entry=a:b:n", "Bird/Mass=0.1:0.12:2"),
    ("Section/Entry=VALUES", "Bird/Mass=0.1, 0.12"),
    ("Section/Entry=v1, v2", "Bird/Mass=0.1, 0.12"),
    ("Section/Entry=v1 | v2", "Bird/Aim point=0.15, 0, 0 | 0.2, 0, 0"),
    ("Section/Entry=value", "Bird/Mass=0.11"),
    ("--output DIR", "--output runs/somewhere"),
    ("srun -n 1", "env TASK=1"),
    ("resume RUN", "resume runs/stopped"),
    ("runs/own-blade/parameters.prm runs/own-blade-solid/parameters.prm", "runs/frontal/parameters.prm runs/fine/parameters.prm"),
    ("runs/a/parameters.prm runs/b/parameters.prm", "runs/frontal/parameters.prm runs/fine/parameters.prm"),
    ("my-blade.prm --mesh my-blade.msh", "own.prm --force --mesh meshes/own-blade-shell.msh"),
    ("A.prm", "prm/quickstart.prm"),
    ("B.prm", "prm/oblique.prm"),
)
FILE_OF_VERB = {"static": "prm/fan-blade-spin.prm", "modes": "prm/fan-blade-spin.prm"}

# Scripts that take minutes to hours, with the test, or the hand, that runs them.
ELSEWHERE = {
    r"bash tests/run\.sh( -R bird)?": "what runs this test",
    r"bash prm/manual/build\.sh": "system.manual",
    r"bash tests/stress/run\.sh \d+ 1": "stress.draws",
    r"bash tests/verification/run\.sh": "verification",
    r"bash tests/studies/(work_precision|error_bars|multirate)\.sh": "by hand",
    r"bash tests/benchmarks/run\.sh": "by hand",
    r"build/bin/benchmarks --benchmark_filter=bird": "by hand",
    r"build/bin/bird_tests --gtest_filter=Suite\.Name": "bird.*",
    r"cmake --preset sanitize && cmake --build --preset sanitize && ctest --preset sanitize": "by hand",
    r"cmake --build build --target loaded_once": "the build of all targets",
    r"python3 tests/benchmarks/compare\.py before\.json after\.json": "by hand",
    r"python3 tests/benchmarks/instruction_counts\.py( --update)?": "speed.instructions",
    r"gmsh (meshes/own-blade\.geo|blade\.(unv|bdf|step)) .*": "by hand: Gmsh is not installed for the tests",
    r"--benchmark_list_tests|--fail-above 1\.1|xvfb-run -a": "by hand",
    r"cmake -S \. -B build -DCMAKE_BUILD_TYPE=Release": "prm/run.sh",
    r"cmake --build build --parallel --target birdstrike": "prm/run.sh",
    r"cmake --install( build --prefix PREFIX)?": "by hand",
    r"(xvfb-run -a )?pvpython (prm/view\.py .*|\.\.\.)": "system.view",
}

# Options that a document shows alone, beside the command that takes them.
COMMAND_OF_OPTION = {"--set": "validate FILE.prm", "--vary": "converge FILE.prm", "--target-error": "run FILE.prm", "--blade": "compare FILE.prm",
                     "--launcher": "study FILE.prm --vary \"Bird/Mass=0.1, 0.12\"", "--task-list": "study FILE.prm --vary \"Bird/Mass=0.1, 0.12\"",
                     "--bird-order": "run FILE.prm --target-error \"impulse = 30 %\"", "--order": "converge FILE.prm",
                     "--places": "converge FILE.prm --vary step", "--finer": "converge FILE.prm --vary particles", "--output": "validate FILE.prm"}
# What a help text puts between quotes, beside the command in which it is tried.
COMMAND_OF_EXAMPLE = {
    "Section/Entry=value": "validate FILE.prm --set {}", "Section/Sub section/Entry=value": "validate FILE.prm --set {}",
    "tip peak = 2 %": "run FILE.prm --target-error {}", "0:900:4": "modes FILE.prm --number 2 --speeds {}",
    "0, 3000 rpm, 6000 rpm": "modes FILE.prm --number 2 --speeds {}", "Section/Entry=v1, v2": "study FILE.prm --vary {}",
    "Section/Entry=a:b:n": "study FILE.prm --vary {}", "Section/Entry=v1 | v2": "study FILE.prm --vary {}",
    "srun -n 1": "study FILE.prm --vary \"Bird/Mass=0.1, 0.12\" --launcher {}",
    "column: quantity": "compare runs/frontal --measured test.csv \"load cell: force\"",
    "COLUMN: QUANTITY": "compare runs/frontal --measured test.csv \"load cell: force\"",
    "4000 rpm": "new turning.prm --force --spin {}",
    "0.35 ms": "compare runs/frontal --measured test.csv \"load cell: force\" --time-offset {}",
}


def call(words, folder, shell=False):
    return subprocess.run(words, cwd=folder, shell=shell, text=True, errors="replace", timeout=SECONDS,
                          executable="/bin/bash" if shell else None, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)


def settings(entries):
    return [word for entry in entries for word in ("--set", entry)]


def small_of(file):
    return () if file.startswith("runs/") else SMALL_OF.get(file, SMALL)  # a run is as small as it is


def make_place(folder):
    """A folder with what a reader has: the shipped files, the program, runs of 'frontal', one of them stopped."""
    os.makedirs(os.path.join(folder, "build", "bin"))
    os.symlink(PROGRAM, os.path.join(folder, "build", "bin", "birdstrike"))
    for name in ("prm", "meshes", "tests"):
        os.symlink(os.path.join(TOP, name), os.path.join(folder, name))
    checkpoints = ("Output/Checkpoint/Step interval=1", "Output/Checkpoint/Keep=99")
    for name, more in (("frontal", LONGER), ("fine", LONGER + ("Bird/Mass=0.11",)), ("stopped", checkpoints)):
        done = call([PROGRAM, "run", "prm/frontal.prm", "--output", f"runs/{name}", *settings(SMALL + more)], folder)
        assert done.returncode == 0, done.stdout
    checkpoints = os.path.join(folder, "runs", "stopped", "checkpoints")
    for name in sorted(os.listdir(checkpoints))[2:]:
        os.remove(os.path.join(checkpoints, name))
    for name, of in (("a", "frontal"), ("b", "fine")):
        shutil.copytree(os.path.join(folder, "runs", of), os.path.join(folder, "runs", name))
    with open(os.path.join(folder, "test.csv"), "w") as table:
        table.write("time,load cell,tip sensor\n" + "".join(f"{k * 1e-6:g},{k % 7 * 1e3:g},{k * 1e-6:g}\n" for k in range(-650, 650)))


def fill_in(text, verb):
    for name, meaning in PLACEHOLDERS:
        text = text.replace(name, meaning)
    return re.sub(r"\b(FILE|CASE)\.prm", FILE_OF_VERB.get(verb, "prm/quickstart.prm"), text)


def run_program(text, folder):
    """Of the words behind 'birdstrike': what is wrong, empty if nothing is."""
    words = shlex.split(fill_in(text, text.split()[0]))
    if len(words) == 2 and words[1].startswith("--") and words[1] not in ("--json", "--force", "--help"):
        words = words[:1]  # or the verb and the name of an option, of which judge() knows whether there is one
    if len(words) == 1 and words[0] not in ("parameters", "columns"):
        words.append("--help")  # a document names the verb
    elif len(words) > 1 and words[1].startswith("--") and words[1] != "--help" and words[0] != "parameters":
        words.insert(1, "prm/quickstart.prm")  # or the verb and an option
    if "--order" in words and "--levels" not in words:
        words += ["--vary", "particles", "--levels", "4", "--ratio", "1.2"]  # fewer have no interval
    left = [word for word in words if re.search(r"\[|\]|^\.\.\.$|Section/Entry|FILE|CASE\.", word) and not word.startswith("[")]
    if left:
        return f"'{left[0]}' is no word of a command: put it into PLACEHOLDERS"
    words = [SMALLER.get(word, word) for word in words]
    files = [word for word in words if word.endswith(".prm") and not word.startswith("-")]
    sizes = settings(small_of(files[0])) if files and words[0] not in ("static", "modes", "columns", "resume", "new") else []
    if words[0] in ("static", "modes") and files:
        sizes = settings(SMALL[1:3])
    given = [word for word in words if "=" in word]
    own = {word.split("=")[0] for word in given}  # which the document gives itself
    sizes = [word for k in range(0, len(sizes), 2) if sizes[k + 1].split("=")[0] not in own for word in sizes[k:k + 2]]
    if words[0] == "resume" and "--set" not in words:
        shutil.copytree(os.path.join(folder, "runs", "stopped"), os.path.join(folder, "runs", "resumed"), dirs_exist_ok=True)
        words[1] = "runs/resumed"
    if words[0] == "run" and len(words) > 1 and "--force" not in words:
        words.append("--force")  # where another document has left a run
    done = call([PROGRAM, *words, *sizes], folder)
    # of a strike that has hardly begun nothing is claimed, in these words
    allowed = (0, 3) if "--target-error" in words and re.search("cannot be claimed|none is claimed", done.stdout) else (0,)
    return "" if done.returncode in allowed else f"exit code {done.returncode}:\n{done.stdout[-1500:]}"


def run_shell(text, folder):
    """Of the other tools that a document shows around the program."""
    if text == "parallel < tasks":
        text = "while read -r line; do bash -c \"$line\" || exit 1; done < tasks"
    elif match := re.fullmatch(r"sbatch --array=1-(\d+) --wrap '(.*)'", text):
        with open(os.path.join(folder, "tasks")) as tasks:
            n_tasks = len(tasks.readlines())
        if int(match[1]) != n_tasks:
            return f"{n_tasks} tasks, not {match[1]}"
        text = f"export SLURM_ARRAY_TASK_ID=1; {match[2]}"
    else:
        return "in no list of documented_commands.py"
    done = call(text, folder, shell=True)
    return "" if done.returncode == 0 else f"exit code {done.returncode}:\n{done.stdout[-1500:]}"


def judge_elsewhere(text):
    """Of a script that another test runs: that it is there, and is one."""
    for word in shlex.split(text):
        path = os.path.join(TOP, word)
        if word.endswith((".sh", ".py")) and not os.path.exists(path):
            return f"there is no {word}"
        if word.endswith(".sh") and subprocess.run(["bash", "-n", path]).returncode != 0:
            return f"{word} is no script"
    return ""


def judge(text, folder, helps):
    for pattern in ELSEWHERE:
        if re.fullmatch(pattern, text):
            return judge_elsewhere(text)
    text = re.sub(r"^bash prm/run\.sh", "birdstrike run", text)
    text = re.sub(r"^build/bin/birdstrike\b", "birdstrike", text)
    if text.startswith("--"):
        option = text.split()[0]
        if len(text.split()) == 1:
            return "" if option in helps else "no command has this option"
        if option not in COMMAND_OF_OPTION:
            return f"{option} is not in COMMAND_OF_OPTION"
        text = f"birdstrike {COMMAND_OF_OPTION[option]} {text}"
    if text == "birdstrike":
        return ""
    if text.split()[0] in VERBS:
        text = "birdstrike " + text
    return run_program(text.removeprefix("birdstrike "), folder) if text.startswith("birdstrike ") else run_shell(text, folder)


def judge_group(group, helps):
    """Commands that a document shows one after the other share a folder."""
    with tempfile.TemporaryDirectory() as place:
        folder = os.path.join(place, "here")
        shutil.copytree(judge_group.place, folder, symlinks=True)
        answers = []
        for text in group:
            begin = time.monotonic()
            try:
                answers.append((text, judge(text, folder, helps)))
            except subprocess.TimeoutExpired:
                answers.append((text, f"no end within {SECONDS} s"))
            fault = f"\nFAILED: {answers[-1][1]}" if answers[-1][1] else ""
            print(f"{time.monotonic() - begin:6.1f} s  {text}{fault}", flush=True)
        return answers


def example_commands():
    """Of every help text, with what is between quotes there in its command."""
    for verb in VERBS:
        for example in examples_of_help(PROGRAM, verb):
            command = COMMAND_OF_EXAMPLE.get(example, f"example {{}} of {verb} --help")
            yield command.format(shlex.quote(example))


def with_file(text, file):
    """A command of a file's head: its options are tried with the file."""
    return text.replace("--set", f"validate {file} --set", 1) if text.startswith("--set") else text


def collect_groups():
    groups = [group for document in ("README.md", "prm/README.md", "meshes/README.md", "tests/README.md", "source/README.md", "source/how-to-add.md",
                                                  *sorted(glob.glob("prm/manual/*.md", root_dir=TOP)), "tests/studies/README.md")
              for group in commands_of_documents(os.path.join(TOP, document))]
    groups += [[with_file(text, file)] for file in files_of_heads(TOP) for text in commands_of_heads(os.path.join(TOP, file))]
    groups += [[text] for text in example_commands()] + [[text] for text in commands_of_messages(TOP)]
    seen, unique = set(), []
    for group in groups:
        if tuple(group) not in seen:
            seen.add(tuple(group))
            unique.append(group)
    return unique


def find_stale(groups):
    shown = [text for group in groups for text in group]
    return [f"{pattern}: no document shows it" for pattern in ELSEWHERE if not any(re.fullmatch(pattern, text) for text in shown)]


def main():
    groups = collect_groups()
    if "--list" in sys.argv:
        print("\n".join(" ; ".join(group) for group in groups))
        return 0
    assert sum(map(len, groups)) > 80, "the documents are not read as expected"
    faults = find_stale(groups)
    if len(sys.argv) > 3:
        groups = [group for group in groups if any(sys.argv[3] in text for text in group)]
    helps = set(re.findall(r"--[a-z-]+", "".join(call([PROGRAM, verb, "--help"], ".").stdout for verb in VERBS)))
    with tempfile.TemporaryDirectory() as place:
        judge_group.place = place + "/place"
        os.makedirs(judge_group.place)
        make_place(judge_group.place)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for answers in pool.map(lambda group: judge_group(group, helps), groups):
                faults += [f"{text}: {fault}" for text, fault in answers if fault]
    for fault in faults:
        print("FAILED", fault.split("\n")[0])
    print(f"{sum(map(len, groups))} commands, {len(faults)} failed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
