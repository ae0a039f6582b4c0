#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace birdstrike
{
  /// What an edge of the blade takes off the offset surface. Across the edge, s is the distance beyond it in the plane
  /// of a face, z the height above that face.
  ///
  /// A point stands for a cube of side L = V^(1/3): its centre stays L/2 off a face. Carried round an edge, that
  /// stand-off makes the body larger than it is by L/2 on every side, and what flies past is caught. So the stand-off
  /// belongs to the faces only, and each is bounded at its edge by the plane that halves the angle there and goes
  /// through the true edge (for a right angle s + z = 0): the depth is
  ///
  ///   d = min(L/2 - z - r, -(s + z)/sqrt(2)),   and nothing where either is negative.
  ///
  /// Behind that plane the other face holds in the same way; between the two nothing does. A shell's edge face, of its
  /// thickness at right angles to the middle surface, has no facets: a point beyond the rim and between the planes of
  /// the two faces meets it at d = min(L/2 - s - r, ...), and does so behind it, up to 0.75 L deep, until it leaves
  /// between the planes, so that shell and solid end alike.
  ///
  /// The plane stands at the edge, with the frame of the facet there, and its force acts on the edge's nodes: over a
  /// bent face its normal is not that below the point. It turns by the mean of what the two faces of a ridge turn, and
  /// L/2 grows again where they open (round_share): each carries half of the force, and what the depth's gradient by
  /// the turns of its own plane, through the edge and its centre, puts on its nodes (EdgeTurn).
  ///
  /// It bounds what lies behind it only: from a facet that stands out beyond it, as the floor beside a wall whose upper
  /// edge is sharp, it takes nothing.
  ///
  /// *Reference r.* A point that comes in through that plane keeps the height it then has as its stand-off: r is what
  /// of the overlap it brings along, and only what it comes deeper carries a force, in the step of its passage too, of
  /// which velocities tell the place in the plane (what a step happens to carry it past the plane decides nothing). So
  /// who is held is decided by whether the path meets the true outline, whatever the place of the lattice and the ratio
  /// of thickness to L: for paths along the normal of the face, inwards from the edge, and outwards by up to 15
  /// degrees. From 17.5 to 40 up to 0.35 L more is sent over the edge (where depths are L/50; at a fifth of the speed
  /// of sound 0.2 L from 10 degrees on, 0.05 along the normal); from 45 degrees on (L/2)(tan(phi) - 1) too many are
  /// held, in s. Inwards the face itself holds them. Along the normal the last strip of L/2 lies under the plane, which
  /// takes half of a free point's normal momentum (n_z^2 = 1/2) and sends it out over the edge, where a jet's own
  /// pressure sends it too. A rim round with radius L/2 holds L/2 too many.
  ///
  /// *Energy.* For given r the depth is continuous and piecewise plane, so k d^2/2 is a potential. r changes only where
  /// d = 0, or downwards with an overlap smaller than r (d = 0 again), or so that d falls: contact makes no energy.
  ///
  /// *Measured* against the plane jet of an ideal liquid (tests/studies/plane_jet.py), D wide, cut in its axis: the
  /// share that passes is right to 0.004 from D/12 on. The force exceeds the exact one by 0.008 rho U^2 D at D/8 and
  /// 0.004 at D/16 (of 0.425) at right angles, by 0.030 and 0.019 (of 0.178) at 36.4 degrees, where the stagnation
  /// point lies 0.008 D from the edge: the row that meets the plate there loses its normal velocity instead of turning.
  /// That is resolution; neither spring nor damper changes it by more than 0.004.
  ///
  /// How far over a face its edge is felt at most, for points of size L: the two planes meet at s = -L/2, and at a
  /// depth d below it (sqrt(2) - 1) d further in. m
  inline double edge_reach(const double size)
  {
    return 0.75 * size;
  }

  constexpr double level_below = 0.1; ///< w of round_share

  /// Share of the stand-off that goes on round a ridge between two faces whose normals part by `angle`: all of it below
  /// 30 degrees, where a ridge is the facetting of a round surface, none from 90 degrees on. In between it is
  /// c = cos(angle)/cos(30 degrees), but for c < w = 0.1, from 85 degrees on, c^2 (2 w - c)/w^2, which is as steep as c
  /// in w and level in 0: edges of boxes are right angles but for round-off, which must not say whether the depth
  /// follows the angle.
  inline double round_share(const double angle)
  {
    const double c = std::clamp(std::cos(angle) / std::cos(std::numbers::pi / 6.), 0., 1.), w = level_below;
    return c < w ? c * c * (2. * w - c) / (w * w) : c;
  }

  /// Its derivative by the angle, 1/rad.
  inline double round_share_slope(const double angle)
  {
    const double c = std::cos(angle) / std::cos(std::numbers::pi / 6.), w = level_below;
    if (!(c > 0. && c < 1.))
      return 0.;
    return (c < w ? c * (4. * w - 3. * c) / (w * w) : 1.) * -std::sin(angle) / std::cos(std::numbers::pi / 6.);
  }
} // namespace birdstrike
