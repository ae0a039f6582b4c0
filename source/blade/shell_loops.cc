#include <birdstrike/blade/shell_belytschko_tsay.h>
#include <birdstrike/blade/shell_implementation.h>
#include <birdstrike/blade/shell_step_bound.h>

namespace birdstrike
{
  namespace
  {
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
            Lanes a[8], b[8];
            load_rows(records, begin[i], a);
            load_rows(records + 8, begin[i], b);
            position[i] << a[0], a[1], a[2];
            increment[i] << a[3], a[4], a[5];
            rotation[i] << a[6], a[7], b[0];
            midpoint_normal[i] << b[1], b[2], b[3];
            normal[i] << b[4], b[5], b[6];
          }
      }
    };

    /// At t^{n+1/2}: x - u/2 with the mean of the normals.
    [[gnu::always_inline]] inline ShellGeometry<Lanes>
    compute_midpoint(const ShellModes<Lanes> &x, const ShellModes<Lanes> &u, const Corners &normal)
    {
      const Lanes half = 0.5;
      return ShellGeometry<Lanes>::of_modes({x.m0, x.m1 - half * u.m1, x.m2 - half * u.m2, x.m3 - half * u.m3}, normal);
    }

    template <bool physical>
    [[gnu::always_inline]] inline ShellVector<Lanes>
    compute_strain_increments(const ShellGeometry<Lanes> &midpoint, const Lanes &thickness,
                              const double hourglass_coefficient, const ShellModes<Lanes> &u, const BatchNodes &nodes)
    {
      if constexpr (physical)
        {
          Corners director;
          for (int i = 0; i < 4; ++i)
            director[i] = nodes.rotation[i].cross(midpoint.director[i]);
          return physical_shell::compute_strains(midpoint, u, ShellModes<Lanes>::of_corners(director));
        }
      else
        return BelytschkoTsay<Lanes>(midpoint, thickness, hourglass_coefficient)
          .compute_strains(nodes.increment, nodes.rotation, nodes.midpoint_normal);
    }

    template <bool physical>
    [[gnu::always_inline]] inline void
    compute_corner_forces(const ShellGeometry<Lanes> &end, const ShellStress<Lanes> &stress,
                          const double hourglass_coefficient, const Corners &normal, Corners (&force)[2])
    {
      const ShellVector<Lanes> resultants = compute_resultants(stress);
      if constexpr (physical)
        {
          ShellModes<Lanes> f, fd;
          Corners           director_force;
          physical_shell::compute_mode_forces(end, resultants, f, fd);
          f.sum_at_corners(force[0]);
          fd.sum_at_corners(director_force);
          for (int i = 0; i < 4; ++i)
            force[1][i] = end.director[i].cross(director_force[i]);
        }
      else
        BelytschkoTsay<Lanes>(end, stress.thickness, hourglass_coefficient)
          .compute_corner_forces(resultants, normal, force[0], force[1]);
    }

    [[gnu::always_inline]] inline void store_corner_forces(const Corners (&force)[2],
                                                           const std::uint32_t (&corner)[4][n_lanes], Row *rows)
    {
      const Lanes zero = 0.;
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i)
        {
          const Vector3<Lanes> &f = force[0][i], &m = force[1][i];
          const Lanes           row[8] = {f[0], f[1], f[2], m[0], m[1], m[2], zero, zero};
          store_rows(row, corner[i], rows);
        }
    }
  } // namespace

  // Apart, so that the elastic path has the registers for itself.
  [[gnu::noinline, gnu::flatten]] ShellWork<Lanes>
  ShellElements::Implementation::update_points(const std::size_t b, const ShellVector<Lanes> &strain, const double dt)
  {
    if (points[b].empty())
      promote(b);
    return law.update_plastic(strain, dt, batches[b].stress, points[b].data());
  }

  // One body, although long: all of it works on the same registers. Without `flatten` GCC leaves the vector operations
  // of Eigen as calls with their operands in memory, at three times the cost.
  template <bool physical>
  [[gnu::flatten]] void ShellElements::Implementation::update_batch(const std::size_t b, const double dt, Chunk &chunk)
  {
    Batch           &batch = batches[b];
    const BatchNodes nodes(records[0].position, batch.record);

    const auto x        = ShellModes<Lanes>::of_corners(nodes.position);
    const auto u        = ShellModes<Lanes>::of_corners(nodes.increment);
    const auto midpoint = compute_midpoint(x, u, nodes.midpoint_normal);
    const auto strain =
      compute_strain_increments<physical>(midpoint, batch.stress.thickness, section.hourglass_coefficient, u, nodes);
    ShellWork<Lanes> work;
    if (!points[b].empty() || !law.update_elastic(strain, initial_yield, batch.stress, work))
      work = update_points(b, strain, dt);

    const auto end   = ShellGeometry<Lanes>::of_modes(x, nodes.normal);
    batch.eigenvalue = compute_eigenvalue_bound(end, batch.stress.thickness, batch.inverse_mass, law);
    chunk.eigenvalue = max(chunk.eigenvalue, batch.eigenvalue);
    Corners force[2];
    compute_corner_forces<physical>(end, batch.stress, section.hourglass_coefficient, nodes.normal, force);
    store_corner_forces(force, batch.corner, corner_force.data());

    Lanes area = midpoint.area;
    if (b + 1 == batches.size()) // copies of the last element do not count
      area = select(Lanes([](const auto k) { return double(k); }) < Lanes(double(n_elements_of(b))), area, Lanes(0.));
    chunk.plastic += area * work.plastic;
    chunk.hourglass += area * work.hourglass;

    const Lanes total = force[0][0].sum() + force[0][1].sum() + force[1][0].sum() + force[1][1].sum() +
                        force[1][2].sum() + force[1][3].sum() + batch.eigenvalue;
    if (!all((total - total == Lanes(0.)) && (end.area > Lanes(0.))))
      report_failure(b);
  }

  void ShellElements::Implementation::update_chunk(const std::size_t c, const double dt)
  {
    const std::size_t end   = std::min(batches.size(), (c + 1) * batches_per_chunk);
    Chunk            &chunk = chunks[c];
    chunk.eigenvalue        = Lanes(0.);
    for (std::size_t b = c * batches_per_chunk; b < end; ++b)
      if (section.formulation == ShellFormulation::one_point_physical)
        update_batch<true>(b, dt, chunk);
      else
        update_batch<false>(b, dt, chunk);
  }
} // namespace birdstrike
