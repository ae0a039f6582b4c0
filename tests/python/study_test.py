"""Studies in Python: study_test.py PROGRAM SOURCE_FOLDER"""

import os
import pathlib
import unittest

from small import InFolder, main, small_case

import numpy as np
from birdstrike import Case, Failed, Study, study

MASS, DENSITY = "Bird/Mass", "Bird/Density"


class Halton:
    """Of the unit square, from the first point on."""

    def random(self, n):
        return np.array([[self.mirror(k, base) for base in (2, 3)] for k in range(1, n + 1)])

    @staticmethod
    def mirror(k, base):
        share, digit = 0., 1.
        while k > 0:
            digit /= base
            share += digit * (k % base)
            k //= base
        return share


class Drawn:
    """What a test gives it."""

    def __init__(self, shares):
        self.shares = np.array(shares)

    def random(self, n):
        return self.shares


class Studies(InFolder):
    def test_a_grid_is_a_table_with_runs(self):
        made = study(small_case(), {MASS: [0.1, 0.12], "Bird/Velocity": [[0, 0, 150], [0, 0, 200]]}, folder="grid", jobs=2)
        self.assertEqual(len(made), 4)
        self.assertEqual(made.states, 4 * ["done"])
        np.testing.assert_array_equal(made[MASS], [0.1, 0.1, 0.12, 0.12])
        self.assertEqual(made.columns[MASS], "kg")
        self.assertEqual(list(made["Bird/Velocity"]), 2 * ["0, 0, 150", "0, 0, 200"])
        self.assertEqual(made.columns["Root: peak bending moment"], "N m")
        self.assertEqual([run.folder for run in made.runs[1:3]], [made.runs[1].folder, made.runs[2].folder])
        for moment, run in zip(made["Root: peak bending moment"], made.runs):
            self.assertEqual(moment, run.summary["root"]["peak_moment"])

    def test_points_that_are_there_are_taken(self):
        first = study(small_case(), {MASS: [0.1]}, folder="study")
        stamp = (first.runs[0].folder / "history.csv").stat().st_mtime_ns
        more = study(small_case(), {MASS: "0.1, 0.11"}, folder="study")  # the program's own words
        np.testing.assert_array_equal(more[MASS], [0.1, 0.11])
        self.assertEqual((more.runs[0].folder / "history.csv").stat().st_mtime_ns, stamp)
        with self.assertRaisesRegex(Failed, "another study") as refused:
            study(small_case(), {MASS: [0.13]}, folder="study")
        self.assertEqual(refused.exception.code, 2)
        self.assertIsNone(refused.exception.study)  # no table was written
        self.assertEqual(len(study(small_case(), {MASS: [0.13]}, folder="study", force=True)), 1)

    def test_a_sampler_draws_points(self):
        made = study(small_case(), {MASS: (0.1, 0.12), DENSITY: (900, 1000)}, sampler=Halton(), n=3)
        self.assertEqual(made.folder, pathlib.Path("runs/study/quickstart"))
        np.testing.assert_allclose(made[MASS], [0.11, 0.105, 0.115], rtol=1e-12)
        np.testing.assert_allclose(made[DENSITY], [900 + 100 / 3, 900 + 200 / 3, 900 + 100 / 9], rtol=1e-8)  # nine digits
        for mass, run in zip(made[MASS], made.runs):
            self.assertAlmostEqual(run.summary["bird"]["mass"], mass, delta=1e-9)

    def test_pairs_go_together(self):
        made = study(small_case(), {MASS: [0.1, 0.12], DENSITY: [900, 950]}, pairs=True, folder="pairs")
        np.testing.assert_array_equal(made[DENSITY], [900, 950])

    def test_a_file_may_say_what_is_varied(self):
        case = small_case().set("Study/Vary 1", "Bird/Mass = 0.1, 0.11")
        np.testing.assert_array_equal(study(case, folder="own")[MASS], [0.1, 0.11])

    def test_a_lost_point_leaves_the_others(self):
        limit = "Time/Energy error limit"
        with self.assertRaisesRegex(Failed, "^Lost: 'Energy error limit=1e-12'") as lost:
            study(small_case(), {limit: [0.05, 1e-12]}, folder="lost")
        self.assertEqual(lost.exception.code, 3)
        made = lost.exception.study
        self.assertEqual(made.states[0], "done")
        self.assertRegex(made.states[1], "^lost: .*energy")
        self.assertIsNone(made.runs[1])
        self.assertEqual(list(np.isnan(made["Contact: impulse (norm)"])), [False, True])

    def test_what_the_program_refuses_is_said(self):
        with self.assertRaisesRegex(Failed, "'Mass'") as refused:
            study(small_case(), {"Bird/Mas": [1, 2]})
        self.assertEqual(refused.exception.code, 2)
        with self.assertRaisesRegex(Failed, "Nothing is varied"):
            study(small_case())
        self.assertEqual(os.listdir(), [])

    def test_what_is_not_there_is_named(self):
        with self.assertRaisesRegex(FileNotFoundError, "study.csv"):
            Study(".")


class Refusals(unittest.TestCase):
    """Before the program is called."""

    def refuse(self, words, vary, **options):
        with self.assertRaisesRegex(ValueError, words):
            study(Case("a.prm", program="/no/such"), vary, **options)

    def test_lists(self):
        self.refuse("from which a sampler draws", {MASS: (0.1, 0.2)})
        self.refuse("not empty", {MASS: []})
        self.refuse("holds '|'", {"Case/Description": ["a | b", "c"]})
        self.refuse("read as several values", {"Case/Description": ["a, b"]})
        self.refuse("read as several values", {MASS: ["0.1:0.2:3"]})
        self.refuse("Section/Entry", {"Bird/Mass=1": [1, 2]})
        self.refuse("line break", {MASS: "0.1,\n0.2"})
        self.refuse("longer than a command line", {MASS: [0.1 + 1e-9 * k for k in range(20000)]})

    def test_samplers(self):
        both = {MASS: (0.1, 0.2), DENSITY: (900, 950)}
        self.refuse("needs n", both, sampler=Halton())
        self.refuse(r"\[3\]\[2\]", both, sampler=Drawn([[0.1, 0.2]]), n=3)
        self.refuse("from 0 to 1", both, sampler=Drawn([[0.1, 1.2]]), n=1)
        self.refuse("from 0 to 1", both, sampler=Drawn([[0.1, np.nan]]), n=1)
        for ends in ((0.1,), (0.1, 0.2, 0.3), (0.1, np.inf), "0.1, 0.2", ("1 g", "2 g"), [[1, 2], [3, 4]], 5):
            self.refuse("between two numbers", {MASS: ends}, sampler=Drawn([[0.5]]), n=1)
        self.refuse("Section/Entry", {"Mass": (0.1, 0.2)}, sampler=Drawn([[0.5]]), n=1)


if __name__ == "__main__":
    main()
