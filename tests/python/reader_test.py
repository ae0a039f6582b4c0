"""The package birdstrike reads what a run has written: reader_test.py PROGRAM SOURCE_FOLDER"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, TOP = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(TOP / "source" / "python"))

import h5py  # noqa: E402
import numpy as np  # noqa: E402
from birdstrike import Run  # noqa: E402


class Reader(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        for kind in ("shell", "solid"):
            subprocess.run([PROGRAM, "run", TOP / "prm" / "quickstart.prm", "--output", f"{cls.scratch.name}/{kind}", "--set",
                            f"Blade/Kind={kind}", "--set", "Time/End time=2e-4", "--set", "Output/Field interval=1e-4"],
                           check=True, stdout=subprocess.DEVNULL)
        cls.run_of = {kind: Run(f"{cls.scratch.name}/{kind}") for kind in ("shell", "solid")}

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_curves_end_where_the_summary_does(self):
        for run in self.run_of.values():
            self.assertEqual(run.tip.unit, "m")
            self.assertEqual(run.tip.values[-1], run.summary["tip"]["final"])
            np.testing.assert_array_equal(run.contact_impulse.values[-1], run.summary["contact"]["impulse"])
            # what the bird has lost is what contact has given (momentum balance: round-off)
            lost = run["bird_momentum_z"].values[0] - run["bird_momentum_z"].values[-1]
            self.assertAlmostEqual(lost, run.contact_impulse.values[-1, 2], delta=1e-12 * lost)
            self.assertIn("blade_elastic", run.energies)
            self.assertNotIn("time", run.energies)

    def test_meshes_share_nodes_and_have_cell_data(self):
        shell, solid = (run.blade(2e-4) for run in self.run_of.values())
        self.assertEqual(len(shell.points), self.run_of["shell"].summary["blade"]["nodes"])
        self.assertEqual(shell.cells_of.shape, (self.run_of["shell"].summary["blade"]["elements"], 4))
        self.assertEqual(solid.cells_of.shape, (self.run_of["solid"].summary["blade"]["elements"], 8))
        self.assertEqual(shell.units["displacement"], "m")
        for mesh in (shell, solid):
            # every quadrilateral (bottom of a hexahedron) goes round: its area by the shoelace is the blade's share
            corner = mesh.points[mesh.cells_of[:, :4]].astype(float)
            across = np.cross(corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1])
            area = 0.5 * np.linalg.norm(across, axis=1).sum() / (len(set(mesh.points[:, 2])) - (mesh is solid))
            self.assertAlmostEqual(area, 0.3112 * 0.0889, delta=1e-6 * area)  # the floats of the file
        thickness = shell.cells["thickness"]
        self.assertAlmostEqual(thickness.max(), 0.00427, delta=1e-4)  # thinned where it has yielded

    def test_fields_are_those_of_the_instant(self):
        run = self.run_of["shell"]
        mesh = run.blade(0.9e-4)
        self.assertAlmostEqual(mesh.time, 1e-4, delta=2e-6)  # a step
        np.testing.assert_allclose(run.times("blade"), run.times("bird"))
        tip = mesh.points[:, 0] > 0.3112 - 1e-6
        middle = np.argmin(np.abs(mesh.points[:, 1]) + ~tip)
        at = np.interp(mesh.time, run.tip.time, run.tip.values)
        self.assertAlmostEqual(mesh.nodes["displacement"][middle, 2], at, delta=2e-2 * np.abs(run.tip.values).max())
        bird = run.bird(0.)
        self.assertEqual(len(bird.points), run.summary["bird"]["particles"])
        self.assertEqual(sorted(bird.nodes["id"]), list(range(len(bird.points))))
        np.testing.assert_allclose(bird.nodes["velocity"][:, 2], 177.4, rtol=1e-6)

    def run_more(self, name, *entries):
        folder = pathlib.Path(self.scratch.name) / name
        subprocess.run([PROGRAM, "run", TOP / "prm" / "quickstart.prm", "--output", folder, "--set", "Output/Field interval=2e-4",
                        *(a for entry in entries for a in ("--set", entry))], check=True, stdout=subprocess.DEVNULL)
        return Run(folder)

    def test_a_deformed_blade_stands_where_it_is(self):
        deformed = self.run_more("deformed", "Output/Blade geometry=deformed", "Time/End time=2e-4").blade(2e-4)
        mesh = self.run_of["shell"].blade(2e-4)
        self.assertTrue(deformed.is_deformed)
        self.assertFalse(mesh.is_deformed)
        np.testing.assert_array_equal(deformed.nodes["displacement"], mesh.nodes["displacement"])
        np.testing.assert_allclose(deformed.points, mesh.points + mesh.nodes["displacement"], atol=1e-7)

    def test_contact_impulse_sums_to_what_the_bird_has_given(self):
        for run in self.run_of.values():
            given = run.blade(2e-4).nodes["contact_impulse"].astype(float).sum(axis=0)
            np.testing.assert_allclose(given[2], run.summary["contact"]["impulse"][2], rtol=1e-5)  # floats of the file
            self.assertEqual(run.blade(2e-4).units["contact_impulse"], "N s")

    def test_removed_particles_fly_on(self):
        run = self.run_more("flying", "Output/Removed particles=fly on", "Time/End time=1.4e-3")
        first, last = run.bird(0.), run.bird(1.4e-3)
        self.assertEqual(sorted(last.nodes["id"]), sorted(first.nodes["id"]))  # none is missing
        gone = last.nodes["removed"] == 1
        self.assertEqual(gone.sum(), run.summary["retired"]["particles"])
        self.assertGreater(gone.sum(), 100)
        before = run.bird(1.2e-3)
        at, was = np.argsort(last.nodes["id"]), np.argsort(before.nodes["id"])
        since = gone[at] & (before.nodes["removed"][was] == 1)  # removed before both files
        flown = before.points[was] + (last.time - before.time) * before.nodes["velocity"][was]
        np.testing.assert_allclose(last.points[at][since], flown[since], atol=2e-7)

    def test_profiles_have_axes(self):
        run = self.run_of["shell"]
        history = run.profile("root_normal_stress")
        self.assertEqual(history.values.shape, tuple(len(history.axes[axis]) for axis in ("time", "face", "chord")))
        self.assertEqual(history.unit, "Pa")
        np.testing.assert_array_equal(history.axes["time"], run.tip.time)
        with self.assertRaisesRegex(KeyError, "mid_chord_deflection_at_peak"):
            run.profile("none")

    # quickstart's plate is struck along z: a node of the tip's row moves with it, what a section at the root carries is the
    # root's, two patches that cover the blade take the whole force (round-off); nothing looked at changes the run
    def test_histories_that_are_asked_for(self):
        asked = {"Nodes": "tip: 0.3112 0 0", "Elements": "hot: 0.01 0 0 | 1", "Gauges": "g: 0.05 0 0", "Stations": "0, 0.5",
                 "Patches": "low: 0 -1 -1 0.2 1 1; high: 0.2 -1 -1 1 1 1"}
        for kind, plain in self.run_of.items():
            folder = pathlib.Path(self.scratch.name) / f"histories-{kind}"
            subprocess.run([PROGRAM, "run", plain.folder / "parameters.prm", "--output", folder] +
                           [word for entry, text in asked.items() for word in ("--set", f"Output/Histories/{entry}={text}")],
                           check=True, stdout=subprocess.DEVNULL)
            run = Run(folder)
            self.assertEqual((folder / "history.csv").read_bytes(), (plain.folder / "history.csv").read_bytes())
            np.testing.assert_allclose(run.nodes["tip"].u.values[-1, 2], run.tip.values[-1], rtol=0.05)
            self.assertEqual(run.nodes["tip"].a.unit, "m/s^2")
            moment = run["root_bending_moment"].values
            np.testing.assert_allclose(run.sections["span0"].M_bending.values, moment, atol=1e-6 * np.abs(moment).max())
            for quantity, whole in (("F", run.contact_force), ("impulse", run.contact_impulse)):
                parts = [getattr(run.patches[name], quantity).values for name in ("low", "high")]
                np.testing.assert_allclose(sum(parts), whole.values, atol=1e-9 * np.abs(whole.values).max())
            self.assertEqual(run.elements["hot"].stress.values.shape, (len(run.tip.time), 6))
            self.assertLess(abs(run.gauges["g"].strain.values).max(), 0.1)
            self.assertEqual(run.profiles, plain.profiles)  # tables are none
            for name in run.profiles:
                self.assertGreater(run.profile(name).values.size, 0, name)
            with h5py.File(folder / "results.h5") as file:
                np.testing.assert_array_equal(file["gauges/g.strain"][()], run.gauges["g"].strain.values)
                self.assertIn("struck", file["gauges/g.strain"].attrs["description"])
        with self.assertRaisesRegex(KeyError, "Output/Histories"):
            self.run_of["shell"].nodes

    def test_every_dataset_says_what_it_is(self):
        with h5py.File(self.run_of["shell"].folder / "results.h5") as file:
            for group in file:
                for name, data in file[group].items():
                    self.assertEqual(data.attrs["name"], group if name == "values" else name)
                    self.assertGreater(len(data.attrs["unit"]), 0, name)
                    self.assertGreater(len(data.attrs["description"]), 10, name)

    def test_an_unfinished_run_can_be_read(self):
        folder = pathlib.Path(self.scratch.name) / "unfinished"
        folder.mkdir()
        text = (self.run_of["shell"].folder / "history.csv").read_text()
        (folder / "history.csv").write_text(text[:-40])  # cut within the last row
        run = Run(folder)
        self.assertIsNone(run.summary)
        self.assertEqual(len(run.tip.time), len(self.run_of["shell"].tip.time) - 1)
        with self.assertRaises(KeyError):
            run.blade(0.)

    def test_what_is_not_there_is_named(self):
        with self.assertRaisesRegex(FileNotFoundError, "history.csv"):
            Run(self.scratch.name)
        with self.assertRaisesRegex(KeyError, "tip_mid_chord"):
            self.run_of["shell"]["tip"]


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
