#include "structure/implicit/equilibrium.h"
#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"
#include <birdstrike/core/numerical_failure.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double long_time = 1e300; ///< s, a step takes: neither viscosity nor strain rates
    /// Of an edge, and rad: of the differences that make the tangent. Strains are of increments, free of round-off;
    /// what positions a metre away are rounded to is a millionth of it. Larger, and it would more often lie across the
    /// onset of yield, where Newton's steps halve the error instead of squaring it.
    constexpr double variation = 1e-7;

    std::vector<double> find_differences(const std::vector<double> &reference, const NodeLists &neighbours)
    {
      std::vector<double> result;
      for (std::size_t n = 0; n + 1 < neighbours.begin.size(); ++n)
        {
          double shortest = INFINITY;
          for (const std::uint32_t other : neighbours.of(n))
            if (other != n)
              shortest = std::min(shortest, (Point3(&reference[3 * other]) - Point3(&reference[3 * n])).norm());
          result.push_back(variation * shortest);
        }
      return result;
    }
  } // namespace

  SparseRows Equilibrium::compute_tangent(const std::span<const double> step)
  {
    SparseRows          tangent = make_pattern(*free, reach);
    std::vector<double> varied(step.begin(), step.end()), above, below;
    const std::uint32_t n_colours = colour.empty() ? 0 : *std::max_element(colour.begin(), colour.end()) + 1;
    for (const bool is_rotation : {false, true})
      {
        const auto size_of = [&](const std::uint32_t n) { return is_rotation ? variation : difference[n]; };
        const auto vary    = [&](const std::uint32_t which, const std::size_t local, const double sign) {
          std::copy(step.begin(), step.end(), varied.begin());
          for (std::uint32_t n = 0; n < colour.size(); ++n)
            if (const auto [k, end] = free->of(n, is_rotation); colour[n] == which && k + local < end)
              varied[k + local] += sign * size_of(n);
        };
        for (std::uint32_t which = 0; which < n_colours; ++which)
          for (std::size_t local = 0; local < 3; ++local)
            {
              vary(which, local, 1.);
              if (std::equal(step.begin(), step.end(), varied.begin()))
                continue; // nothing of this colour has so many
              compute_forces(varied, above);
              vary(which, local, -1.);
              compute_forces(varied, below);
              for (std::uint32_t n = 0; n < colour.size(); ++n)
                if (const auto [k, end] = free->of(n, is_rotation); colour[n] == which && k + local < end)
                  for (const std::uint32_t reached : reach.of(n))
                    {
                      std::size_t       row     = free->of(reached, false).first; // all of a node have the same columns
                      const std::size_t end_row = free->of(reached, true).second;
                      const std::size_t place   = row < end_row ? tangent.place(row, k + local) : 0;
                      for (; row < end_row; ++row)
                        tangent.value[tangent.begin[row] + place] = (below[row] - above[row]) / (2. * size_of(n));
                    }
            }
      }
    require_numbers(tangent);
    return tangent;
  }

  void Equilibrium::require_numbers(const SparseRows &tangent) const
  {
    for (std::size_t row = 0; row < tangent.size(); ++row)
      for (std::size_t e = tangent.begin[row]; e < tangent.begin[row + 1]; ++e)
        if (!std::isfinite(tangent.value[e]))
          {
            FailureFacts facts{"Static solve: the tangent is no number", "stiffness", tangent.value[e], "N/m"};
            facts.where = place_of((*free)[row].node);
            throw NumericalFailure(std::move(facts));
          }
  }

  std::vector<double> Equilibrium::nodal_displacements(const std::span<const double> values) const
  {
    std::vector<double> result(3 * free->n_nodes(), 0.);
    for (std::size_t k = 0; k < free->size(); ++k)
      if (const FreeUnknown &unknown = (*free)[k]; !unknown.is_rotation)
        for (unsigned int d = 0; d < 3; ++d)
          result[3 * unknown.node + d] += values[k] * unknown.axis[d];
    return result;
  }

  template <unsigned int n_unknowns>
  BladeEquilibrium<n_unknowns>::BladeEquilibrium(const typename Motion::Mesh &mesh, Motion &motion, Elements &elements,
                                                 const std::span<const std::uint32_t> held, const Rotor &rotor)
    : motion(motion), elements(elements), rotor(rotor), is_held(n_unknowns * mesh.nodes.size(), false)
  {
    for (const std::uint32_t dof : held)
      is_held[dof] = true;
    const std::size_t n_nodes = mesh.nodes.size();
    reach =
      find_neighbours({mesh.cells[0].data(), mesh.cells[0].size() * mesh.cells.size()}, mesh.cells[0].size(), n_nodes);
    colour                  = find_colours(reach);
    const NodeArrays arrays = motion.arrays();
    difference              = find_differences({arrays.reference, arrays.reference + 3 * n_nodes}, reach);
    accepted.assign(arrays.displacement, arrays.displacement + n_unknowns * n_nodes);
    saved   = elements.save();
    follows = motion.has_pressure();
    find_unknowns();
  }

  template <unsigned int n_unknowns>
  BladeEquilibrium<n_unknowns>::~BladeEquilibrium()
  {
    elements.restore(*saved);
    move(std::vector<double>(free->size(), 0.));
  }

  template <unsigned int n_unknowns>
  void BladeEquilibrium<n_unknowns>::find_unknowns()
  {
    const std::size_t   n_nodes = is_held.size() / n_unknowns;
    std::vector<Point3> directors;
    if constexpr (n_unknowns == 6)
      for (std::size_t n = 0; n < n_nodes; ++n)
        directors.push_back(elements.director(n));
    free = std::make_unique<FreeUnknowns>(is_held, n_nodes, directors);
  }

  template <unsigned int n_unknowns>
  void BladeEquilibrium<n_unknowns>::move(const std::span<const double> step)
  {
    free->expand(step, increment);
    const NodeArrays arrays = motion.arrays();
    for (std::size_t i = 0; i < accepted.size(); ++i)
      arrays.displacement[i] = accepted[i] + increment[i];
    for (std::size_t n = 0; n < arrays.n; ++n)
      for (unsigned int d = 0; d < 3; ++d)
        arrays.position[3 * n + d] = arrays.reference[3 * n + d] + arrays.displacement[n_unknowns * n + d];
  }

  template <unsigned int n_unknowns>
  void BladeEquilibrium<n_unknowns>::add_loads(const double factor, std::vector<double> &forces) const
  {
    const NodeArrays    arrays = motion.arrays();
    std::vector<double> loads(forces.size(), 0.);
    motion.add_loads(0., loads.data());
    const HubMotion hub = rotor.motion(0.);
    for (std::size_t n = 0; n < arrays.n && rotor.turns(); ++n)
      for (unsigned int d = 0; d < 3; ++d)
        loads[n_unknowns * n + d] -=
          arrays.mass[n_unknowns * n] * hub.centripetal_acceleration(Point3(arrays.position + 3 * n))[d];
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i] += factor * loads[i];
  }

  template <unsigned int n_unknowns>
  void BladeEquilibrium<n_unknowns>::compute_forces(const std::span<const double> step, std::vector<double> &forces)
  {
    elements.restore(*saved);
    move(step);
    nodal.resize(is_held.size());
    if (!elements.try_internal_forces(motion.arrays().position, increment.data(), long_time, nodal.data()))
      throw NumericalFailure("Static solve: an element fails on the way to equilibrium.");
    add_loads(load_factor, nodal);
    free->restrict(nodal, forces);
  }

  template <unsigned int n_unknowns>
  void BladeEquilibrium<n_unknowns>::accept(const std::span<const double> step)
  {
    std::vector<double> forces;
    compute_forces(step, forces);
    const NodeArrays arrays = motion.arrays();
    accepted.assign(arrays.displacement, arrays.displacement + accepted.size());
    // what the elements exert, as the explicit loop keeps it
    std::vector<double> loads(accepted.size(), 0.);
    add_loads(load_factor, loads);
    for (std::size_t i = 0; i < accepted.size(); ++i)
      arrays.force[i] = nodal[i] - loads[i];
    saved = elements.save();
    find_unknowns();
  }

  template <unsigned int n_unknowns>
  SparseRows BladeEquilibrium<n_unknowns>::compute_elastic_tangent()
  {
    struct Suspension
    {
      BladeEquilibrium     &of;
      const decltype(saved) before;

      explicit Suspension(BladeEquilibrium &of) : of(of), before(of.saved)
      {
        of.elements.restore(*before);
        of.elements.suspend_flow(true);
        of.saved = of.elements.save();
      }
      ~Suspension()
      {
        of.elements.suspend_flow(false);
        of.saved = before; // what every call starts from
      }
    } suspension(*this);
    return compute_tangent(std::vector<double>(free->size(), 0.));
  }

  template <unsigned int n_unknowns>
  double BladeEquilibrium<n_unknowns>::load_norm()
  {
    std::vector<double> loads(is_held.size(), 0.), forces;
    add_loads(1., loads);
    free->restrict(loads, forces);
    double sum = 0.;
    for (const double f : forces)
      sum += f * f;
    return std::sqrt(sum);
  }

  template <unsigned int n_unknowns>
  EntityPlace BladeEquilibrium<n_unknowns>::place_of(const std::uint32_t node) const
  {
    const double *const x = motion.arrays().position + 3 * node;
    return {"node", node, {{x[0], x[1], x[2]}}};
  }

  template <unsigned int n_unknowns>
  std::vector<double> BladeEquilibrium<n_unknowns>::masses() const
  {
    const NodeArrays    arrays = motion.arrays();
    std::vector<double> result;
    for (std::size_t k = 0; k < free->size(); ++k)
      result.push_back(arrays.mass[n_unknowns * (*free)[k].node + ((*free)[k].is_rotation ? 3 : 0)]);
    return result;
  }

  template <unsigned int n_unknowns>
  std::vector<std::vector<double>> BladeEquilibrium<n_unknowns>::rigid_motions() const
  {
    const NodeArrays arrays = motion.arrays();
    Point3           centre = Point3::Zero();
    for (std::size_t n = 0; n < arrays.n; ++n)
      centre += Point3(arrays.position + 3 * n) / static_cast<double>(arrays.n);
    std::vector<std::vector<double>> result(6);
    for (std::size_t k = 0; k < free->size(); ++k)
      {
        const auto &[node, is_rotation, axis] = (*free)[k];
        const Point3 arm                      = Point3(arrays.position + 3 * node) - centre;
        for (unsigned int d = 0; d < 3; ++d)
          {
            result[d].push_back(is_rotation ? 0. : axis[d]);
            result[3 + d].push_back(is_rotation ? axis[d] : axis.dot(Point3(Point3::Unit(d)).cross(arm)));
          }
      }
    return result;
  }

  template class BladeEquilibrium<3>;
  template class BladeEquilibrium<6>;
} // namespace birdstrike
