#!/usr/bin/env python3
"""A plane jet of an ideal liquid that the edge of a plate cuts in two: exact steady flow by the hodograph.

    free_streamlines.py [--angle 36.4] [--offset 0,0.25]      table of share, deflection and force

A jet of width D and speed U meets, at the angle alpha to it, a plate that starts at its edge and goes on for ever; the
edge lies at e from the jet's axis, positive where it leaves more of the jet in the open: at e = D/2 it just touches.
Part of the jet is caught and leaves along the plate, the rest passes the edge, turned by delta away from the plate.

Helmholtz and Kirchhoff (Milne-Thomson, Theoretical Hydrodynamics, ch. 11; Birkhoff and Zarantonello, Jets, Wakes, and
Cavities, 1957, ch. 2): the plate lies on x > 0, the edge in the origin, and the liquid comes from above. In units of U
and D let zeta = u - i v. The speed is 1 on every free streamline, v is 0 on the plate, so the liquid fills the upper
half of the disc |zeta| < 1 once: its inside is a source at a = exp(i alpha), the jet; a sink of m1 at 1, the caught
stream; and a sink of m2 = 1 - m1 at b = exp(i beta), the passing one, beta = alpha + delta; the edge is -1 and the
stagnation point 0. With the images below the real axis the complex potential is

  pi F = log((zeta - a)(zeta - 1/a)) - m2 log((zeta - b)(zeta - 1/b)) - 2 m1 log(zeta - 1).

dz = dF/zeta is regular at the stagnation point if F' = 0 there, which is the balance of momentum along the plate,

  cos(alpha) = m1 + m2 cos(beta),   so   m2 = (1 - cos alpha)/(1 - cos beta),   alpha < beta < pi,

and then z is elementary. With l(c) = log((1 - zeta/c)/(1 + 1/c)), which is regular in the disc,

  pi z = l(a)/a + a l(1/a) - m2 (l(b)/b + b l(1/b)) - 2 m1 l(1).

Towards the jet, zeta -> a along the radius, which is the jet's middle streamline by the symmetry of a source, a z runs
along the jet and Im(a z) tends to the distance of the axis from the edge: e(beta). It leaves 1/2 at beta = alpha, may
first exceed it (by 0.0025 at 90 degrees: the jet still swells towards an edge that would just miss it, as before a
planing plate) and falls to -infinity: below 1/2 there is one flow for each e. The force on the plate follows from the
balance across it: N/(rho U^2 D) = sin(alpha) - m2 sin(beta).
"""
import argparse
import cmath
import dataclasses
import math


@dataclasses.dataclass(frozen=True)
class EdgeFlow:
    """Jet at the angle alpha to the plate whose passing stream leaves at beta (radians); lengths in D, speeds in U."""

    alpha: float
    beta: float

    @property
    def passing(self):
        """Share m2 of the jet that passes the edge."""
        return (math.sin(self.alpha / 2) / math.sin(self.beta / 2)) ** 2

    @property
    def deflection(self):
        return self.beta - self.alpha

    @property
    def force(self):
        """On the plate, along its normal, in rho U^2 D."""
        return math.sin(self.alpha) - self.passing * math.sin(self.beta)

    @property
    def offset(self):
        """Edge from the axis of the jet: n of the edge, which is 0, less n of the axis, n = Im(a z)."""
        a = cmath.exp(1j * self.alpha)
        return -sum((a * strength / place * self._log(place, a)).imag
                    for strength, place in self._singularities() if place != a) / math.pi - self._axis_of_source(a)

    def position(self, zeta):
        """z where u - i v = zeta."""
        return sum(strength / place * self._log(place, zeta) for strength, place in self._singularities()) / math.pi

    def plate_stretch(self, speed):
        """dx/du on the plate, u its speed along it: F'/u, the simple zero of F' at 0 divided out."""
        return sum((strength / (place * (speed - place))).real for strength, place in self._singularities()) / math.pi

    def _singularities(self):
        a, b = cmath.exp(1j * self.alpha), cmath.exp(1j * self.beta)
        m2 = self.passing
        return ((1., a), (1., a.conjugate()), (-m2, b), (-m2, b.conjugate()), (-2. * (1. - m2), 1. + 0j))

    @staticmethod
    def _log(place, zeta):
        return cmath.log(1 - zeta / place) - cmath.log(1 + 1 / place)

    @staticmethod
    def _axis_of_source(a):
        """What the source itself adds to Im(a z) on the radius, where log(1 - zeta/a) is real."""
        return -cmath.log(1 + 1 / a).imag / math.pi


def edge_flow(alpha, offset):
    """The flow with the edge at `offset` (in D) from the axis of the jet; alpha in radians, between 0 and pi."""
    if not 0. < alpha < math.pi:
        raise ValueError(f"a jet at {alpha} rad to the plate does not meet it")
    if offset >= 0.5:
        raise ValueError(f"an edge {offset} D from the axis leaves the jet alone")
    low, high = alpha, math.pi # e falls with beta
    while True:
        beta = 0.5 * (low + high)
        if beta in (low, high):
            return EdgeFlow(alpha, beta)
        low, high = (beta, high) if EdgeFlow(alpha, beta).offset > offset else (low, beta)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--angle", default="36.4,90", help="degrees between jet and plate")
    parser.add_argument("--offset", default="-1,-0.5,-0.25,0,0.25,0.4", help="edge from the jet's axis, in D")
    arguments = parser.parse_args()
    print("alpha, deg      e/D   passing m2   deflection, deg   N/(rho U^2 D)")
    for angle in map(float, arguments.angle.split(",")):
        for offset in map(float, arguments.offset.split(",")):
            flow = edge_flow(math.radians(angle), offset)
            print(f"{angle:10g} {offset:8g} {flow.passing:12.4f} {math.degrees(flow.deflection):17.3f} {flow.force:15.4f}")


if __name__ == "__main__":
    main()
