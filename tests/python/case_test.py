"""Cases in Python, and how a call of the program can fail: case_test.py PROGRAM SOURCE_FOLDER"""

import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock

from small import PACKAGE, PROGRAM, TOP, InFolder, main, small_case

import numpy as np
from birdstrike import Case, Failed, find_program

LONG = {"Time/End time": 10, "Time/Maximum wall time": 60}  # what a test stops; it ends by itself should the test fail to


class Entries(unittest.TestCase):
    def test_a_case_does_not_change(self):
        case = Case("a.prm")
        other = case.set("Bird/Mass", 0.1).set("Bird/Speed", "200 knots").set("Bird/Mass", 0.2)
        self.assertEqual(case.entries, ())
        self.assertEqual(other.entries, (("Bird/Speed", "200 knots"), ("Bird/Mass", "0.2")))  # the last one holds
        with self.assertRaises(AttributeError):
            case.file = "b.prm"

    def test_values_are_written_as_the_file_has_them(self):
        for value, text in ((200, "200"), (0.1, "0.1"), (1e-7, "1e-07"), (np.float64(0.1), "0.1"), (np.int64(3), "3"), (True, "true"),
                            (np.bool_(False), "false"), ("2.5 mm", "2.5 mm"), ([0, 0, 177.4], "0, 0, 177.4"),
                            (np.array([0., 1.]), "0.0, 1.0"), (("1 mm", 0), "1 mm, 0"), (pathlib.Path("a/b.msh"), "a/b.msh")):
            self.assertEqual(Case("a.prm").set("Bird/Mass", value).entries, (("Bird/Mass", text),))

    def test_what_is_no_value_is_refused(self):
        for value in (float("nan"), np.inf, "1\nset Mass = 2", "1\rx", "a\0b"):
            with self.assertRaises(ValueError, msg=repr(value)):
                Case("a.prm").set("Bird/Mass", value)
        for value in (None, object(), {"a": 1}, [[1, 2], [3, 4]], 1j):
            with self.assertRaises(TypeError, msg=repr(value)):
                Case("a.prm").set("Bird/Mass", value)

    def test_what_is_no_name_is_refused(self):
        for entry in ("", "Mass", "Bird/", "/Mass", "Bird/Mass=1", "Bird/Mass\n", "Bird\n/Mass", "--output/x", "-x/y", " /y"):
            with self.assertRaisesRegex(ValueError, "Section/Entry", msg=entry):
                Case("a.prm").set(entry, 1)

    def test_no_word_is_taken_for_an_option(self):
        words = Case("-f.prm").set("Bird/Mass", "--force").arguments("run")
        self.assertEqual(words, ["run", "./-f.prm", "--set=Bird/Mass=--force"])


class Runs(InFolder):
    def test_a_run_is_read_as_it_is_made(self):
        case = small_case()
        self.assertIn("particles", case.explain())
        self.assertTrue(any("rising" in each or "particles" in each for each in case.validate()), case.validate())
        self.assertEqual(os.listdir(), [])  # neither has written anything
        run = case.run("a run; touch b", threads=1)
        self.assertEqual(os.listdir(), ["a run; touch b"])
        self.assertEqual(run.summary["tip"]["final"], run.tip.values[-1])
        self.assertIn("set Threads = 1", " ".join((run.folder / "parameters.prm").read_text().split()))
        self.assertEqual(case.run().folder, pathlib.Path("runs/quickstart"))  # as the program names it
        self.assertEqual(case.set("Output/Directory", "my own").run().folder, pathlib.Path("my own"))

    def test_a_finished_run_is_kept(self):
        run = small_case().run("run")
        with self.assertRaisesRegex(Failed, "holds a run") as refused:
            small_case().set("Bird/Mass", 0.11).run("run")
        self.assertEqual(refused.exception.code, 2)
        forced = small_case().set("Bird/Mass", 0.11).run("run", force=True)
        self.assertNotEqual(forced.summary["contact"]["impulse"], run.summary["contact"]["impulse"])

    def test_a_wrong_entry_is_named(self):
        for call in (Case.validate, Case.explain, Case.run):
            with self.assertRaisesRegex(Failed, "Particle spacing") as refused:
                call(small_case().set("Bird/Particle spcing", 0.004))
            self.assertEqual(refused.exception.code, 2)
            self.assertNotIn("Warning", str(refused.exception))
        with self.assertRaisesRegex(Failed, "none.prm") as refused:
            Case("none.prm", program=PROGRAM).run()
        self.assertEqual(refused.exception.code, 2)

    def test_a_lost_run_says_what_its_record_does(self):
        with self.assertRaises(Failed) as lost:
            small_case().set("Time/Energy error limit", 1e-12).run("lost")
        self.assertEqual(lost.exception.code, 3)
        self.assertEqual(str(lost.exception), json.loads(pathlib.Path("lost/failure.json").read_text())["message"])
        self.assertIn(str(lost.exception), lost.exception.output)
        again = pickle.loads(pickle.dumps(lost.exception))  # on its way from another process
        self.assertEqual((again.code, str(again), again.output), (3, str(lost.exception), lost.exception.output))

    def test_a_timeout_leaves_a_checkpoint(self):
        with self.assertRaisesRegex(Failed, "timeout of 5 s.*\n.*signal.*\n.*birdstrike resume long") as stopped:
            small_case(**LONG).run("long", timeout=5)
        self.assertEqual(stopped.exception.code, 130)
        self.assertTrue(os.listdir("long/checkpoints"))

    def test_a_program_that_is_killed_is_no_success(self):
        with open("killed", "w") as script:
            script.write("#!/bin/sh\nkill -KILL $$\n")
        os.chmod("killed", 0o755)
        with self.assertRaisesRegex(Failed, "signal 9") as killed:
            Case("a.prm", program="./killed").run()
        self.assertEqual(killed.exception.code, 137)


class CtrlC(InFolder):
    SCRIPT = f"""
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background of a shell it is ignored
sys.path[:0] = [{str(PACKAGE)!r}, {str(pathlib.Path(__file__).parent)!r}]
sys.argv[1:] = [{str(PROGRAM)!r}, {str(TOP)!r}]
from small import small_case
try:
    small_case(**{LONG!r}).run("long")
except KeyboardInterrupt:
    print("Interrupted in Python.")
"""

    def test_is_handed_on(self):
        process = subprocess.Popen([sys.executable, "-c", self.SCRIPT], stdout=subprocess.PIPE, text=True)
        end = time.monotonic() + 60.
        while process.poll() is None and time.monotonic() < end and not os.path.exists("long/parameters.prm"):
            time.sleep(0.1)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)  # to Python alone; a terminal tells the program as well
        self.assertEqual(process.communicate(timeout=60)[0], "Interrupted in Python.\n")
        self.assertTrue(os.listdir("long/checkpoints"))
        self.assertIn("stopped by a signal", pathlib.Path("long/summary.json").read_text())  # Python has waited for it


class Program(InFolder):
    def find(self, program=None, **environment):
        with mock.patch.dict(os.environ, environment):
            return find_program(program)

    def test_is_found_where_it_is_named(self):
        os.mkdir("bin")
        for name in ("birdstrike", "other"):
            os.symlink(PROGRAM, f"bin/{name}")
        here = pathlib.Path.cwd() / "bin"
        self.assertEqual(self.find("bin/other", BIRDSTRIKE="/no/such", PATH="/no/such"), here / "other")
        self.assertEqual(self.find(BIRDSTRIKE="bin/other", PATH=str(here)), here / "other")
        self.assertEqual(self.find(BIRDSTRIKE="", PATH=str(here)), here / "birdstrike")

    def test_is_not_replaced_by_another(self):
        with self.assertRaisesRegex(FileNotFoundError, "'program' is '/no/such'"):
            self.find("/no/such", BIRDSTRIKE=str(PROGRAM))
        with self.assertRaisesRegex(FileNotFoundError, "BIRDSTRIKE is '/no/such'"):
            self.find(BIRDSTRIKE="/no/such")

    def test_that_is_nowhere_is_asked_for(self):
        with mock.patch("birdstrike.program.__file__", "/somewhere/else/python/birdstrike/program.py"):
            with self.assertRaisesRegex(FileNotFoundError, "Action: build it .*environment variable BIRDSTRIKE"):
                self.find(BIRDSTRIKE="", PATH="/no/such")

    def test_is_that_of_the_source_tree_around_the_package(self):
        os.makedirs("tree/build/bin")
        os.makedirs("tree/prm")
        pathlib.Path("tree/prm/run.sh").touch()
        os.symlink(PROGRAM, "tree/build/bin/birdstrike")
        tree = pathlib.Path.cwd() / "tree"
        with mock.patch("birdstrike.program.__file__", str(tree / "source/python/birdstrike/program.py")):
            self.assertEqual(self.find(BIRDSTRIKE="", PATH="/no/such"), tree / "build/bin/birdstrike")


class Package(unittest.TestCase):
    def test_says_what_is_missing(self):
        for name in ("numpy", "h5py"):
            script = f"import sys; sys.path.insert(0, {str(PACKAGE)!r}); sys.modules[{name!r}] = None; import birdstrike"
            said = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True).stderr
            self.assertIn(f"apt-get install python3-{name}", said)
            self.assertEqual(said.count("Traceback"), 1, said)

    def test_has_the_version_of_the_program(self):
        import birdstrike
        self.assertIn(f"project(birdstrike VERSION {birdstrike.__version__} ", (TOP / "CMakeLists.txt").read_text())


if __name__ == "__main__":
    main()
