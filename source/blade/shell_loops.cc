#include <birdstrike/blade/shell_belytschko_tsay.h>
#include <birdstrike/blade/shell_implementation.h>
#include <birdstrike/blade/shell_step_bound.h>

namespace birdstrike
{
  namespace
  {
    // about 10 us of work: less is not worth the wake-up of another thread
    constexpr std::size_t node_grain = 512;
  } // namespace

  void ShellElements::Implementation::load_corners(const std::size_t batch, double (NodeRecord::*member)[3],
                                                   CornerVectors    &result) const
  {
    alignas(64) double buffer[4][3][n_lanes];
    for (std::size_t k = 0; k < n_lanes; ++k)
      {
        const auto &nodes = cells[std::min(batch * n_lanes + k, cells.size() - 1)];
        for (int i = 0; i < 4; ++i)
          for (int c = 0; c < 3; ++c)
            buffer[i][c][k] = (records[nodes[i]].*member)[c];
      }
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < 3; ++c)
        result[i][c] = load<Lanes>(buffer[i][c]);
  }

  void ShellElements::Implementation::update_normal(const std::size_t node)
  {
    NodeRecord  &record = records[node];
    const double x = record.position[0], y = record.position[1], z = record.position[2];
    double       n[3] = {0., 0., 0.};
    for (std::size_t k = corner_begin[node]; k < corner_begin[node + 1]; ++k)
      {
        const double *a = records[corners[k].next].position, *b = records[corners[k].previous].position;
        const double  ax = a[0] - x, ay = a[1] - y, az = a[2] - z;
        const double  bx = b[0] - x, by = b[1] - y, bz = b[2] - z;
        n[0] += ay * bz - az * by;
        n[1] += az * bx - ax * bz;
        n[2] += ax * by - ay * bx;
      }
    if (!symmetry.empty())
      for (const Point3 &plane : symmetry[node])
        {
          const double component = n[0] * plane[0] + n[1] * plane[1] + n[2] * plane[2];
          for (int c = 0; c < 3; ++c)
            n[c] -= component * plane[c];
        }
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const double scale  = square > 0. ? 1. / std::sqrt(square) : 0.;
    for (int c = 0; c < 3; ++c)
      {
        const double normal       = scale * n[c];
        record.midpoint_normal[c] = 0.5 * (record.normal[c] + normal);
        record.normal[c]          = normal;
      }
  }

  void ShellElements::Implementation::update_nodes(const double *position, const double *increment)
  {
    pool.parallel_for(n_nodes, node_grain, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        for (int c = 0; c < 3; ++c)
          {
            records[n].position[c]  = position[3 * n + c];
            records[n].increment[c] = increment[6 * n + c];
            records[n].rotation[c]  = increment[6 * n + 3 + c];
          }
    });
    pool.parallel_for(n_nodes, node_grain, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        update_normal(n);
    });
  }

  void ShellElements::Implementation::promote(const std::size_t batch)
  {
    points[batch].resize(law.rule.n);
    law.promote(batches[batch].stress, points[batch].data());
  }

  namespace
  {
    template <bool physical, class Corners>
    ShellVector<Lanes> compute_strain_increments(const ShellGeometry<Lanes> &midpoint, const Lanes &thickness,
                                                 const double hourglass_coefficient, const Corners &increment,
                                                 const Corners &rotation, [[maybe_unused]] const Corners &normal)
    {
      if constexpr (physical)
        {
          Vector3<Lanes> director[4];
          for (int i = 0; i < 4; ++i)
            director[i] = rotation[i].cross(midpoint.director[i]);
          return physical_shell::compute_strains(midpoint, ShellModes<Lanes>::of_corners(increment),
                                                 ShellModes<Lanes>::of_corners(director));
        }
      else
        return BelytschkoTsay<Lanes>(midpoint, thickness, hourglass_coefficient)
          .compute_strains(increment, rotation, normal);
    }

    template <bool physical, class Corners>
    void compute_corner_forces(const ShellGeometry<Lanes> &end, const ShellStress<Lanes> &stress,
                               const double hourglass_coefficient, [[maybe_unused]] const Corners &normal,
                               Corners &force, Corners &moment)
    {
      const ShellVector<Lanes> resultants = compute_resultants(stress);
      if constexpr (physical)
        {
          ShellModes<Lanes> f, fd;
          Vector3<Lanes>    director_force[4];
          physical_shell::compute_mode_forces(end, resultants, f, fd);
          f.corner_shares(force);
          fd.corner_shares(director_force);
          for (int i = 0; i < 4; ++i)
            moment[i] = end.director[i].cross(director_force[i]);
        }
      else
        BelytschkoTsay<Lanes>(end, stress.thickness, hourglass_coefficient)
          .compute_corner_forces(resultants, normal, force, moment);
    }
  } // namespace

  // One body, although long: all of it works on the same registers.
  template <bool physical>
  void ShellElements::Implementation::update_batch_as(const std::size_t b, const double dt)
  {
    Batch        &batch = batches[b];
    CornerVectors position, increment, rotation, normal, middle;
    load_corners(b, &NodeRecord::position, position);
    load_corners(b, &NodeRecord::increment, increment);
    load_corners(b, &NodeRecord::rotation, rotation);
    load_corners(b, &NodeRecord::midpoint_normal, normal);

    for (int i = 0; i < 4; ++i)
      middle[i] = position[i] - Lanes(0.5) * increment[i];
    const auto midpoint = ShellGeometry<Lanes>::of_corners(middle, normal);
    const auto strain   = compute_strain_increments<physical>(midpoint, batch.stress.thickness,
                                                            section.hourglass_coefficient, increment, rotation, normal);
    if (points[b].empty() && any(law.has_yielded(batch.stress, strain, initial_yield)))
      promote(b);
    const auto work = law.update(strain, dt, batch.stress,
                                 points[b].empty() ? nullptr : static_cast<ShellPoint<Lanes> *>(points[b].data()));

    load_corners(b, &NodeRecord::normal, normal);
    const auto    end = ShellGeometry<Lanes>::of_corners(position, normal);
    CornerVectors force, moment;
    compute_corner_forces<physical>(end, batch.stress, section.hourglass_coefficient, normal, force, moment);

    Lanes nodal_work = 0.;
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < 3; ++c)
        {
          nodal_work += (batch.force[i][c] + force[i][c]) * increment[i][c];
          nodal_work += (batch.force[i][3 + c] + moment[i][c]) * rotation[i][c];
          batch.force[i][c]     = force[i][c];
          batch.force[i][3 + c] = moment[i][c];
        }
    batch.work += 0.5 * nodal_work;
    batch.plastic += midpoint.area * work.plastic;
    batch.hourglass += midpoint.area * work.hourglass;
    batch.area       = end.area;
    batch.eigenvalue = compute_eigenvalue_bound(end, batch.stress.thickness, Lanes(batch.mass), law);
  }

  void ShellElements::Implementation::update_batch(const std::size_t batch, const double dt)
  {
    if (section.formulation == ShellFormulation::one_point_physical)
      update_batch_as<true>(batch, dt);
    else
      update_batch_as<false>(batch, dt);
  }

  void ShellElements::Implementation::gather_forces(double *force) const
  {
    pool.parallel_for(n_nodes, node_grain, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        {
          double sum[6] = {0., 0., 0., 0., 0., 0.};
          for (std::size_t k = corner_begin[n]; k < corner_begin[n + 1]; ++k)
            {
              const Batch      &batch = batches[corners[k].element / n_lanes];
              const std::size_t l     = corners[k].element % n_lanes;
              for (int c = 0; c < 6; ++c)
                sum[c] -= lane(batch.force[corners[k].corner][c], l);
            }
          for (int c = 0; c < 6; ++c)
            force[6 * n + c] = sum[c];
        }
    });
  }
} // namespace birdstrike
