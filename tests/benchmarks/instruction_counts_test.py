#!/usr/bin/env python3
"""Tests of what instruction_counts.py says of given counts: python3 tests/benchmarks/instruction_counts_test.py"""

import os
import tempfile
import unittest

import instruction_counts as gate


class Judge(unittest.TestCase):
    def judge(self, stored, counted):
        lines, bad = gate.judge(stored, counted)
        return "\n".join(lines), bad

    def test_within_tolerance(self):
        text, bad = self.judge({"rates": 100.0}, {"rates": 104.9})
        self.assertEqual(bad, [])
        self.assertNotIn("MORE", text)

    def test_more_is_named_with_both_numbers(self):
        text, bad = self.judge({"rates": 100.0, "list": 50.0}, {"rates": 105.1, "list": 50.0})
        self.assertEqual(bad, ["rates"])
        self.assertIn("105.1", text)
        self.assertIn("MORE than the stored 100.0", text)

    def test_fewer_is_said_but_no_failure(self):
        text, bad = self.judge({"rates": 100.0}, {"rates": 90.0})
        self.assertEqual(bad, [])
        self.assertIn("--update", text)

    def test_new_and_lost_names_fail(self):
        self.assertEqual(self.judge({}, {"rates": 1.0})[1], ["rates"])
        self.assertEqual(self.judge({"rates": 1.0, "gone": 1.0}, {"rates": 1.0})[1], ["gone"])

    def test_broken_file_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "counts.json")
            for content in ("", "[]", '{"made_with": "x"}', '{"made_with": "x", "instructions_per_unit": {"a": "b"}}'):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(content)
                with self.assertRaises(gate.Failure):
                    gate.read_expected(path)
        with self.assertRaises(gate.Failure):
            gate.read_expected(path)

    def test_stored_counts_can_be_read(self):
        made_with, counts = gate.read_expected(gate.EXPECTED)
        self.assertIn("GCC", made_with)
        self.assertGreater(len(counts), 5)


if __name__ == "__main__":
    unittest.main()
