"""What the tests of the package share: program, source folder, a case of a tenth of a second. They are called with
PROGRAM SOURCE_FOLDER."""

import os
import pathlib
import sys
import tempfile
import unittest

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
PACKAGE = TOP / "source" / "python"
sys.path.insert(0, str(PACKAGE))

from birdstrike import Case  # noqa: E402

COARSE = {"Bird/Particle spacing": "8 mm", "Blade/Mesh/Elements along span": 10, "Blade/Mesh/Elements along chord": 3,
          "Time/End time": 1e-4, "Output/Field interval": 0}


def small_case(**entries):
    """quickstart.prm, coarse, to 0.1 ms."""
    case = Case(TOP / "prm" / "quickstart.prm", program=PROGRAM)
    for entry, value in {**COARSE, **entries}.items():
        case = case.set(entry, value)
    return case


class InFolder(unittest.TestCase):
    """Each test works in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)


def main():
    unittest.main(module="__main__", argv=sys.argv[:1])
