#!/usr/bin/env python3
"""Tests of speed_table.py and roofline.py on small folders: python3 tests/benchmarks/speed_table_test.py"""

import json
import os
import tempfile
import unittest

import roofline
import speed_table
from compare import BadInput

LOG = """Ended
section                         seconds    share       calls
bird: rates                       1.500    75.0%          77
balance and output                0.100     5.0%          25
other                             0.100     5.0%
total                             2.000   100.0%
"""


def entry(name, microseconds, units, **more):
    return dict({"name": name, "run_type": "iteration", "cpu_time": microseconds, "real_time": microseconds, "time_unit": "us",
                 "units": units}, **more)


class SpeedTable(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name

    def write(self, benchmarks):
        with open(os.path.join(self.folder, "benchmarks.json"), "w", encoding="utf-8") as file:
            json.dump({"context": {"machine": "abacus"}, "benchmarks": benchmarks}, file)

    def write_run(self, name, wall):
        folder = os.path.join(self.folder, name)
        os.mkdir(folder)
        summary = {"cost": {"wall": wall, "ns_per_particle_step": 210.4, "ns_per_element_step": 95.2}, "end": {"time": 2e-3},
                   "bird": {"particles": 10}, "blade": {"elements": 5}, "steps": {"bird": 7}}
        with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump(summary, file)
        with open(os.path.join(folder, "log.txt"), "w", encoding="utf-8") as file:
            file.write(LOG)

    def test_what_is_missing_is_a_dash(self):
        self.write([])
        text = speed_table.targets(speed_table.Measured(self.folder))
        self.assertIn("| ≤ 150 ns | – |", text)

    def test_times_become_costs_per_unit(self):
        self.write([entry("bird/step/riemann/n:10000/threads:1", 2000.0, 9916, true_neighbors=67.2)])
        text = speed_table.targets(speed_table.Measured(self.folder))
        self.assertIn("(67 true neighbours) | ≤ 150 ns | 202 ns |", text)

    def test_a_folder_of_before_stands_beside(self):
        with tempfile.TemporaryDirectory() as other:
            now, self.folder = self.folder, other
            self.write([entry("bird/step/riemann/n:10000/threads:1", 4000.0, 9916, true_neighbors=67.2),
                        entry("bird/list/n:1000/threads:1", 5.0, 10)])
            before, self.folder = speed_table.Measured(other), now
        self.write([entry("bird/step/riemann/n:10000/threads:1", 2000.0, 9916, true_neighbors=67.2)])
        measured = speed_table.Measured(self.folder)
        self.assertIn("(67 true neighbours) | ≤ 150 ns | 403 ns | 202 ns |", speed_table.targets(measured, before))
        self.assertIn("| particle-step | – | 403 / – → 202 / – | – |", speed_table.sizes(measured, before))
        self.assertIn("| list build | – | – |", speed_table.sizes(measured, before))

    def test_fastest_run_counts_and_threads_are_compared(self):
        self.write([])
        for name, wall in (("frontal-1-1", 3.0), ("frontal-1-2", 2.0), ("frontal_20k-1-1", 9.0), ("frontal_20k-2-1", 5.0)):
            self.write_run(name, wall)
        measured = speed_table.Measured(self.folder)
        text = speed_table.targets(measured)
        self.assertIn("| ≤ 3 s | 2.00 s |", text)
        self.assertIn("| ≥ 1.8 | 1.80 |", text)
        self.assertIn("| ≤ 5 % | 10.0 % |", text)
        self.assertIn("| bird: rates | 1.50 s | 75.0 % |", speed_table.shares(measured))

    def test_roofline(self):
        self.write([entry("machine/fma/double/n:1000/threads:1", 1.0, 1000, flops_per_unit=16.0),
                    entry("machine/fma/float/n:1000/threads:1", 1.0, 1000, flops_per_unit=32.0),
                    entry("machine/triad/l2/n:20480/threads:1", 1.0, 1000, flops_per_unit=2.0, bytes_per_unit=24.0),
                    entry("contact/step/n:1000/threads:1", 100.0, 1000, flops_per_unit=500.0, bytes_per_unit=250.0)])
        _, benchmarks = roofline.read_benchmarks(os.path.join(self.folder, "benchmarks.json"))
        self.assertEqual(roofline.read_ceilings(benchmarks), ({"double": 16.0, "float": 32.0}, {"l2": 24.0}))
        self.assertEqual(roofline.read_points(benchmarks), [("contact", "double", 2.0, 5.0)])
        with self.assertRaises(BadInput):
            roofline.read_ceilings({})


if __name__ == "__main__":
    unittest.main()
