#!/usr/bin/env python3
"""Free streamlines at the edge of a plate: against balances and limits that the formulas do not use."""
import cmath
import math
import unittest

from free_streamlines import EdgeFlow, edge_flow

CASES = [(math.radians(angle), offset) for angle in (36.4, 90., 130.) for offset in (-0.4, 0., 0.3, 0.45)]


class FreeStreamlines(unittest.TestCase):
    def test_pressure_on_the_plate_is_the_force(self):
        """Bernoulli's pressure (1 - u^2)/2 over the plate, where dx = F'/u du has a simple pole at u = 1. Simpson's rule
        with 2000 intervals errs by 1e-11 where the integrand is smooth; a sink near the edge makes it 1e-7."""
        n = 2000
        for alpha, offset in CASES:
            flow = edge_flow(alpha, offset)
            at_infinity = 2. * (1. - flow.passing) / math.pi
            values = [0.5 * (1. - u * u) * flow.plate_stretch(u) for u in (2. * i / n - 1. for i in range(n))] + [at_infinity]
            force = sum((1 if i in (0, n) else 4 if i % 2 else 2) * value for i, value in enumerate(values)) * 2. / n / 3.
            self.assertAlmostEqual(force, flow.force, delta=1e-6)

    def test_streams_are_as_wide_as_their_shares(self):
        """At the speed U the width of a stream is its share: between its free streamlines, which in the hodograph lie on
        either side of its place on the arc. 1e-6 rad from that place the stream has run straight to 1e-5."""
        near = 1e-6
        for alpha, offset in CASES:
            flow = edge_flow(alpha, offset)

            def left_of_flow(theta, side):
                direction = cmath.exp(1j * theta)
                return (direction * flow.position(cmath.exp(1j * (theta + side * near)) * (1. - 1e-14))).imag

            self.assertAlmostEqual(left_of_flow(0., 1), 1. - flow.passing, delta=1e-5)
            self.assertAlmostEqual(left_of_flow(flow.beta, 1) - left_of_flow(flow.beta, -1), flow.passing, delta=1e-5)
            self.assertAlmostEqual(left_of_flow(alpha, -1) - left_of_flow(alpha, 1), 1., delta=1e-5)
            self.assertAlmostEqual(0.5 * (left_of_flow(alpha, 1) + left_of_flow(alpha, -1)), -offset, delta=1e-5)

    def test_far_inside_it_is_an_infinite_plate(self):
        """Jet on an infinite plate: (1 - cos alpha)/2 flow backwards, the force is sin(alpha). What passes is still turned
        by less than the whole angle, pi - beta, which at 90 degrees falls by exp(-pi) for every D, faster below: 1.4e-6 at 5 D."""
        for angle in (36.4, 60., 90.):
            alpha = math.radians(angle)
            flow = edge_flow(alpha, -5.)
            self.assertAlmostEqual(flow.passing, 0.5 * (1. - math.cos(alpha)), delta=1e-5)
            self.assertAlmostEqual(flow.force, math.sin(alpha), delta=1e-5)

    def test_an_edge_that_just_touches_leaves_the_jet_alone(self):
        """beta -> alpha: with 1e-7 rad the offset differs from D/2 by that times its logarithm, 2e-6."""
        for alpha in map(math.radians, (36.4, 90., 130.)):
            flow = EdgeFlow(alpha, alpha + 1e-7)
            self.assertAlmostEqual(flow.offset, 0.5, delta=1e-5)
            self.assertAlmostEqual(flow.passing, 1., delta=1e-5)
            self.assertAlmostEqual(flow.force, 0., delta=1e-5)

    def test_finds_the_flow_of_an_offset(self):
        for alpha, offset in CASES:
            self.assertAlmostEqual(edge_flow(alpha, offset).offset, offset, delta=1e-12)

    def test_refuses_what_does_not_meet(self):
        self.assertRaises(ValueError, edge_flow, 0., 0.)
        self.assertRaises(ValueError, edge_flow, math.pi, 0.)
        self.assertRaises(ValueError, edge_flow, 1., 0.5)


if __name__ == "__main__":
    unittest.main()
