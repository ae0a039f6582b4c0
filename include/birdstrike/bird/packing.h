#pragma once

#include <birdstrike/bird/shape.h>
#include <birdstrike/core/symmetry_plane.h>

#include <array>
#include <string>
#include <vector>

namespace birdstrike
{
  /// The particles of an undeformed bird, placed: a lattice that is symmetric about the bird's axis, cut by the shape
  /// and scaled so that every particle holds exactly mass/n at exactly the given density: V_p = spacing^3 = m/(n rho).
  /// Mass and density are therefore exact. So are the length of a cylinder, which a whole number of layers fills that
  /// are nearly as far apart as the particles within them, and its cross-section; other shapes have dimensions that
  /// differ slightly from the nominal ones, by less than half a layer at each end. A slice is packed likewise, its
  /// lattice symmetric about its middle and along its planes, at its place in the bird.
  struct Packing
  {
    std::vector<Point3>   points;               ///< m
    double                particle_mass   = 0.; ///< kg
    double                spacing         = 0.; ///< m, cube root of the particle volume
    double                length          = 0.; ///< m, achieved; of a slice across its planes
    double                diameter        = 0.; ///< m, achieved: of the circle as large as the largest cross-section
    double                bounding_radius = 0.; ///< m, about the centre of the whole bird
    std::array<double, 3> period{};             ///< m, 0 where not periodic
    Point3                axis;                 ///< unit vector of the bird's axis
    Point3                centre;               ///< m, at the start, of the whole bird

    SymmetryPlane plane; ///< beyond which there are as many points

    double mass() const ///< kg, of the whole
    {
      return plane.whole(particle_mass * points.size());
    }
    /// One line: particles, spacing, achieved mass, nominal and achieved dimensions.
    std::string summary(const Shape &shape) const;
  };

  /// Particles of the whole bird before it is packed: its volume over that of one; of a slab exactly. The lattice's cut
  /// of a round shape differs from it by less than a sixth of the particles in its outermost layer.
  double count_particles(const BirdParameters &parameters);

  /// Packs the shape, turns it to its attitude and puts it at its start, from which its centre flies through the aim
  /// point. Throws InputError if the shape holds no particle, for a slice that misses the bird or is thinner than two
  /// particles, or if a period is shorter than two interaction ranges.
  Packing compute_packing(const BirdParameters &parameters, const Shape &shape);
} // namespace birdstrike
