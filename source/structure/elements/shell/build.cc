#include "structure/elements/shell/implementation.h"
#include "structure/elements/shell/plane_points.h"
#include "structure/elements/shell/step_bound.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
    , records(nodes.size() + (section.material.failure.can_fail() ? n_resting_records : 0))
    , node_force(nodes.size())
    , n_in_plane(section.formulation == ShellFormulation::fully_integrated ? full_integration::n_points : 1)
  {
    if (this->cells.empty() || thickness.size() != this->cells.size())
      throw InputError("Shell elements: " + std::to_string(this->cells.size()) + " elements with " +
                       std::to_string(thickness.size()) +
                       " thicknesses; at least one element, and one thickness for each.");
    build_corners();
    const std::vector<std::uint32_t> corner_row = build_blocks();
    const std::vector<double>        still(6 * n_nodes, 0.);
    for (const Block &block : blocks)
      update_nodes(block, nodes[0].data(), still.data());
    build_batches(thickness, corner_row);
    if (section.material.failure.can_fail())
      build_erosion();
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
    std::vector<std::uint32_t> next(corner_begin.begin(), corner_begin.end() - 1);
    for (const auto &cell : cells)
      for (std::uint32_t i = 0; i < 4; ++i)
        corners[next[cell[i]]++] = {cell[(i + 1) % 4], cell[(i + 3) % 4]};
  }

  void ShellElements::Implementation::build_batches(const std::vector<double>        &thickness,
                                                    const std::vector<std::uint32_t> &corner_row)
  {
    const std::size_t n_batches = (cells.size() + n_lanes - 1) / n_lanes;
    batches.resize(n_batches);
    points.resize(n_in_plane * n_batches);
    stress.assign(n_in_plane == 1 ? n_batches : 0, ShellStress<Lanes>());
    sections.assign(n_in_plane == 1 ? 0 : n_in_plane * n_batches, SectionStress<Lanes>());
    chunks.resize((n_batches + batches_per_chunk - 1) / batches_per_chunk);
    for (std::size_t e = 0; e < n_batches * n_lanes; ++e)
      {
        Batch            &batch = batches[e / n_lanes];
        const std::size_t k = e % n_lanes, element = std::min(e, cells.size() - 1);
        if (n_in_plane == 1)
          stress[e / n_lanes].thickness[k] = thickness[element];
        else
          for (std::size_t s = 0; s < n_in_plane; ++s)
            sections[n_in_plane * (e / n_lanes) + s].thickness[k] = thickness[element];
        for (int i = 0; i < 4; ++i)
          {
            batch.record[i][k] = cells[element][i] * (sizeof(NodeRecord) / sizeof(double));
            batch.corner[i][k] = e < cells.size() ? corner_row[4 * e + i] : corner_force.size() - 1;
          }
        if (e < cells.size())
          check_shape(e, thickness[e]);
      }
    set_inverse_masses({});
  }

  void ShellElements::Implementation::check_shape(const std::size_t e, const double thickness)
  {
    const ShellGeometry<double> g        = geometry(e);
    double                      shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        {
          const double *x = records[cells[e][i]].position, *y = records[cells[e][j]].position;
          shortest = std::min(shortest, std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
        }
    if (!(thickness > 0.) || !(g.area > 1e-7 * g.x.m1.squaredNorm()) || !(shortest > 0.))
      throw InputError("Shell " + place(e).text() + ": thickness " + text(thickness) + " m, area " + text(g.area) +
                       " m^2, shortest distance of two nodes " + text(shortest) + " m; all must be positive.");
    if (!(smallest_area(e) > 0.))
      throw InputError("Shell " + place(e).text() +
                       ": not convex, its Jacobian at a point of the full integration is " +
                       text(smallest_area(e) / g.area) + " of that at the centre; it must be positive.");
    mass.push_back(section.material.density * thickness * g.area);
  }

  void ShellElements::Implementation::set_inverse_masses(const std::span<const double> nodal_masses)
  {
    std::vector<double> quarters(n_nodes, 0.);
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const auto n : cells[e])
        quarters[n] += 0.25 * mass[e];
    for (Chunk &chunk : chunks)
      chunk.eigenvalue = Lanes(0.);
    for (std::size_t e = 0; e < batches.size() * n_lanes; ++e)
      {
        const std::size_t element = std::min(e, cells.size() - 1), k = e % n_lanes;
        double            share = 1.;
        for (const auto n : cells[element])
          share = nodal_masses.empty() ? 1. : std::min(share, nodal_masses[n] / quarters[n]);
        Batch       &batch    = batches[e / n_lanes];
        const double inverse  = 1. / (share * mass[element]);
        const double value    = eigenvalue_bound(element, inverse);
        batch.inverse_mass[k] = inverse;
        batch.eigenvalue[k]   = value;
        Chunk &chunk          = chunks[e / n_lanes / batches_per_chunk];
        chunk.eigenvalue      = max(chunk.eigenvalue, Lanes(value));
        if (erosion)
          erosion->batches[e / n_lanes].allowed[k] =
            value / (section.material.failure.smallest_step * section.material.failure.smallest_step);
      }
  }

  EntityPlace ShellElements::Implementation::place(const std::size_t element) const
  {
    Point3 x = Point3::Zero();
    for (const auto n : cells[element])
      x += 0.25 * Point3(records[n].position);
    return {"element", element, {{x[0], x[1], x[2]}}};
  }

  std::size_t ShellElements::Implementation::n_elements_of(const std::size_t batch) const
  {
    return std::min(n_lanes, cells.size() - batch * n_lanes);
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

  double ShellElements::Implementation::smallest_area(const std::size_t element) const
  {
    const ShellGeometry<double> g = geometry(element);
    if (n_in_plane == 1)
      return g.area;
    return g.area * min(1., full_integration::PlaneGeometry<double>(g, law.elasticity.poisson).smallest_jacobian);
  }

  double ShellElements::Implementation::eigenvalue_bound(const std::size_t element, const double inverse_mass) const
  {
    const ShellGeometry<double> g = geometry(element);
    const double                t = largest_thickness(element);
    return n_in_plane == 1 ? compute_eigenvalue_bound<false>(g, t, inverse_mass, law)
                           : compute_eigenvalue_bound<true>(g, t, inverse_mass, law);
  }

  void ShellElements::Implementation::report_failure(const std::size_t b)
  {
    const auto is_sound = [this](const std::size_t element) {
      double sum = lane(batches[element / n_lanes].eigenvalue, element % n_lanes);
      for (const auto &corner : batches[element / n_lanes].corner)
        for (const double f : corner_force[corner[element % n_lanes]].value)
          sum += f;
      return std::isfinite(sum) && smallest_area(element) > 0.;
    };
    for (std::size_t k = 0; k < n_elements_of(b); ++k)
      if (const std::size_t e = b * n_lanes + k; !is_failed(e) && !is_sound(e))
        {
          // of a state that is finite only the geometry of the end can be to blame
          if (!can_collapse() || !has_finite_state(e))
            throw NumericalFailure("Shell " + place(e).text() + ": force is not finite or area not positive (area " +
                                   text(smallest_area(e)) +
                                   " m^2, fully integrated four times that at the worst point).\n"
                                   "The step was too large or the element collapsed: reduce Time/Step scale" +
                                   (erosion ? ", or let it erode (Blade/Material/Smallest step)." : "."));
          erosion->batches[b].collapsed |= 1u << k;
        }
    // copies do as the last element, and write nowhere
    for (std::size_t k = n_elements_of(b); erosion && k < n_lanes; ++k)
      erosion->batches[b].collapsed |= (erosion->batches[b].collapsed >> (n_elements_of(b) - 1) & 1u) << k;
  }
} // namespace birdstrike
