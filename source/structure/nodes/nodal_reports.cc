#include "structure/nodes/initial_spin.h"
#include "structure/nodes/nodal_vectors.h"
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <cmath>
#include <numeric>

// What NodalMechanics starts from and what it tells about itself.
namespace birdstrike
{
  template <unsigned int n_unknowns>
  NodalMechanics<n_unknowns>::NodalMechanics(const Mesh &mesh, const Masses &masses, const Supports &supports,
                                             Loads given_loads, const Rotor &rotor, ThreadPool &pool)
    : pool(pool)
    , loads(std::move(given_loads))
    , held_dofs(supports.held_dofs)
    , driven(supports.driven)
    , rotor(rotor)
    , hub_dofs(rotor.turns() ? supports.held_dofs : std::vector<std::uint32_t>())
    , n_nodes(mesh.space.size())
    , n_owned(mesh.space.n_owned())
    , vectors(std::make_unique<Vectors>(mesh.space))
    , partial((n_owned + chunk - 1) / chunk)
  {
    double *mass = vectors->mass.begin(), *inverse = vectors->inverse_mass.begin();
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        for (unsigned int d = 0; d < 3; ++d)
          vectors->reference.begin()[3 * n + d] = vectors->position.begin()[3 * n + d] = mesh.nodes[n][d];
        for (unsigned int c = 0; c < n_unknowns; ++c)
          {
            mass[n_unknowns * n + c]    = c < 3 ? masses.translation[n] : masses.rotation[n];
            inverse[n_unknowns * n + c] = 1. / mass[n_unknowns * n + c];
          }
      }
    added.reserve(n_nodes);
    for (const std::uint32_t dof : held_dofs)
      inverse[dof] = 0.;
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        const double *i                       = inverse + n_unknowns * n;
        const bool    is_held                 = i[0] == 0. && i[1] == 0. && i[2] == 0.;
        vectors->node_inverse_mass.begin()[n] = is_held ? 0. : 1. / masses.translation[n];
      }
    update_loads();
  }

  template <unsigned int n_unknowns>
  NodalMechanics<n_unknowns>::~NodalMechanics() = default;

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::initialize_velocity(const BladeParameters::Loads &parameters)
  {
    const Point3            spin = read_initial_spin(parameters);
    std::vector<Expression> field;
    if (is_present(parameters.initial_velocity))
      field.emplace_back(parameters.initial_velocity, 3, "Loads/Initial velocity");
    double *velocity = vectors->velocity.begin();
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        const double *x = vectors->reference.begin() + 3 * n;
        for (unsigned int d = 0; d < 3; ++d)
          {
            velocity[n_unknowns * n + d] = spin.cross(Point3(x))[d];
            if constexpr (n_unknowns == 6)
              velocity[6 * n + 3 + d] = spin[d];
            for (const auto &expression : field)
              velocity[n_unknowns * n + d] += expression.value(x, 0., d);
          }
      }
    for (const std::uint32_t dof : held_dofs)
      {
        const bool is_driven = std::any_of(driven.begin(), driven.end(), [&](const Supports::Driven &support) {
          return std::find(support.dofs.begin(), support.dofs.end(), dof) != support.dofs.end();
        });
        if (!is_driven)
          require_no_spin(spin, velocity[dof], Point3(vectors->reference.begin() + 3 * (dof / n_unknowns)));
        velocity[dof] = 0.;
      }
    constexpr double instant = 1e-9; // s
    for (const Supports::Driven &support : driven)
      for (const std::uint32_t dof : support.dofs)
        velocity[dof] = support.at(instant) / instant;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::watch(const std::string &probes, const Mesh &mesh)
  {
    for (const auto &[name, where] : parse_pairs(probes, "Blade/Probes"))
      {
        const auto x = parse_numbers(where, 3, "Blade/Probes");
        if (const auto node = mesh.nearest_node(Point3(x[0], x[1], x[2])))
          watched.emplace_back(name, *node);
      }
  }

  template <unsigned int n_unknowns>
  std::array<double, 2> NodalMechanics<n_unknowns>::kinetic(const double h, const double h_c) const
  {
    const double  decay = std::exp(-loads.damping() * h);
    const double *v = vectors->velocity.begin(), *f = scaled ? scaled->forces() : vectors->force.begin(),
                 *m                  = vectors->mass.begin();
    const double         *f_contact  = scaled ? scaled->contact() : vectors->contact.begin();
    const double         *f_external = vectors->external.begin(), *inverse = vectors->inverse_mass.begin();
    const double          back = 1. - 1. / decay;
    const auto            sums = sum_components<2>([=](const auto &at, Eight *sum) {
      Eight speed, inner, outer_contact, outer_load, inertia, mobility;
      at.read(v, speed);
      at.read(f, inner);
      at.read(m, inertia);
      at.read(f_contact, outer_contact);
      at.read(f_external, outer_load);
      at.read(inverse, mobility);
      const Eight change = (h * (inner + outer_load) + h_c * outer_contact) * mobility + back * speed;
      sum[0] += 0.5 * inertia * (speed * speed);
      sum[1] += 0.5 * inertia * (change * change);
    });
    std::array<double, 2> result{std::accumulate(sums[0].begin(), sums[0].end(), 0.),
                                 std::accumulate(sums[1].begin(), sums[1].end(), 0.)};
    if (scaled)
      {
        const auto added = scaled->kinetic({v, f_external, inverse, h, decay}, h_c);
        result[0] += added[0];
        result[1] += added[1];
      }
    return result;
  }

  template <unsigned int n_unknowns>
  EnergyReport NodalMechanics<n_unknowns>::energies() const
  {
    const double scale  = internal_half > 0. ? staggered_half / internal_half : 0.;
    const auto   sums   = kinetic(scale * internal_half, scale * contact_half);
    EnergyReport report = booked;
    report.kinetic      = sums[0];
    report.driven       = 0.5 * moment_of_inertia * std::pow(rotor.speed(time), 2);
    report.staggering -= sums[1];
    return report;
  }

  template <unsigned int n_unknowns>
  MomentumReport NodalMechanics<n_unknowns>::momenta() const
  {
    const double  *v = vectors->velocity.begin(), *m = vectors->mass.begin(), *x = vectors->position.begin();
    const auto     sums   = sum_nodes([=](const std::size_t n, Sums &sum) {
      const double *p = x + 3 * n, *w = v + n_unknowns * n;
      const double  inertia = m[n_unknowns * n];
      for (unsigned int d = 0; d < 3; ++d)
        {
          const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
          sum[d] += inertia * w[d];
          if constexpr (n_unknowns == 6)
            sum[3 + d] += inertia * (p[e] * w[f] - p[f] * w[e]) + m[6 * n + 3] * w[3 + d];
          else
            sum[3 + d] += inertia * (p[e] * w[f] - p[f] * w[e]);
        }
      const double speed2 = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
      sum[6] += inertia * std::sqrt((p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * speed2);
      sum[7] += inertia * std::sqrt(speed2);
    });
    MomentumReport report = impulses;
    for (unsigned int d = 0; d < 3; ++d)
      {
        report.momentum[d]         = sums[d];
        report.angular_momentum[d] = sums[3 + d];
      }
    report.moment_scale  = sums[6];
    report.impulse_scale = sums[7];
    if (scaled)
      {
        const auto added = scaled->angular_momentum(x, v);
        for (unsigned int d = 0; d < 3; ++d)
          report.angular_momentum[d] += added[d];
      }
    return report;
  }

  template <unsigned int n_unknowns>
  std::array<double, 3> NodalMechanics<n_unknowns>::contact_force() const
  {
    const double *f    = vectors->contact.begin();
    const auto    sums = sum_components<1>([=](const auto &at, Eight *sum) {
      Eight entries;
      at.read(f, entries);
      sum[0] += entries;
    });
    return {{sums[0][0], sums[0][1], sums[0][2]}};
  }

  template <unsigned int n_unknowns>
  std::vector<ProbeValues> NodalMechanics<n_unknowns>::probes() const
  {
    std::vector<ProbeValues> values;
    for (const auto &[name, n] : watched)
      {
        ProbeValues value;
        value.name = name;
        for (unsigned int d = 0; d < 3; ++d)
          {
            value.position[d]     = vectors->reference.begin()[3 * n + d];
            value.displacement[d] = vectors->displacement.begin()[n_unknowns * n + d];
            value.velocity[d]     = vectors->velocity.begin()[n_unknowns * n + d];
          }
        values.push_back(value);
      }
    return values;
  }

  template <unsigned int n_unknowns>
  NodeArrays NodalMechanics<n_unknowns>::arrays()
  {
    return {n_nodes,
            n_unknowns,
            vectors->reference.begin(),
            vectors->position.begin(),
            vectors->displacement.begin(),
            vectors->velocity.begin(),
            vectors->force.begin(),
            vectors->mass.begin(),
            vectors->inverse_mass.begin()};
  }

  template <unsigned int n_unknowns>
  const double *NodalMechanics<n_unknowns>::positions() const
  {
    return vectors->position.begin();
  }

  template <unsigned int n_unknowns>
  const double *NodalMechanics<n_unknowns>::displacements() const
  {
    return vectors->displacement.begin();
  }

  template <unsigned int n_unknowns>
  const double *NodalMechanics<n_unknowns>::contact_forces() const
  {
    return vectors->contact.begin();
  }

  template <unsigned int n_unknowns>
  const double *NodalMechanics<n_unknowns>::element_forces() const
  {
    if (added.empty())
      return vectors->force.begin();
    of_elements.assign(vectors->force.begin(), vectors->force.begin() + n_unknowns * n_nodes);
    for (const NodalForce &one : added)
      for (unsigned int d = 0; d < 3; ++d)
        of_elements[n_unknowns * one.node + d] -= one.force[d];
    return of_elements.data();
  }

  template <unsigned int n_unknowns>
  FacetsView NodalMechanics<n_unknowns>::facets() const
  {
    FacetsView view;
    view.n_nodes         = n_nodes;
    view.position        = vectors->position.begin();
    view.velocity        = vectors->velocity.begin();
    view.inverse_mass    = vectors->node_inverse_mass.begin();
    view.velocity_stride = n_unknowns;
    return view;
  }

  template <unsigned int n_unknowns>
  std::size_t NodalMechanics<n_unknowns>::bytes() const
  {
    // eight vectors of unknowns, two of coordinates, one scalar, one of forces with their nodes
    return sizeof(double) * (8 * n_unknowns + 11) * n_nodes + (scaled ? scaled->bytes() : 0);
  }

  template class NodalMechanics<3>;
  template class NodalMechanics<6>;
} // namespace birdstrike
