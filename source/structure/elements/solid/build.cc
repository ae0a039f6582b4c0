#include "structure/elements/solid/thickness.h"

#include "structure/elements/solid/b_bar.h"
#include "structure/elements/solid/implementation.h"
#include "structure/elements/solid/step_bound.h"
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

    const std::vector<std::array<std::uint32_t, 8>> &checked(const std::vector<std::array<std::uint32_t, 8>> &cells,
                                                             const std::size_t                                n_nodes)
    {
      if (cells.empty())
        throw InputError("Solid elements: no elements; at least one is needed.");
      for (const auto &cell : cells)
        for (const auto node : cell)
          if (node >= n_nodes)
            throw InputError("Solid elements: a cell names node " + std::to_string(node) + " of " +
                             std::to_string(n_nodes) + ".");
      return cells;
    }

    const SolidSection &checked(const SolidSection &section)
    {
      const auto       &m  = section.material;
      const double      nu = m.elasticity.poisson;
      const std::string bad =
        !(m.density > 0.)            ? "density " + text(m.density) + " kg/m^3, must be positive"
        : !(m.elasticity.young > 0.) ? "Young's modulus " + text(m.elasticity.young) + " Pa, must be positive"
        : !(nu > -1. && nu < 0.5)    ? "Poisson's ratio " + text(nu) + ", must lie between -1 and 0.5"
        : !(section.linear_viscosity >= 0.)
          ? "linear viscosity " + text(section.linear_viscosity) + ", must not be negative"
        : !(section.quadratic_viscosity >= 0.)
          ? "quadratic viscosity " + text(section.quadratic_viscosity) + ", must not be negative"
        : section.formulation == SolidFormulation::solid_shell && m.failure.can_fail()
          ? "Blade/Material/Failure is not there for solid-shells; set it to none, or Blade/Element/Formulation to "
            "another element"
          : "";
      if (!bad.empty())
        throw InputError("Solid elements: " + bad + ".");
      return section;
    }

    std::span<const std::uint32_t> flat(const std::vector<std::array<std::uint32_t, 8>> &cells)
    {
      return {cells[0].data(), 8 * cells.size()};
    }
  } // namespace

  SolidElements::Implementation::Implementation(std::vector<Point3>                       nodes,
                                                std::vector<std::array<std::uint32_t, 8>> cells,
                                                const SolidSection &section, ThreadPool &pool)
    : section(checked(section))
    , law(section)
    , pool(pool)
    , n_nodes(nodes.size())
    , thickness_axis(section.formulation == SolidFormulation::solid_shell
                       ? solid_shell::find_thickness_axes(nodes, checked(cells, nodes.size()))
                       : std::vector<std::uint8_t>())
    , cells(solid_shell::with_third(thickness_axis, checked(cells, nodes.size())))
    , blocks(flat(this->cells), 8, nodes.size(), elements_per_block)
    , records(nodes.size() + (section.material.failure.can_fail() ? n_resting_records : 0))
    , corner_force(blocks.n_rows + 1) // the last one takes what copies of the last element write
    , node_force(nodes.size())
  {
    std::uint32_t n_sums = 0;
    for (const auto &block : blocks.blocks)
      {
        work_begin.push_back(n_sums);
        n_sums += (block.leaving_end - block.leaving_begin + nodes_per_chunk - 1) / nodes_per_chunk;
      }
    work.assign(n_sums, Force{});
    for (std::size_t n = 0; n < n_nodes; ++n)
      std::copy_n(nodes[n].data(), 3, records[n].value);
    for (std::size_t e = 0; e < this->cells.size(); ++e)
      check_shape(e);
    build_batches();
  }

  SolidModes<double> SolidElements::Implementation::modes(const std::size_t element) const
  {
    Vector3<double> x[8];
    for (int i = 0; i < 8; ++i)
      x[i] = Point3(records[cells[element][i]].value);
    return SolidModes<double>(x);
  }

  void SolidElements::Implementation::check_shape(const std::size_t e)
  {
    const SolidModes<double>    x = modes(e);
    const SolidGeometry<double> g(x);
    double                      smallest = g.volume();
    for (int p = 0; p < b_bar_solid::n_points; ++p)
      smallest = std::min(smallest, b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, p)).det / 64.);
    // a brick of the same edges has this volume
    const double box =
      std::sqrt(x.linear[0].squaredNorm() * x.linear[1].squaredNorm() * x.linear[2].squaredNorm()) / 64.;
    if (!(smallest > 1e-7 * box))
      throw InputError("Solid " + place(e).text() + ": volume " + text(g.volume()) +
                       " m^3, smallest volume at a point " + text(smallest) +
                       " m^3; both must be positive.\nCorners are numbered (0,0,0), (1,0,0), (0,1,0), "
                       "(1,1,0), then the same at z = 1, right-handed.");
    mass.push_back(section.material.density * g.volume());
  }

  void SolidElements::Implementation::build_batches()
  {
    const std::size_t n_batches = (cells.size() + n_lanes - 1) / n_lanes;
    batches.resize(n_batches);
    chunks.resize((n_batches + batches_per_chunk - 1) / batches_per_chunk);
    SolidPoint<Lanes> point{};
    for (Lanes &s : point.stress)
      s = 0.;
    point.plastic_strain = point.plastic_work = 0.;
    point.yield                               = law.initial_yield();
    points.assign(n_batches * n_points(), point);
    if (section.formulation == SolidFormulation::b_bar)
      rest_det.resize(n_batches * n_points());
    if (section.formulation == SolidFormulation::solid_shell)
      {
        rule = make_thickness_points(section.rule, section.n_points);
        layers.resize(n_batches);
      }
    if (section.formulation != SolidFormulation::b_bar)
      {
        stabilisation.resize(n_batches);
        for (auto &s : stabilisation)
          for (int k = 0; k < 3; ++k)
            s.last[k] = s.linear[k][0] = s.linear[k][1] = s.linear[k][2] = 0.;
      }
    for (std::size_t e = 0; e < n_batches * n_lanes; ++e)
      {
        Batch            &batch = batches[e / n_lanes];
        const std::size_t k = e % n_lanes, element = std::min(e, cells.size() - 1);
        batch.viscous_pressure     = 0.;
        const SolidModes<double> x = modes(element);
        batch.rest_det[k]          = SolidGeometry<double>(x).det;
        for (std::size_t p = 0; p < n_points() && !rest_det.empty(); ++p)
          rest_det[e / n_lanes * n_points() + p][k] =
            b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, int(p))).det;
        for (int i = 0; i < 8; ++i)
          {
            batch.record[i][k] = cells[element][i] * (sizeof(NodeRecord) / sizeof(double));
            batch.corner[i][k] = e < cells.size() ? blocks.corner_row[8 * e + i] : blocks.n_rows;
          }
      }
    if (section.material.failure.can_fail())
      build_erosion();
    set_inverse_masses({});
  }

  void SolidElements::Implementation::set_inverse_masses(const std::span<const double> nodal_masses)
  {
    std::vector<double> eighths(n_nodes, 0.);
    for (std::size_t e = 0; e < cells.size(); ++e)
      for (const auto n : cells[e])
        eighths[n] += 0.125 * mass[e];
    for (Chunk &chunk : chunks)
      chunk.frequency = Lanes(0.);
    for (std::size_t e = 0; e < batches.size() * n_lanes; ++e)
      {
        const std::size_t element = std::min(e, cells.size() - 1), k = e % n_lanes;
        double            share = nodal_masses.empty() ? 1. : std::numeric_limits<double>::infinity();
        for (const auto n : cells[element])
          share = nodal_masses.empty() ? 1. : std::min(share, nodal_masses[n] / eighths[n]);
        Batch                      &batch   = batches[e / n_lanes];
        const double                inverse = 1. / (share * mass[element]);
        const SolidModes<double>    x       = modes(element);
        const SolidGeometry<double> g(x);
        double                      drag;
        law.compute_viscous_pressure(0., g.compute_height(), drag);
        const double value    = compute_frequency_bound(g, g.det, inverse, drag, law, section.formulation);
        batch.inverse_mass[k] = inverse;
        batch.frequency[k]    = value;
        Chunk &chunk          = chunks[e / n_lanes / batches_per_chunk];
        chunk.frequency       = max(chunk.frequency, Lanes(value));
        if (erosion)
          erosion->batches[e / n_lanes].allowed[k] = value / section.material.failure.smallest_step;
      }
    update_scaled_frequencies();
  }

  std::size_t SolidElements::Implementation::n_points() const
  {
    return section.formulation == SolidFormulation::b_bar ? b_bar_solid::n_points : 1;
  }

  EntityPlace SolidElements::Implementation::place(const std::size_t element) const
  {
    Point3 x = Point3::Zero();
    for (const auto n : cells[element])
      x += 0.125 * Point3(records[n].value);
    return {"element", element, {{x[0], x[1], x[2]}}};
  }

  std::size_t SolidElements::Implementation::n_elements_of(const std::size_t batch) const
  {
    return std::min(n_lanes, cells.size() - batch * n_lanes);
  }

  void SolidElements::Implementation::report_failure(const std::size_t b) const
  {
    const auto smallest_volume = [this](const std::size_t element) {
      const SolidModes<double> x      = modes(element);
      double                   volume = SolidGeometry<double>(x).volume();
      if (section.formulation == SolidFormulation::b_bar)
        for (int p = 0; p < b_bar_solid::n_points; ++p)
          volume = std::min(volume, b_bar_solid::Jacobian<double>(b_bar_solid::Derivatives<double>(x, p)).det / 64.);
      return volume;
    };
    const auto is_sound = [&](const std::size_t element) {
      double sum = 0.;
      for (const auto &corner : batches[element / n_lanes].corner)
        for (const double f : corner_force[corner[element % n_lanes]].value)
          sum += f;
      return std::isfinite(sum) && smallest_volume(element) > 0.;
    };
    std::size_t e = b * n_lanes;
    for (std::size_t k = n_elements_of(b); k-- > 0;)
      if (!is_failed(b * n_lanes + k) && !is_sound(b * n_lanes + k))
        e = b * n_lanes + k;
    throw NumericalFailure("Solid " + place(e).text() + ": turned inside out, or its force is not finite (volume " +
                           text(smallest_volume(e)) +
                           " m^3).\nThe step was too large or the element collapsed: reduce Time/Step scale" +
                           (erosion ? ", or let it erode (Blade/Material/Smallest step)." : "."));
  }
} // namespace birdstrike
