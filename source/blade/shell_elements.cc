#include <birdstrike/blade/shell_implementation.h>
#include <birdstrike/blade/shell_step_bound.h>
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace birdstrike
{
  namespace
  {
    std::string text(const double value)
    {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "%.6g", value);
      return buffer;
    }

    std::string place(const std::size_t element, const Vector3<double> &x)
    {
      return "element " + std::to_string(element) + " at (" + text(x[0]) + ", " + text(x[1]) + ", " + text(x[2]) + ")";
    }
  } // namespace

  ShellElements::Implementation::Implementation(std::vector<Point3>                       nodes,
                                                std::vector<std::array<std::uint32_t, 4>> cells,
                                                const std::vector<double> &thickness, const ShellSection &section,
                                                ThreadPool &pool)
    : section(section)
    , law(section)
    , initial_yield(law.initial_yield())
    , pool(pool)
    , n_nodes(nodes.size())
    , cells(std::move(cells))
    , records(nodes.size())
    , mass_ratio(this->cells.size(), 1.)
  {
    if (this->cells.empty() || thickness.size() != this->cells.size())
      throw InputError("Shell elements: " + std::to_string(this->cells.size()) + " elements with " +
                       std::to_string(thickness.size()) +
                       " thicknesses; at least one element, and one thickness for each.");
    for (std::size_t n = 0; n < n_nodes; ++n)
      for (int c = 0; c < 3; ++c)
        records[n].position[c] = nodes[n][c];
    build_corners();
    for (std::size_t n = 0; n < n_nodes; ++n)
      update_normal(n);
    build_batches(thickness);
  }

  void ShellElements::Implementation::build_corners()
  {
    corner_begin.assign(n_nodes + 1, 0);
    for (const auto &cell : cells)
      for (const auto node : cell)
        {
          if (node >= n_nodes)
            throw InputError("Shell elements: a cell names node " + std::to_string(node) + " of " +
                             std::to_string(n_nodes) + ".");
          ++corner_begin[node + 1];
        }
    for (std::size_t n = 0; n < n_nodes; ++n)
      corner_begin[n + 1] += corner_begin[n];
    corners.resize(4 * cells.size());
    std::vector<std::size_t> next(corner_begin.begin(), corner_begin.end() - 1);
    for (std::uint32_t e = 0; e < cells.size(); ++e)
      for (std::uint32_t i = 0; i < 4; ++i)
        corners[next[cells[e][i]]++] = {cells[e][(i + 1) % 4], cells[e][(i + 3) % 4], e, i};
  }

  void ShellElements::Implementation::build_batches(const std::vector<double> &thickness)
  {
    const std::size_t n_batches = (cells.size() + n_lanes - 1) / n_lanes;
    batches.resize(n_batches);
    points.resize(n_batches);
    for (std::size_t b = 0; b < n_batches; ++b)
      {
        Batch &batch = batches[b];
        batch        = Batch();
        for (std::size_t k = 0; k < n_lanes; ++k)
          {
            const std::size_t           e        = std::min(b * n_lanes + k, cells.size() - 1);
            const ShellGeometry<double> g        = geometry(e);
            double                      shortest = std::numeric_limits<double>::infinity();
            for (int i = 0; i < 4; ++i)
              for (int j = 0; j < i; ++j)
                {
                  const double *x = records[cells[e][i]].position, *y = records[cells[e][j]].position;
                  shortest = std::min(shortest, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
                }
            if (!(thickness[e] > 0.) || !(g.area > 1e-6 * g.x.m1.squaredNorm()) || !(shortest > 0.))
              throw InputError("Shell " + place(e, g.x.m0) + ": thickness " + text(thickness[e]) + " m, area " +
                               text(g.area) + " m^2, shortest distance of two nodes " + text(shortest) +
                               " m; all must be positive.");
            batch.stress.thickness[k] = thickness[e];
            batch.area[k]             = g.area;
            batch.mass[k]             = section.material.density * thickness[e] * g.area;
            batch.eigenvalue[k]       = compute_eigenvalue_bound(g, thickness[e], double(batch.mass[k]), law);
          }
      }
  }

  ShellGeometry<double> ShellElements::Implementation::geometry(const std::size_t element) const
  {
    Vector3<double> x[4], n[4];
    for (int i = 0; i < 4; ++i)
      for (int c = 0; c < 3; ++c)
        {
          x[i][c] = records[cells[element][i]].position[c];
          n[i][c] = records[cells[element][i]].normal[c];
        }
    return ShellGeometry<double>::of_corners(x, n);
  }

  void ShellElements::Implementation::check(const std::size_t b) const
  {
    const Lanes total = batches[b].work + batches[b].area;
    if (all(total - total == Lanes(0.)) && all(batches[b].area > Lanes(0.)))
      return;
    for (std::size_t k = 0; k < n_lanes && b * n_lanes + k < cells.size(); ++k)
      if (!std::isfinite(double(total[k])) || !(batches[b].area[k] > 0.))
        throw NumericalFailure("Shell " + place(b * n_lanes + k, geometry(b * n_lanes + k).x.m0) +
                               ": force or area is not finite (area " + text(batches[b].area[k]) +
                               " m^2).\nThe step was too large or the element collapsed: reduce the step factor.");
  }

  double ShellElements::Implementation::sum(Lanes Batch::*energy) const
  {
    return pool.ordered_sum(cells.size(), [&](const std::size_t begin, const std::size_t end) {
      double result = 0.;
      for (std::size_t e = begin; e < end; ++e)
        result += lane(batches[e / n_lanes].*energy, e % n_lanes);
      return result;
    });
  }

  ShellElements::ShellElements(std::vector<Point3> nodes, std::vector<std::array<std::uint32_t, 4>> cells,
                               std::vector<double> thickness, const ShellSection &section, ThreadPool &pool)
    : implementation(
        std::make_unique<Implementation>(std::move(nodes), std::move(cells), std::move(thickness), section, pool))
  {
  }
  ShellElements::~ShellElements()                         = default;
  ShellElements::ShellElements(ShellElements &&) noexcept = default;

  void ShellElements::add_symmetry_plane(const std::span<const std::uint32_t> nodes, const Point3 &plane_normal)
  {
    Implementation &my = *implementation;
    my.symmetry.resize(my.n_nodes);
    for (const auto node : nodes)
      {
        my.symmetry.at(node).push_back(plane_normal.normalized());
        my.update_normal(node);
      }
  }

  void ShellElements::compute_internal_forces(const double *position, const double *increment, const double dt,
                                              double *force)
  {
    Implementation &my = *implementation;
    my.update_nodes(position, increment);
    // a batch takes 0.7 us: 16 of them are worth the wake-up of another thread
    my.pool.parallel_for(my.batches.size(), 16, [&](const std::size_t begin, const std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        {
          my.update_batch(b, dt);
          my.check(b);
        }
    });
    my.gather_forces(force);
  }

  StepLimit ShellElements::step_limit() const
  {
    const Implementation &my      = *implementation;
    double                largest = 0.;
    std::size_t           worst   = 0;
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      {
        const double value = lane(my.batches[e / n_lanes].eigenvalue, e % n_lanes) / my.mass_ratio[e];
        if (value > largest)
          {
            largest = value;
            worst   = e;
          }
      }
    const Point3 centre = my.geometry(worst).x.m0;
    return {2. / std::sqrt(largest),
            "shell element, largest eigenvalue",
            {"element", worst, {{centre[0], centre[1], centre[2]}}}};
  }

  void ShellElements::use_nodal_masses(const std::span<const double> mass)
  {
    Implementation           &my       = *implementation;
    const std::vector<double> quarters = compute_nodal_masses();
    if (mass.size() != quarters.size())
      throw InputError("Shell elements: " + std::to_string(mass.size()) + " nodal masses for " +
                       std::to_string(quarters.size()) + " nodes.");
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      {
        my.mass_ratio[e] = 1.;
        for (const auto n : my.cells[e])
          my.mass_ratio[e] = std::min(my.mass_ratio[e], mass[n] / quarters[n]);
      }
  }

  std::vector<double> ShellElements::compute_nodal_masses() const
  {
    const Implementation &my = *implementation;
    std::vector<double>   mass(my.n_nodes, 0.);
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      for (const auto n : my.cells[e])
        mass[n] += 0.25 * lane(my.batches[e / n_lanes].mass, e % n_lanes);
    return mass;
  }

  std::vector<double> ShellElements::compute_rotary_inertias() const
  {
    const Implementation &my = *implementation;
    std::vector<double>   inertia(my.n_nodes, 0.);
    for (std::size_t e = 0; e < my.cells.size(); ++e)
      {
        const auto  &batch = my.batches[e / n_lanes];
        const double t     = lane(batch.stress.thickness, e % n_lanes);
        const double r     = std::max(t * t / 12., lane(batch.area, e % n_lanes) / 8.);
        for (const auto n : my.cells[e])
          inertia[n] += 0.25 * r * lane(batch.mass, e % n_lanes);
      }
    return inertia;
  }
} // namespace birdstrike
