"""A run folder stands by itself: it is moved to where the case's files do not exist, and read, run and resumed there.

run_folder_test.py PROGRAM SOURCE_FOLDER"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()

CASE = """# from C:\\cases\\
include  sub/base.prm
subsection Blade
  include other/metal.prm
  subsection Thickness
    set Table = other/plate.msh
  end
end
"""
BASE = """include metal.prm # of this folder
subsection Blade
  set Kind = shell
  subsection Mesh
    set Generator = file
    set File      = plate.msh
  end
  subsection Supports
    set Clamped = root
    set Tip     = tip
  end
end
subsection Bird
  set Particle spacing = 8 mm
  set Aim point = 0.2, 0, 0
end
subsection Time
  set End time = 0.05 ms
  set Threads  = 1
end
"""
METAL = {"sub": "subsection Contact\n  set Self-contact = false\nend\n",
         "other": "subsection Material\n  set Name = Ti-6Al-4V\n  set Hardening = perfect\nend\n"}


class RunFolder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name).resolve()
        self.here = self.folder / "here"  # the working directory
        self.here.mkdir()
        self.case = self.folder / "case"
        for name, text in METAL.items():
            (self.case / name).mkdir(parents=True)
            (self.case / name / "metal.prm").write_text(text)
        mesh = (TOP / "meshes" / "plate-28x8.msh").read_text()
        (self.case / "sub" / "plate.msh").write_text(mesh)
        nodes = mesh.split("$Nodes\n")[1].split("$EndNodes")[0].splitlines()[1:]
        table = "\n".join(f"{' '.join(line.split()[1:4])} 0.00427" for line in nodes)
        (self.case / "other" / "plate.msh").write_text(table + "\n")  # a table of the mesh's own name
        (self.case / "case.prm").write_text(CASE)
        (self.case / "sub" / "base.prm").write_text(BASE)

    def program(self, *words, expect=0, cwd=None):
        done = subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=cwd or self.here)
        self.assertEqual(done.returncode, expect, f"{words}\n{done.stdout}")
        return done.stdout

    def run_and_move(self):
        """The case's files are gone afterwards."""
        self.program("run", self.case / "case.prm", "--output", "runs/x")
        moved = self.folder / "elsewhere" / "y"
        moved.parent.mkdir()
        shutil.move(self.here / "runs" / "x", moved)
        shutil.rmtree(self.case)
        return moved

    def test_a_moved_run_is_read_run_and_resumed(self):
        run = self.run_and_move()
        self.assertEqual(sorted(file.name for file in (run / "inputs").iterdir()),
                         ["base.prm", "metal-2.prm", "metal.prm", "origin.txt", "plate-2.msh", "plate.msh"])
        original = (run / "original.prm").read_text()
        self.assertIn("# from C:\\cases\\\ninclude inputs/base.prm  # typed: sub/base.prm\n", original)
        for name in ("original.prm", "parameters.prm"):
            self.assertIn("valid", self.program("validate", run / name))
            self.assertNotIn("Warning: " + str(run), self.program("validate", run / name))
            self.program("run", run / name, "--output", f"again {name}")
            self.assertEqual((self.here / f"again {name}" / "history.csv").read_bytes(), (run / "history.csv").read_bytes(), name)
        self.program("resume", run, "--set", "Time/End time=0.06 ms")
        self.program("resume", run, "--set", "Time/End time=0.07 ms", cwd=run)
        summary = json.loads((run / "summary.json").read_text())
        self.assertAlmostEqual(summary["end"]["time"], 7e-5, delta=1e-6)
        self.assertEqual([file["copy"] for file in summary["inputs"]], ["inputs/plate.msh", "inputs/plate-2.msh"])
        self.program("validate", run / "parameters.prm")

    def test_a_run_may_replace_itself(self):
        run = self.run_and_move()
        before = sorted(file.name for file in (run / "inputs").iterdir())
        history = (run / "history.csv").read_bytes()
        for name in ("original.prm", "parameters.prm"):
            self.program("run", run / name, "--output", run, "--force")
            self.assertEqual((run / "history.csv").read_bytes(), history)
        after = sorted(file.name for file in (run / "inputs").iterdir())
        self.assertEqual(after, [name for name in before if not name.endswith(".prm")])  # parameters.prm includes nothing

    def test_what_has_changed_is_not_gone_on_with(self):
        run = self.run_and_move()
        mesh = run / "inputs" / "plate.msh"
        text = mesh.read_text()
        mesh.write_text(text + "\n")
        self.assertIn("has changed", self.program("resume", run, "--set", "Time/End time=0.06 ms", expect=2))
        mesh.unlink()
        self.program("resume", run, "--set", "Time/End time=0.06 ms", expect=2)
        mesh.write_text(text)
        self.program("resume", run, "--set", "Time/End time=0.06 ms")

    def test_points_of_a_study_share_one_copy(self):
        study = ["study", self.case / "case.prm", "--vary", "Bird/Mass=0.09, 0.1", "--output", "grid"]
        self.program(*study)
        copies = [self.here / "grid" / f"Mass={mass}" / "inputs" / "plate.msh" for mass in ("0.09", "0.1")]
        self.assertEqual(os.stat(copies[0]).st_ino, os.stat(copies[1]).st_ino)
        self.assertIn("2 points, 2 of them", self.program(*study))
        mesh = self.case / "sub" / "plate.msh"  # contents count, wherever they lie
        mesh.write_text(mesh.read_text() + "\n")
        self.assertIn("has changed", self.program(*study, expect=2))
        self.assertIn("2 points, 0 of them", self.program(*study, "--force"))

    def test_without_copies_paths_are_absolute(self):
        self.program("run", self.case / "case.prm", "--output", "runs/x", "--set", "Output/Copy inputs=false")
        run = self.here / "runs" / "x"
        self.assertFalse((run / "inputs").exists())
        for name in ("original.prm", "parameters.prm"):
            self.program("validate", run / name, cwd=self.folder)
        self.program("resume", run, "--set", "Time/End time=0.06 ms", cwd=self.folder)

    def test_paths_are_meant_from_the_parameter_file(self):
        said = self.program("validate", self.case / "case.prm")
        self.assertNotIn("working directory", said)
        (self.here / "plate.msh").write_text("another")
        said = self.program("validate", self.case / "case.prm")
        self.assertIn("'plate.msh' in the working directory is another one", said)
        (self.case / "sub" / "plate.msh").rename(self.here / "plate.msh")
        said = self.program("validate", self.case / "case.prm")
        self.assertIn("'plate.msh' is in the working directory, and not beside the parameter file", said)
        (self.here / "plate.msh").rename(self.case / "shell.msh")  # of the command line: from here, else beside the file
        self.program("validate", self.case / "case.prm", "--set", "Blade/Mesh/File=../case/shell.msh")
        self.program("validate", self.case / "case.prm", "--set", "Blade/Mesh/File=shell.msh")
        said = self.program("validate", self.case / "case.prm", expect=2)
        self.assertIn("cannot open 'plate.msh'", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
