#pragma once

#include <birdstrike/bird/particles.h>
#include <birdstrike/core/box.h>

#include <cstddef>
#include <functional>

namespace birdstrike
{
  /// What particles that left the computation took with them.
  struct RetiredShare
  {
    std::size_t particles = 0;
    double      energy    = 0.;       ///< J: kinetic, stored and dissipated
    double      made      = 0.;       ///< J, stored and dissipated less what the energy equation has
    Point3      momentum{0., 0., 0.}; ///< N s
    Point3      moment{0., 0., 0.};   ///< N m s, their angular momentum about the origin
    Point3      force{0., 0., 0.};    ///< N, of the particles on each other, whose next half kick is still to be booked
    Point3      torque{0., 0., 0.};   ///< N m, of the same about the origin

    void add(const RetiredShare &other)
    {
      particles += other.particles;
      energy += other.energy;
      made += other.made;
      momentum += other.momentum;
      moment += other.moment;
      force += other.force;
      torque += other.torque;
    }
    /// The half kick (s) that was still to be booked.
    void kick(const double half_step)
    {
      momentum += half_step * force;
      moment += half_step * torque;
      force.setZero();
      torque.setZero();
    }
  };

  /// Removes particles whose ballistic path misses `box` and that are loose: alone within their support, or cavitated
  /// (mu < -0.01) with only cavitated neighbours, where tension is cut off: else such liquid pulls. Unstrained liquid
  /// never counts as loose, so that a release wave from the strike still finds it. Columns are compacted in order;
  /// neighbour lists made before become invalid. `specific_energy` is what a particle stores (J/kg); without it, the
  /// energy equation's.
  RetiredShare retire_particles(Particles &particles, const Box &box,
                                const std::function<double(std::size_t p)> &specific_energy = {},
                                bool                                        has_cutoff      = true);
} // namespace birdstrike
