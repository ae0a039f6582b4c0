"""What a run leaves where the disk takes no more, and where the screen is closed:  python3 full_disk_test.py PROGRAM TOP

A limit to the size of a file stands for the full disk: the write that passes it fails in the same way (EFBIG for ENOSPC).
"""
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile

CASE = ["--set", "Bird/Particle spacing=7 mm", "--set", "Blade/Mesh/Elements along span=12", "--set", "Blade/Mesh/Elements along chord=4",
        "--set", "Time/End time=400e-6", "--set", "Output/Flush interval=0", "--set", "Output/History interval=1e-7", "--set", "Output/Field interval=1e-5"]


def run(program, top, folder, *more, limit=None, **streams):
    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        if limit:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    streams = streams or {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    return subprocess.run([program, "run", str(top / "prm/quickstart.prm"), "--output", str(folder), *CASE, *more], text=True,
                          preexec_fn=prepare, errors="replace", timeout=60, **streams)


def check_full_disk(program, top, scratch):
    stopped_by, without = set(), 0
    for checkpoint in (), ("--set", "Output/Checkpoint/At the end=false"):
        for limit in (8, 12, 16, 24, 32, 48, 64, 96, 128, 144, 192, 256):
            folder = scratch / f"full-{limit}-{len(checkpoint)}"
            answer = run(program, top, folder, *checkpoint, limit=limit * 1024)
            state = (folder / ".birdstrike").read_text()
            what = f"{limit} KiB {checkpoint}: exit code {answer.returncode}, state {state!r}\n{answer.stdout[-600:]}"
            assert answer.returncode in (0, 1), what
            assert not any(word in answer.stdout for word in ("HDF5-DIAG", "error occurred in line", "Internal error")), what
            assert (answer.returncode == 0) == (state == "done\n") == (folder / "summary.json").exists(), what
            assert not list(folder.rglob("*.part")), what
            without += "No checkpoint at t = " in answer.stdout and answer.returncode == 0
            if answer.returncode == 1:
                assert "Cannot write" in answer.stdout and state.startswith("failed"), what
                stopped_by.add(answer.stdout.split("Cannot write ")[-1].split(":")[0].split("/")[-1].split("_")[0])
    assert {"history.csv", "results.h5"} <= stopped_by, f"the limits hit only {stopped_by}"
    assert without > 0, "no run had room for its results alone: a checkpoint that fails must not end it"


def check_closed_screen(program, top, scratch):
    answer = subprocess.run(f'"{program}" run "{top}/prm/quickstart.prm" --set "Time/End time=20e-6" --output "{scratch}/closed" >&- 2>&-',
                            shell=True, timeout=60)
    assert answer.returncode == 0 and (scratch / "closed/.birdstrike").read_text() == "done\n", "words for the screen went into a file"
    if os.path.exists("/dev/full"):
        for verb in ("parameters",), ("columns",), ("validate", str(top / "prm/quickstart.prm")), ("explain", str(top / "prm/quickstart.prm")):
            with open("/dev/full", "w") as full:
                answer = subprocess.run([program, *verb], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
            assert answer.returncode == 1 and "Cannot write to standard output" in answer.stderr, (verb, answer)


def check_own_files_stay(program, top, scratch):
    folder = scratch / "own"
    assert run(program, top, folder).returncode == 0
    own = [folder / name for name in ("notes.vtu", "my.pvd", "fields/notes.vtu", "fields/blade_mine.vtu", "checkpoints/checkpoint_mine.h5", "notes.txt")]
    for file in own:
        file.parent.mkdir(exist_ok=True)
        file.write_text("mine")
    answer = run(program, top, folder, "--force")
    assert answer.returncode == 0, answer.stdout
    assert all(file.read_text() == "mine" for file in own)
    compare = [program, "compare", str(top / "prm/quickstart.prm"), *CASE, "--output", str(scratch / "compared")]
    subprocess.run(compare, check=True, stdout=subprocess.DEVNULL, timeout=60)
    own = [scratch / "compared" / name for name in ("experiment.csv", "drawing.svg")]
    for file in own:
        file.write_text("mine")
    (scratch / "compared/profiles.svg").write_text("of another comparison")
    subprocess.run(compare + ["--set", "Output/HDF5=false", "--force"], check=True, stdout=subprocess.DEVNULL, timeout=60)
    assert all(file.read_text() == "mine" for file in own)
    assert "of another" not in "".join(file.read_text() for file in (scratch / "compared").glob("profiles.svg"))


def main():
    program, top = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_full_disk, check_closed_screen, check_own_files_stay):
            check(program, top, pathlib.Path(folder))
            print(f"{check.__name__}: well")


if __name__ == "__main__":
    main()
