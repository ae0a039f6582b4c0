#pragma once

#include <birdstrike/bird/particles.h>

#include <cstddef>

namespace birdstrike
{
  /// Axis-parallel box, m.
  struct Box3
  {
    Point3 lower, upper;
  };

  /// What particles that left the computation took with them.
  struct RetiredShare
  {
    std::size_t particles = 0;
    double      energy    = 0.;       ///< J, kinetic and internal
    Point3      momentum{0., 0., 0.}; ///< N s
    Point3      force{0., 0., 0.};    ///< N, of the particles on each other, whose next half kick is still to be booked
  };

  /// Whether the straight path x + v t, t >= 0, meets the box.
  bool meets_box(const Point3 &x, const Point3 &v, const Box3 &box);

  /// Removes particles whose ballistic path misses `box` and that are loose: alone within their support, or cavitated
  /// (mu < -0.01) with only cavitated neighbours. Unstrained liquid never counts as loose, so that a release wave from
  /// the strike still finds it. Columns are compacted in order; neighbour lists made before become invalid.
  RetiredShare retire_particles(Particles &particles, const Box3 &box);
} // namespace birdstrike
