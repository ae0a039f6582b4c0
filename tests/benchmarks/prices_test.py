#!/usr/bin/env python3
"""Tests of prices.py: python3 tests/benchmarks/prices_test.py"""

import re
import unittest

import prices
from compare import BadInput


def measured(table, factor=1.0, **changed):
    benchmarks = {}
    for name, value, benchmark, counter in table:
        entry = benchmarks.setdefault(benchmark + prices.SIZE, {"units": 10.0})
        if counter:
            entry[counter] = changed.get(name, value)
        else:
            entry["time"] = 10.0 * changed.get(name, factor * value)
    return benchmarks


class Prices(unittest.TestCase):
    def setUp(self):
        self.table = prices.read_table(prices.HEADER.read_text(encoding="utf-8"))

    def test_every_constant_of_the_table_is_read(self):
        text = prices.HEADER.read_text(encoding="utf-8")
        # shares and figures of whole runs, which no benchmark of a loop measures
        of_runs = {"starting", "step", "field_byte", "contact_particle", "contact_on_slope", "element_motion", "failing_point", "ply",
                   "spray_share", "running", "running_particle", "field_particle", "running_element"}
        declared = set(re.findall(r"constexpr double (\w+)", text))
        self.assertEqual(declared - of_runs, {row[0] for row in self.table})
        self.assertLessEqual(of_runs, declared)
        self.assertGreater(len(self.table), 10)

    def test_a_slower_machine_has_the_same_prices(self):
        factor, rows = prices.compare(self.table, measured(self.table, 2.5))
        self.assertAlmostEqual(factor, 2.5)
        self.assertFalse([row for row in rows if prices.is_off(row[3])])

    def test_a_price_that_has_aged_is_named(self):
        name, value = self.table[0][0], self.table[0][1]
        _, rows = prices.compare(self.table, measured(self.table, 2.5, **{name: 2.5 * 1.4 * value}))
        self.assertEqual([row[0] for row in rows if prices.is_off(row[3])], [name])

    def test_what_building_takes_is_judged_by_its_sums(self):
        sums = {name: row for name, *row in prices.compare_building(self.table, {"particle": 2000.0, "shell": 2330.0, "brick": 3410.0})}
        self.assertTrue(prices.is_off(sums["building a particle"][-1]))
        self.assertFalse(prices.is_off(sums["building a shell"][-1]))
        self.assertFalse(prices.is_off(sums["building a brick"][-1]))

    def test_a_price_without_its_benchmark_is_refused(self):
        with self.assertRaises(BadInput):
            prices.compare(self.table, {})


if __name__ == "__main__":
    unittest.main()
