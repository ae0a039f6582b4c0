#pragma once

#include "structure/elements/shell/group.h"

namespace birdstrike
{
  // What the loops over batches share, whatever the formulation.

  using Corners = Vector3<Lanes>[4];

  /// The records of the corners of a batch, transposed.
  struct BatchNodes
  {
    Corners position, increment, rotation, midpoint_normal, normal;

    [[gnu::always_inline]] BatchNodes(const double *records, const std::uint32_t (&begin)[4][n_lanes])
    {
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i)
        {
          const auto a = load_rows(records, begin[i]), b = load_rows(records + 8, begin[i]);
          position[i] << a[0], a[1], a[2];
          increment[i] << a[3], a[4], a[5];
          rotation[i] << a[6], a[7], b[0];
          midpoint_normal[i] << b[1], b[2], b[3];
          normal[i] << b[4], b[5], b[6];
        }
    }
  };

  /// At t^{n+1/2}: x - u/2 with the mean of the normals.
  [[gnu::always_inline]] inline ShellGeometry<Lanes> compute_midpoint(const ShellModes<Lanes> &x,
                                                                      const ShellModes<Lanes> &u, const Corners &normal)
  {
    const Lanes half = 0.5;
    return ShellGeometry<Lanes>::of_modes({x.m0, x.m1 - half * u.m1, x.m2 - half * u.m2, x.m3 - half * u.m3}, normal);
  }

  /// Increments of the directors over a step, by modes.
  [[gnu::always_inline]] inline ShellModes<Lanes> turn_directors(const ShellGeometry<Lanes> &midpoint,
                                                                 const BatchNodes           &nodes)
  {
    Corners turned;
    for (int i = 0; i < 4; ++i)
      turned[i] = nodes.rotation[i].cross(midpoint.director[i]);
    return ShellModes<Lanes>::of_corners(turned);
  }

  /// Its transpose: forces (N) and moments (N m) at the corners from forces f on the modes of the middle and fd on
  /// those of the directors.
  [[gnu::always_inline]] inline void sum_corner_forces(const ShellGeometry<Lanes> &end, const ShellModes<Lanes> &f,
                                                       const ShellModes<Lanes> &fd, Corners (&force)[2])
  {
    Corners director_force;
    f.sum_at_corners(force[0]);
    fd.sum_at_corners(director_force);
    for (int i = 0; i < 4; ++i)
      force[1][i] = end.director[i].cross(director_force[i]);
  }

  [[gnu::always_inline]] inline void store_corner_forces(const Corners (&force)[2],
                                                         const std::uint32_t (&corner)[4][n_lanes], Row *rows)
  {
    const Lanes zero = 0.;
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i)
      {
        const Vector3<Lanes> &f = force[0][i], &m = force[1][i];
        store_rows({f[0], f[1], f[2], m[0], m[1], m[2], zero, zero}, corner[i], rows);
      }
  }

  /// Neither infinite nor NaN.
  [[gnu::always_inline]] inline LanesMask is_finite(const Corners (&force)[2], const Lanes &eigenvalue)
  {
    const Lanes total = force[0][0].sum() + force[0][1].sum() + force[1][0].sum() + force[1][1].sum() +
                        force[1][2].sum() + force[1][3].sum() + eigenvalue;
    return total - total == Lanes(0.);
  }
} // namespace birdstrike
