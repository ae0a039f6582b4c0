#!/usr/bin/env python3
"""Tests of compare.py, from outside: python3 tests/benchmarks/compare_test.py"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

COMPARE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "compare.py")


def entry(name, time, **more):
    return dict({"name": name, "run_type": "iteration", "cpu_time": time, "real_time": 3 * time, "time_unit": "us"}, **more)


class Compare(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, name, content):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps({"context": {}, "benchmarks": content}))
        return path

    def run_on(self, before, after, *options):
        done = subprocess.run([sys.executable, COMPARE, before, after, *options], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def expect_refusal(self, before, after, word):
        code, out, err = self.run_on(before, after)
        self.assertEqual(code, 2)
        self.assertEqual(out, "")
        self.assertIn(word, err)
        self.assertLessEqual(len(err.strip().splitlines()), 2)

    def test_equal(self):
        same = self.write("a.json", [entry("bird/n:10", 2.0)])
        code, out, _ = self.run_on(same, same, "--fail-above", "1.0")
        self.assertEqual(code, 0)
        self.assertIn("1.000", out)
        self.assertNotIn("slower", out)
        self.assertNotIn("faster", out)

    def test_smallest_repetition_counts(self):
        before = self.write("a.json", [entry("bird", 4.0), entry("bird", 2.0), entry("bird", 3.0)])
        after = self.write("b.json", [entry("bird", 9.0), entry("bird", 3.0)])
        code, out, _ = self.run_on(before, after)
        self.assertEqual(code, 0)
        self.assertIn("1.500  slower", out)

    def test_aggregates_are_passed_over(self):
        mean = entry("bird_mean", 1.0, run_type="aggregate")
        before = self.write("a.json", [entry("bird", 4.0), mean])
        after = self.write("b.json", [entry("bird", 2.0), mean])
        _, out, _ = self.run_on(before, after)
        self.assertIn("0.500  faster", out)
        self.assertNotIn("bird_mean", out)

    def test_worse_fails_only_beyond_the_limit(self):
        before = self.write("a.json", [entry("bird", 2.0), entry("shell", 1.0)])
        after = self.write("b.json", [entry("bird", 2.3), entry("shell", 1.0)])
        self.assertEqual(self.run_on(before, after)[0], 0)
        self.assertEqual(self.run_on(before, after, "--fail-above", "1.2")[0], 0)
        code, _, err = self.run_on(before, after, "--fail-above", "1.1")
        self.assertEqual(code, 1)
        self.assertIn("1.150", err)
        self.assertEqual(self.run_on(before, after, "--fail-above", "1.1", "--filter", "shell")[0], 0)

    def test_units_and_how_often_it_ran_do_not_matter(self):
        before = self.write("a.json", [entry("bird/threads:2/iterations:10/repeats:3/real_time", 1.0)])
        after = self.write("b.json", [entry("bird/threads:2/min_time:0.050/real_time", 1000.0, time_unit="ns")])
        code, out, _ = self.run_on(before, after)
        self.assertEqual(code, 0)
        self.assertIn("3 us        3 us   1.000", out)  # by the clock, since the name says so

    def test_missing_names_are_counted(self):
        before = self.write("a.json", [entry("bird", 1.0), entry("gone", 1.0)])
        after = self.write("b.json", [entry("bird", 1.0)])
        self.assertIn("only before: 1 (gone)", self.run_on(before, after)[1])

    def test_bad_input_is_refused(self):
        good = self.write("a.json", [entry("bird", 1.0)])
        self.expect_refusal(good, os.path.join(self.folder.name, "none.json"), "none.json")
        self.expect_refusal(good, self.write("text.json", "bird 1.0"), "is not JSON")
        self.expect_refusal(good, self.write("list.json", "[1, 2]"), "benchmarks")
        self.expect_refusal(good, self.write("other.json", [entry("shell", 1.0)]), "in common")
        self.expect_refusal(good, self.write("broken.json", [{"name": "bird"}]), "has no time")
        self.expect_refusal(good, self.write("zero.json", [entry("bird", 0.0)]), "took 0.0")


if __name__ == "__main__":
    unittest.main()
