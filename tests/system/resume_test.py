"""Checkpoints from outside: a run that is killed, stopped or told to go on ends as if nothing had happened.

resume_test.py PROGRAM SOURCE_FOLDER"""

import json
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
COARSE = ["Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=20", "Blade/Mesh/Elements along chord=6",
          "Output/Field interval=1e-4"]
BY_STEPS = ["Output/Checkpoint/Step interval=40", "Output/Checkpoint/Keep=3"]
SIGNALS = {signal.SIGINT: 130, signal.SIGTERM: 130, signal.SIGHUP: 130}


def sets(entries):
    return [word for entry in entries for word in ("--set", entry)]


def checkpoints(run):
    return sorted((run / "checkpoints").glob("checkpoint_*.h5"))


class Resume(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def program(self, *words, expect=0):
        done = subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, expect, f"{words}\n{done.stdout}")
        return done.stdout

    def start(self, case, name, entries):
        return subprocess.Popen([PROGRAM, "run", TOP / "prm" / f"{case}.prm", "--output", name, *sets(entries)], cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def wait_for(self, is_true, process):
        for _ in range(3000):
            if is_true():
                return
            if process.poll() is not None:
                self.fail("the run was over before the test could act")
            time.sleep(0.01)
        self.fail("nothing happened within 30 s")

    def same(self, name, other):
        """All that the runs have left but the clock's: costs, and the date in lists of files."""
        one, two = self.folder / name, self.folder / other
        for table in sorted(one.glob("*.csv")):
            self.assertEqual(table.read_bytes(), (two / table.name).read_bytes(), table.name)
        fields = sorted(file.name for file in (one / "fields").iterdir())
        self.assertEqual(fields, sorted(file.name for file in (two / "fields").iterdir()))
        for field in fields:
            self.assertEqual((one / "fields" / field).read_bytes(), (two / "fields" / field).read_bytes(), field)
        for listed in one.glob("*.pvd"):
            self.assertEqual(*(re.sub("<!--.*?-->", "", (run / listed.name).read_text(), flags=re.DOTALL) for run in (one, two)))
        with h5py.File(one / "results.h5") as a, h5py.File(two / "results.h5") as b:
            names = [], []
            a.visit(names[0].append)
            b.visit(names[1].append)
            self.assertEqual(*names)
            for path in names[0]:
                if isinstance(a[path], h5py.Dataset):
                    self.assertEqual(a[path][()].tobytes(), b[path][()].tobytes(), path)
        summaries = [json.loads((run / "summary.json").read_text()) for run in (one, two)]
        for summary in summaries:
            summary.pop("cost")
            for work in summary["skipped"].values():
                work.pop("saved")
        self.assertEqual(*summaries)

    def test_a_run_that_goes_on_in_other_steps_says_so_and_is_not_taken_for_another(self):
        entries = [*COARSE, "Time/Threads=1", "Output/Checkpoint/At the end=true"]
        short, steps = ["Time/End time=0.1e-3"], ["Time/End time=0.11e-3", "Time/Step scale=0.2"]
        quickstart = TOP / "prm" / "quickstart.prm"
        self.program("run", quickstart, "--output", "runs/quickstart", *sets([*entries, *short]))
        self.program("resume", "runs/quickstart", *sets(steps))
        for end in ("0.12e-3", "0.13e-3"):  # also after it has gone on once more, in the same steps
            summary = json.loads((self.folder / "runs" / "quickstart" / "summary.json").read_text())
            said = [warning["text"] for warning in summary["warnings"] if warning["code"] == "run/other_steps"]
            self.assertEqual(len(said), 1)
            self.assertRegex(said[0], r"Time/Step scale from 0.9 to 0.2 at 0?\.?1")
            self.program("resume", "runs/quickstart", *sets([f"Time/End time={end}"]))
        said = self.program("compare", quickstart, *sets([*entries, "Time/End time=0.13e-3", "Time/Step scale=0.2"]), "--output", "compared")
        self.assertIn("it was resumed with other time steps", said)

    def test_a_run_that_is_killed_loses_an_interval_and_no_digit(self):
        entries = [*COARSE, "Time/End time=1e-3", "Time/Threads=1"]
        self.program("run", TOP / "prm" / "quickstart.prm", "--output", "whole", *sets(entries))
        draw = random.Random(3)
        for kill in range(3):
            name = f"killed {kill}"
            run = self.folder / name
            at = draw.randrange(1, 6)  # checkpoints written
            process = self.start("quickstart", name, [*entries, *BY_STEPS])
            self.wait_for(lambda: checkpoints(run) and checkpoints(run)[-1].name >= f"checkpoint_{40 * at:012}", process)
            process.kill()
            process.wait()
            self.assertFalse((run / "summary.json").exists())
            self.assertGreater(len((run / "history.csv").read_text().splitlines()), 20, "rows as of the checkpoint can be read")
            newest = checkpoints(run)[-1]
            said = self.program("resume", name, *sets(["Time/Threads=2", "Time/Force threads=true"]))
            self.assertIn(newest.name, said)
            self.same("whole", name)

    def test_other_parts_go_on_to_the_last_bit(self):
        """With the flags that the tests of the archive try in memory: here through a file."""
        histories = ["Output/Histories/Nodes=tip: 0.3112 0 0", "Output/Histories/Gauges=g: 0.02 0 0",
                     "Output/Histories/Elements=e: 0.02 0 0 | 1", "Output/Histories/Stations=0.1, 0.5",
                     "Output/Histories/Patches=p: 0.2 0 0 0.05"]
        cases = {"oblique": [*COARSE, *histories, "Output/Removed particles=fly on", "Time/End time=1e-3"],
                 "fan-blade": ["Bird/Particle spacing=0.012", "Time/End time=3e-4", "Blade/Kind=solid", "Output/Field interval=1e-4"],
                 "perforation": ["Bird/Particle spacing=0.006", "Blade/Mesh/Elements along span=20",
                                 "Blade/Mesh/Elements along chord=20", "Bird/Velocity=0, 0, 400", "Time/End time=3e-4",
                                 "Output/Field interval=1e-4"],
                 "rigid-plate": ["Bird/Particle spacing=0.006", "Time/End time=2e-4"],
                 "frontal": [*COARSE, "Time/End time=3e-4", "Bird/Equation of state/Type=porous", "Bird/Strength/Yield stress=1 MPa",
                             "Bird/Strength/Shear modulus=100 MPa"]}
        for case, entries in cases.items():
            with self.subTest(case):
                self.program("run", TOP / "prm" / f"{case}.prm", "--output", f"{case} whole", *sets(entries))
                self.program("run", TOP / "prm" / f"{case}.prm", "--output", case, *sets([*entries, *BY_STEPS]))
                files = checkpoints(self.folder / case)
                self.assertEqual(len(files), 3)
                for file in files[1:]:
                    file.unlink()  # the oldest that is left: the run goes over its own end once more
                self.program("resume", case)
                self.same(f"{case} whole", case)

    def test_signals(self):
        entries = [*COARSE, "Time/End time=1.5e-3", "Time/Threads=1"]
        self.program("run", TOP / "prm" / "quickstart.prm", "--output", "whole", *sets(entries))
        for stop, code in SIGNALS.items():
            with self.subTest(stop.name):
                run = self.folder / stop.name
                process = self.start("quickstart", stop.name, entries)
                self.wait_for(lambda: (run / "fields" / "blade_0001.vtu").exists(), process)
                process.send_signal(stop)
                self.assertEqual(process.wait(), code)
                self.assertEqual(len(checkpoints(run)), 1, "without any interval")
                self.program("resume", stop.name)
                self.same("whole", stop.name)
        process = self.start("quickstart", "usr1", entries)
        self.wait_for(lambda: (self.folder / "usr1" / "fields" / "blade_0001.vtu").exists(), process)
        process.send_signal(signal.SIGUSR1)
        self.assertEqual(process.wait(), 0, "it goes on")
        self.assertEqual(len(checkpoints(self.folder / "usr1")), 2, "the one asked for and that of the end")
        self.same("whole", "usr1")

    def finished(self, *entries):
        self.program("run", TOP / "prm" / "quickstart.prm", "--output", "run",
                     *sets([*COARSE, "Time/End time=2e-4", *BY_STEPS, *entries]))
        return self.folder / "run"

    def test_damaged_files_are_passed_over(self):
        run = self.finished()
        files = checkpoints(run)
        newest = files[-1].read_bytes()
        for damage, said in ((newest[:len(newest) // 2], "is cut off"), (newest[:5000] + b"?" + newest[5001:], "is damaged"),
                             (b"", "is no checkpoint"), (newest.replace(b"checkpoint 4,", b"checkpoint 7,"), "is of format 7")):
            files[-1].write_bytes(damage)
            text = self.program("resume", "run")
            self.assertIn(said, text)
            self.assertIn(f"Continuing from run/checkpoints/{files[-2].name}", text)
        for file in checkpoints(run):
            file.write_bytes(b"foreign")
        text = self.program("resume", "run", expect=2)
        self.assertIn("holds no checkpoint that can be read", text)

    def test_what_may_change_and_what_not(self):
        run = self.finished()
        end = checkpoints(run)[-1]
        before = {file: file.read_bytes() for file in run.rglob("*") if file.is_file() and file.name not in ("log.txt", ".birdstrike")}
        self.assertIn("has reached its end", self.program("resume", "run", expect=2))
        text = self.program("resume", "run", *sets(["Blade/Material/Yield stress=1e9", "Time/End time=3e-4"]), expect=2)
        self.assertIn("Blade/Material/Yield stress", text)
        for file, content in before.items():
            self.assertEqual(file.read_bytes(), content, f"{file.name}: a refusal leaves a finished run as it is")
        self.assertEqual((run / ".birdstrike").read_text(), "done\n")
        text = self.program("resume", "run", *sets(["Time/End time=3e-4", "Output/History interval=2e-6"]))
        self.assertIn(end.name, text)
        times = [float(line.split(",")[0]) for line in (run / "history.csv").read_text().splitlines() if line[0].isdigit()]
        self.assertGreater(times[-1], 2.99e-4)
        late = [time for time in times if time > 2.05e-4]
        self.assertGreater(len(late), 40, "rows at the new interval")
        self.assertEqual(times, sorted(set(times)))

    def test_a_finished_run_is_not_replaced_unless_asked(self):
        run = self.finished()
        before = (run / "summary.json").read_bytes()
        again = ["run", TOP / "prm" / "quickstart.prm", "--output", "run", *sets([*COARSE, "Time/End time=1e-4"])]
        self.assertIn("--force to replace it", self.program(*again, expect=2))
        self.assertEqual((run / "summary.json").read_bytes(), before)
        self.program(*again, "--force")
        self.assertEqual(json.loads((run / "summary.json").read_text())["end"]["time"], 1e-4)
        self.assertEqual(len(checkpoints(run)), 1, "those of the run before are gone")

    def test_refusals(self):
        self.assertIn("is no folder of a run", self.program("resume", "nowhere", expect=2))
        self.assertIn("RUN", self.program("resume", expect=2))
        run = self.finished("Output/Checkpoint/At the end=false", "Output/Checkpoint/Step interval=0")
        self.assertEqual(checkpoints(run), [])
        self.assertIn("holds no checkpoint", self.program("resume", "run", expect=2))

    def test_a_mesh_that_has_changed_is_refused(self):
        shutil.copy(TOP / "meshes" / "plate-28x8.msh", self.folder / "own.msh")
        self.program("run", TOP / "prm" / "quickstart.prm", "--output", "run",
                     *sets(["Bird/Particle spacing=0.006", "Blade/Mesh/Generator=file", "Blade/Mesh/File=own.msh",
                            "Blade/Supports/Clamped=1", "Blade/Supports/Tip=2", "Time/End time=1e-4"]))
        (self.folder / "own.msh").unlink()  # the run folder has a copy
        mesh = next((self.folder / "run" / "inputs").rglob("own.msh"))
        mesh.chmod(0o644)
        mesh.write_text(mesh.read_text() + "\n")
        text = self.program("resume", "run", *sets(["Time/End time=2e-4"]), expect=2)
        self.assertIn("own.msh' has changed", text)

        mesh.unlink()
        self.assertIn("own.msh' is not there, neither in the run folder nor seen", self.program("resume", "run", expect=2))

    def test_an_included_file_is_no_input_of_what_goes_on(self):
        (self.folder / "inner.prm").write_text((TOP / "prm" / "quickstart.prm").read_text())
        (self.folder / "outer.prm").write_text("include inner.prm\n")
        self.program("run", "outer.prm", "--output", "run", *sets([*COARSE, "Time/End time=1e-4"]))
        (self.folder / "inner.prm").unlink()
        self.program("resume", "run", *sets(["Time/End time=2e-4"]))

    def test_a_damaged_file_does_not_count_among_those_that_are_kept(self):
        run = self.finished()
        last = checkpoints(run)[-1]
        last.write_bytes(last.read_bytes()[:1000])
        self.program("resume", "run", *sets(["Output/Checkpoint/Keep=1", "Output/Checkpoint/Step interval=5",
                                             "Output/Checkpoint/At the end=false", "Time/End time=1.99e-4"]))
        self.assertEqual(len(checkpoints(run)), 1)
        self.program("resume", "run", *sets(["Time/End time=2.5e-4"]))

    def test_what_was_stopped_is_not_begun_anew_by_mistake(self):
        run = self.folder / "run"
        process = self.start("quickstart", "run", [*COARSE, "Time/End time=1.5e-3"])
        self.wait_for(lambda: (run / "fields" / "blade_0001.vtu").exists(), process)
        process.terminate()
        process.wait()
        again = ["run", TOP / "prm" / "quickstart.prm", "--output", "run", *sets([*COARSE, "Time/End time=1e-4"])]
        self.assertIn("birdstrike resume run", self.program(*again, expect=2))
        self.assertEqual(len(checkpoints(run)), 1)

    def test_a_signal_that_is_ignored_from_outside_stays_ignored(self):
        run = self.folder / "run"
        process = subprocess.Popen(["nohup", PROGRAM, "run", TOP / "prm" / "quickstart.prm", "--output", "run",
                                    *sets([*COARSE, "Time/End time=1e-3"])], cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.wait_for(lambda: (run / "fields" / "blade_0001.vtu").exists(), process)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(), 0)

    def test_a_screen_that_has_gone_takes_nothing_along(self):
        entries = [*COARSE, "Time/End time=3e-4", "Output/Console interval=1e-3"]
        process = subprocess.Popen([PROGRAM, "run", TOP / "prm" / "quickstart.prm", "--output", "run", *sets(entries)],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        process.stdout.close()
        self.assertEqual(process.wait(), 0)
        self.assertTrue((self.folder / "run" / "summary.json").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
