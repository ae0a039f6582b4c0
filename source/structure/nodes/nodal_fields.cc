#include "structure/nodes/nodal_vectors.h"
#include "structure/nodes/scaled_nodes.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    /// Second difference, exact to 1e-6 of formulas below 200 Hz. Nothing is asked of the time before 0, where a
    /// formula need not have values: there the nodes are t, t + h, t + 2h, t + 3h, also of second order.
    double acceleration_of(const Supports::Driven &support, const double t)
    {
      constexpr double h = 1e-6; // s
      const auto       u = [&](const int k) { return support.at(t + k * h); };
      return (t < h ? 2. * u(0) - 5. * u(1) + 4. * u(2) - u(3) : u(1) - 2. * u(0) + u(-1)) / (h * h);
    }
  } // namespace

  // without damping; 0 where held or driven
  template <unsigned int n_unknowns>
  double NodalMechanics<n_unknowns>::acceleration(const std::size_t dof) const
  {
    const double *const f = scaled ? scaled->forces() : vectors->force.begin();
    const double *const c = scaled ? scaled->contact() : vectors->contact.begin();
    return (f[dof] + c[dof] + vectors->external.begin()[dof]) * vectors->inverse_mass.begin()[dof];
  }

  template <unsigned int n_unknowns>
  std::array<std::array<double, 3>, 3> NodalMechanics<n_unknowns>::motion_of(const std::size_t node) const
  {
    std::array<std::array<double, 3>, 3> motion;
    const auto                           prescribed = driven_acceleration(node);
    for (unsigned int d = 0; d < 3; ++d)
      {
        const std::size_t dof     = n_unknowns * node + d;
        const double      v       = vectors->velocity.begin()[dof];
        const bool        is_free = vectors->inverse_mass.begin()[dof] > 0.;
        motion[0][d]              = vectors->displacement.begin()[dof];
        motion[1][d]              = v;
        motion[2][d]              = is_free ? acceleration(dof) - loads.damping() * v : prescribed[d];
      }
    return motion;
  }

  template <unsigned int n_unknowns>
  std::array<double, n_unknowns> NodalMechanics<n_unknowns>::driven_acceleration(const std::size_t node) const
  {
    std::array<double, n_unknowns> result{};
    for (const Supports::Driven &support : driven)
      for (unsigned int c = 0; c < n_unknowns; ++c)
        if (std::binary_search(support.dofs.begin(), support.dofs.end(), n_unknowns * node + c))
          result[c] = acceleration_of(support, time);
    if (std::binary_search(hub_dofs.begin(), hub_dofs.end(), n_unknowns * node))
      {
        const HubMotion hub = rotor.motion(time);
        const Point3    x(vectors->position.begin() + 3 * node), spin_up = rotor.angular_acceleration(time);
        const Point3    a = hub.centripetal_acceleration(x) + spin_up.cross(x - hub.centre);
        for (unsigned int c = 0; c < n_unknowns; ++c)
          result[c] = c < 3 ? a[c] : spin_up[c - 3];
      }
    return result;
  }

  template <unsigned int n_unknowns>
  std::array<double, n_unknowns> NodalMechanics<n_unknowns>::support_force(const std::size_t node) const
  {
    const double *const            f         = scaled ? scaled->forces() : vectors->force.begin();
    const double *const            f_contact = scaled ? scaled->contact() : vectors->contact.begin();
    std::array<double, n_unknowns> inertia{};
    if (time > 0.)
      inertia = driven_acceleration(node);
    else if (std::binary_search(hub_dofs.begin(), hub_dofs.end(), n_unknowns * node))
      {
        const Point3 x(vectors->position.begin() + 3 * node), a = rotor.motion(0.).centripetal_acceleration(x);
        std::copy_n(a.data(), 3, inertia.begin());
      }
    std::array<double, n_unknowns> result;
    for (unsigned int c = 0; c < n_unknowns; ++c)
      {
        const std::size_t dof = n_unknowns * node + c;
        result[c]             = f[dof] + f_contact[dof] + vectors->external.begin()[dof] -
                    vectors->mass.begin()[dof] * (inertia[c] + loads.damping() * vectors->velocity.begin()[dof]);
      }
    return result;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::report_nodes(std::vector<std::uint32_t> nodes)
  {
    std::ranges::sort(nodes);
    nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
    reported_nodes = std::move(nodes);
    on_support.assign(n_unknowns * n_nodes, 0.);
    if (!rotor.turns())
      return;
    turned_back.position.assign(3 * n_nodes, 0.);
    turned_back.displacement.assign(n_unknowns * n_nodes, 0.);
    turned_back.force.assign(n_unknowns * n_nodes, 0.);
  }

  template <unsigned int n_unknowns>
  const double *NodalMechanics<n_unknowns>::support_forces() const
  {
    for (const std::uint32_t n : reported_nodes)
      std::ranges::copy(support_force(n), on_support.begin() + n_unknowns * n);
    return on_support.data();
  }

  template <unsigned int n_unknowns>
  std::pair<double, std::array<double, 3>>
  NodalMechanics<n_unknowns>::kinetic_and_impulse(const std::span<const std::uint32_t> nodes) const
  {
    double                kinetic = 0.;
    std::array<double, 3> impulse{};
    for (const std::uint32_t n : nodes)
      for (unsigned int c = 0; c < n_unknowns; ++c)
        {
          const std::size_t dof = n_unknowns * n + c;
          kinetic += 0.5 * vectors->mass.begin()[dof] * std::pow(vectors->velocity.begin()[dof], 2);
          if (c < 3)
            impulse[c] += vectors->received.begin()[dof];
        }
    return {kinetic, impulse};
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::add_fields(std::vector<Field> &fields) const
  {
    const auto add = [&](const char *name, const char *unit, const double *values) {
      Field field{name, unit, false, 3, {}};
      field.values.reserve(3 * n_nodes);
      for (std::size_t n = 0; n < n_nodes; ++n)
        field.values.insert(field.values.end(), values + n_unknowns * n, values + n_unknowns * n + 3);
      fields.push_back(std::move(field));
    };
    add("displacement", "m", vectors->displacement.begin());
    add("velocity", "m/s", vectors->velocity.begin());
    std::vector<double> accelerations(n_unknowns * n_nodes);
    for (std::size_t k = 0; k < accelerations.size(); ++k)
      accelerations[k] = acceleration(k);
    add("acceleration", "m/s^2", accelerations.data());
    add("contact_force", "N", vectors->contact.begin());
    add("contact_impulse", "N s", vectors->received.begin());
  }

  template std::array<std::array<double, 3>, 3> NodalMechanics<3>::motion_of(std::size_t) const;
  template std::array<std::array<double, 3>, 3> NodalMechanics<6>::motion_of(std::size_t) const;
  template void                                 NodalMechanics<3>::report_nodes(std::vector<std::uint32_t>);
  template void                                 NodalMechanics<6>::report_nodes(std::vector<std::uint32_t>);
  template const double                        *NodalMechanics<3>::support_forces() const;
  template const double                        *NodalMechanics<6>::support_forces() const;
  template void                                 NodalMechanics<3>::add_fields(std::vector<Field> &) const;
  template void                                 NodalMechanics<6>::add_fields(std::vector<Field> &) const;
  template std::pair<double, std::array<double, 3>>
    NodalMechanics<3>::kinetic_and_impulse(std::span<const std::uint32_t>) const;
  template std::pair<double, std::array<double, 3>>
    NodalMechanics<6>::kinetic_and_impulse(std::span<const std::uint32_t>) const;
} // namespace birdstrike
