"""The Python of the manual runs as it stands, from top to bottom: manual_test.py PROGRAM SOURCE_FOLDER"""

import contextlib
import io
import os
import re
import sys
import types
from unittest import mock

from small import PROGRAM, TOP, InFolder, main

import numpy as np


class LatinHypercube:
    """Stands for SciPy's where that is not installed."""

    def __init__(self, d, seed):
        self.d, self.generator = d, np.random.default_rng(seed)

    def random(self, n):
        cells = np.array([self.generator.permutation(n) for _ in range(self.d)]).T
        return (cells + self.generator.random((n, self.d))) / n


def stand_in():
    qmc = types.SimpleNamespace(LatinHypercube=LatinHypercube)
    return {"scipy": types.ModuleType("scipy"), "scipy.stats": types.SimpleNamespace(qmc=qmc)}


class Manual(InFolder):
    def test_every_block_of_python(self):
        os.symlink(TOP / "prm", "prm")
        text = (TOP / "prm" / "manual" / "python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreater(len(blocks), 4)
        names, said = {}, io.StringIO()
        with (mock.patch.dict(os.environ, BIRDSTRIKE=str(PROGRAM)), mock.patch.dict(sys.modules, stand_in()),
              contextlib.redirect_stdout(said)):
            for number, block in enumerate(blocks, 1):
                exec(compile(block, f"python.md, block {number}", "exec"), names)
        self.assertRegex(said.getvalue(), "(?m)^2 .*Particle spcing")  # what was refused
        self.assertEqual(len(names["made"]), 4)
        self.assertGreater(names["largest"], 0.)
        self.assertGreater(names["runs"]["fast"].contact_force.values[:, 2].max(), names["runs"]["slow"].contact_force.values[:, 2].max())


if __name__ == "__main__":
    main()
