#pragma once

#include "structure/elements/shell/batch.h"
#include "structure/elements/shell/full_integration.h"

namespace birdstrike
{
  // What the loops over fully integrated elements share, whatever the section's law.

  namespace full_integration
  {
    /// What each point is strained by in a step.
    [[gnu::always_inline]] inline void compute_strain_increments(const PlaneGeometry<Lanes> &plane,
                                                                 const ShellGeometry<Lanes> &midpoint,
                                                                 const ShellModes<Lanes> &u, const BatchNodes &nodes,
                                                                 SectionVector<Lanes> (&strain)[n_points])
    {
      compute_point_strains(plane, DirectorGradient<Lanes>(midpoint),
                            compute_strains(midpoint, u, turn_directors(midpoint, nodes)), strain);
    }

    /// Forces (N) and moments (N m) at the corners from the resultants of each point.
    [[gnu::always_inline]] inline void compute_corner_forces(const PlaneGeometry<Lanes> &plane,
                                                             const ShellGeometry<Lanes> &end,
                                                             const SectionVector<Lanes> (&resultants)[n_points],
                                                             Corners (&force)[2])
    {
      ShellModes<Lanes> f, fd;
      compute_mode_forces(end, integrate_resultants(plane, DirectorGradient<Lanes>(end), resultants), f, fd);
      sum_corner_forces(end, f, fd, force);
    }

    /// Neither infinite nor NaN, nor turned over, nor folded at a point.
    [[gnu::always_inline]] inline bool is_sound(const PlaneGeometry<Lanes> &plane, const ShellGeometry<Lanes> &end,
                                                const Corners &normal, const Corners (&force)[2], const Lanes &bound)
    {
      return all(is_finite(force, bound) && (end.area > Lanes(0.)) && looks_along(normal, end.e3) &&
                 (plane.smallest_jacobian > Lanes(0.)));
    }
  } // namespace full_integration
} // namespace birdstrike
