#include "nodal_mechanics.h"
#include "nodal_sums.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::kick_internal(const double half_step, const HalfKick half)
  {
    const bool    first = half == HalfKick::first;
    double       *v     = velocity.data();
    const double *f = scaled ? scaled->forces() : force.data(), *inverse = inverse_mass.data();

    if (loads.damping() == 0. && !loads.is_active())
      for_nodes([=](const std::size_t begin, const std::size_t end) {
        for (std::size_t i = n_unknowns * begin; i < n_unknowns * end; ++i)
          v[i] += half_step * f[i] * inverse[i];
      });
    else
      kick_loaded(half_step, first);
    for (const std::uint32_t dof : held_dofs)
      if (dof % n_unknowns < 3)
        impulses.support_impulse[dof % n_unknowns] += half_step * (f[dof] + external[dof]);
    internal_half = first ? 0. : half_step;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::kick_loaded(const double half_step, const bool first)
  {
    const double  decay = std::exp(-loads.damping() * half_step);
    double       *v     = velocity.data();
    const double *f = scaled ? scaled->forces() : force.data(), *f_external = external.data();
    const double *inverse = inverse_mass.data(), *m = mass.data();
    const Sums    sums = sum_nodes([=](const std::size_t n, Sums &sum) {
      for (std::size_t i = n_unknowns * n; i < n_unknowns * n + n_unknowns; ++i)
        {
          const double kick   = half_step * (f[i] + f_external[i]) * inverse[i];
          const double before = v[i];
          v[i]                = first ? before * decay + kick : (before + kick) * decay;
          const double drift = first ? v[i] : before, damped = first ? before : before + kick;
          sum[0] += half_step * f_external[i] * drift;
          sum[1] += m[i] * (1. - decay) * damped * drift;
        }
      for (unsigned int d = 0; d < 3; ++d)
        sum[2 + d] += half_step * f_external[n_unknowns * n + d];
    });
    booked.external_work += sums[0];
    booked.dissipated += sums[1];
    if (scaled)
      booked.dissipated += scaled->dissipated({v, f_external, inverse, half_step, decay}, first);
    for (unsigned int d = 0; d < 3; ++d)
      impulses.external_impulse[d] += sums[2 + d];
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::kick_contact(const double half_step, const HalfKick half)
  {
    const bool    first = half == HalfKick::first;
    double       *v     = velocity.data();
    const double *f = contact.data(), *kicking = f, *inverse = inverse_mass.data();
    if (scaled)
      {
        scaled->update_contact(f);
        kicking = scaled->contact();
      }

    // contact leaves the moments at zero: what happens to rotations is nothing
    const auto kick = [=, this](const auto is_scaled) {
      return sum_components<2>([=](const std::size_t i, Eight *sum) {
        Eight force_on, before, mobility;
        read(f + i, force_on);
        read(v + i, before);
        read(inverse + i, mobility);
        const Eight impulse = half_step * force_on;
        Eight       change  = impulse * mobility;
        if constexpr (is_scaled)
          {
            read(kicking + i, change);
            change = half_step * change * mobility;
          }
        const Eight after = before + change;
        write(after, v + i);
        sum[0] += impulse;
        sum[1] += impulse * (first ? after : before);
      });
    };
    const auto sums = scaled ? kick(std::true_type{}) : kick(std::false_type{});
    for (unsigned int d = 0; d < 3; ++d)
      impulses.contact_impulse[d] += sums[0][d];
    booked.contact_work += sums[1][0] + sums[1][1] + sums[1][2];
    for (const std::uint32_t dof : held_dofs)
      if (dof % n_unknowns < 3)
        impulses.support_impulse[dof % n_unknowns] += half_step * kicking[dof];
    contact_half = first ? 0. : half_step;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::drift(const double step)
  {
    const double *v = velocity.data(), *x_0 = reference.data();
    double       *u = displacement.data(), *du = increment.data(), *x = position.data();
    const bool    is_first = increment_time == 0.; // since the last forces
    for_nodes([=](const std::size_t begin, const std::size_t end) {
      if (is_first)
        for (std::size_t i = n_unknowns * begin; i < n_unknowns * end; ++i)
          du[i] = step * v[i];
      else
        for (std::size_t i = n_unknowns * begin; i < n_unknowns * end; ++i)
          du[i] += step * v[i];
      for (std::size_t i = n_unknowns * begin; i < n_unknowns * end; ++i)
        u[i] += step * v[i];
      for (std::size_t n = begin; n < end; ++n)
        for (unsigned int d = 0; d < 3; ++d)
          x[3 * n + d] = x_0[3 * n + d] + u[n_unknowns * n + d];
    });
    time += step;
    increment_time += step;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::clear_contact_forces()
  {
    std::fill(contact.begin(), contact.end(), 0.);
    if (scaled)
      scaled->clear_contact();
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::add_internal_forces(const std::span<const NodalForce> forces)
  {
    if (forces.empty())
      return;
    added.assign(forces.begin(), forces.end());
    for (const NodalForce &one : added)
      for (unsigned int d = 0; d < 3; ++d)
        force[n_unknowns * one.node + d] += one.force[d];
    if (scaled)
      scaled->update_forces(force.data(), external.data());
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::set_contact_in_transit(const double duration)
  {
    in_transit = duration;
    if (duration > 0.)
      contact_half = 0.; // the last kick was by forces that have been replaced; (h F)^2/(2 m) is lost on the report
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::update_loads()
  {
    if (!loads.is_active())
      return;
    std::fill(external.begin(), external.end(), 0.);
    loads.add_forces(time, position.data(), external.data());
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::scale(const NodeColumns  &columns,
                                         std::vector<double> coupling) requires(n_unknowns == 3)
  {
    scaled =
      std::make_unique<ScaledNodes>(ColumnMass(columns, std::move(coupling), inverse_mass.data(), pool), n_padded);
    scaled->update_forces(force.data(), external.data());
  }

  template class NodalMechanics<3>;
  template class NodalMechanics<6>;
} // namespace birdstrike
