#include "structure/elements/shell/elements.h"
#include "structure/elements/solid/elements.h"
#include "structure/nodes/nodal_vectors.h"

#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::compute_internal_forces(Elements &elements)
  {
    if (increment_time > 0.)
      elements.compute_internal_forces(vectors->position.begin(), vectors->increment.begin(), increment_time,
                                       vectors->force.begin());
    increment_time = 0.;
    added.clear();
    update_loads();
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::kick_internal(const double half_step, const HalfKick half)
  {
    const bool first = half == HalfKick::first;
    if (first)
      follow_step(half_step);
    double       *v = vectors->velocity.begin();
    const double *f = scaled ? scaled->forces() : vectors->force.begin(), *inverse = vectors->inverse_mass.begin();
    const double *f_external = vectors->external.begin();

    if (loads.damping() == 0. && !loads.is_active())
      for_nodes(n_owned, [=](const std::size_t begin, const std::size_t end) {
        for (std::size_t i = n_unknowns * begin; i < n_unknowns * end; ++i)
          v[i] += half_step * f[i] * inverse[i];
      });
    else
      kick_loaded(half_step, first);
    for (const std::uint32_t dof : held_dofs)
      book_support(dof, half_step * (f[dof] + f_external[dof]));
    drive(half_step, first);
    internal_half = first ? 0. : half_step;
    left_half     = 0.;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::book_support(const std::uint32_t dof, const double impulse)
  {
    const std::uint32_t n = dof / n_unknowns, c = dof % n_unknowns;
    if (c >= 3)
      {
        impulses.support_moment[c - 3] += impulse;
        return;
      }
    const unsigned int a = (c + 1) % 3, b = (c + 2) % 3;
    const double      *x = vectors->position.begin() + 3 * n;
    impulses.support_impulse[c] += impulse;
    impulses.support_moment[a] += x[b] * impulse;
    impulses.support_moment[b] -= x[a] * impulse;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::drive(const double half_step, const bool is_first)
  {
    if (driven.empty() && hub_dofs.empty())
      return;
    const DrivenKick kick{half_step, 1. - std::exp(-loads.damping() * half_step), is_first};
    const double     before = time - half_step, after = time + (is_first ? 2. : 1.) * half_step;
    const double    *u = vectors->displacement.begin();
    for (const Supports::Driven &support : driven)
      {
        const double to = support.at(after), from = is_first ? 0. : support.at(before); // nothing is before t = 0
        for (const std::uint32_t dof : support.dofs)
          drive(kick, dof, is_first ? u[dof] : from, to);
      }
    const Turn turn_before = is_first ? Turn() : rotor.turn(before), turn_after = rotor.turn(after);
    for (std::size_t k = 0; k < hub_dofs.size(); k += n_unknowns) // whole nodes
      {
        const std::uint32_t dof = hub_dofs[k];
        const Point3        reference(vectors->reference.begin() + 3 * (dof / n_unknowns));
        const Point3        to = turn_after.displacement(reference), from = turn_before.displacement(reference);
        const Point3        rotated_to = turn_after.rotation(), rotated_from = turn_before.rotation();
        for (unsigned int c = 0; c < 3; ++c)
          drive(kick, dof + c, is_first ? u[dof + c] : from[c], to[c]);
        for (unsigned int c = 3; c < n_unknowns; ++c)
          drive(kick, dof + c, is_first ? u[dof + c] : rotated_from[c - 3], rotated_to[c - 3]);
      }
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::drive(const DrivenKick &kick, const std::uint32_t dof, const double from,
                                         const double to)
  {
    // what kick_loaded has left of it, and with what velocity it has booked loads and damping
    double      &v = vectors->velocity.begin()[dof];
    const double f = vectors->force.begin()[dof], f_external = vectors->external.begin()[dof];
    const double now = v, before = now / (1. - kick.damped), booked_with = kick.is_first ? now : before;
    const double after = (to - from) / (2. * kick.half_step);
    const double drift = kick.is_first ? after : before, m = vectors->mass.begin()[dof];
    booked.external_work += 0.5 * m * (after * after - before * before) - kick.half_step * f * drift +
                            (m * kick.damped * before - kick.half_step * f_external) * booked_with;
    book_support(dof, -m * (after - before + kick.damped * before));
    v = after;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::follow_step(const double half_step)
  {
    if (std::abs(half_step - staggered_half) <= 1e-3 * staggered_half)
      return;
    const double of_contact = contact_half + left_half, before = staggered_half;
    booked.staggering += kinetic(half_step, before > 0. ? of_contact * half_step / before : 0.)[1];
    if (before > 0.)
      booked.staggering -= kinetic(before, of_contact)[1];
    staggered_half = half_step;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::kick_loaded(const double half_step, const bool first)
  {
    const double  decay = std::exp(-loads.damping() * half_step);
    double       *v     = vectors->velocity.begin();
    const double *f = scaled ? scaled->forces() : vectors->force.begin(), *f_external = vectors->external.begin();
    const double *inverse = vectors->inverse_mass.begin(), *m = vectors->mass.begin(), *x = vectors->position.begin();
    if (scaled && first)
      book_damping_of_scaling(half_step, first);
    const Sums sums = sum_nodes([=](const std::size_t n, Sums &sum) {
      std::array<double, n_unknowns> impulse; // of loads and damping
      for (unsigned int c = 0; c < n_unknowns; ++c)
        {
          const std::size_t i      = n_unknowns * n + c;
          const double      kick   = half_step * (f[i] + f_external[i]) * inverse[i];
          const double      before = v[i];
          v[i]                     = first ? before * decay + kick : (before + kick) * decay;
          const double drift = first ? v[i] : before, damped = first ? before : before + kick;
          sum[0] += half_step * f_external[i] * drift;
          sum[1] += m[i] * (1. - decay) * damped * drift;
          impulse[c] = half_step * f_external[i] - m[i] * (1. - decay) * damped;
        }
      for (unsigned int d = 0; d < 3; ++d)
        {
          const unsigned int a = (d + 1) % 3, b = (d + 2) % 3;
          sum[2 + d] += impulse[d];
          sum[5 + d] += x[3 * n + a] * impulse[b] - x[3 * n + b] * impulse[a];
          if constexpr (n_unknowns == 6)
            sum[5 + d] += impulse[3 + d];
        }
    });
    booked.external_work += sums[0];
    booked.damped += sums[1];
    if (scaled)
      booked.damped += scaled->dissipated({v, f_external, inverse, half_step, decay}, first);
    if (scaled && !first)
      book_damping_of_scaling(half_step, first);
    for (unsigned int d = 0; d < 3; ++d)
      {
        impulses.external_impulse[d] += sums[2 + d];
        impulses.external_moment[d] += sums[5 + d];
      }
  }

  /// Of the couplings, which have angular momentum of their own; before a first and after a second half kick.
  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::book_damping_of_scaling(const double half_step, const bool is_first)
  {
    const double decay = std::exp(-loads.damping() * half_step), lost = is_first ? 1. - decay : 1. / decay - 1.;
    if (lost == 0.)
      return;
    const auto carried = scaled->angular_momentum(vectors->position.begin(), vectors->velocity.begin());
    for (unsigned int d = 0; d < 3; ++d)
      impulses.external_moment[d] -= lost * carried[d];
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::kick_contact(const double half_step, const HalfKick half)
  {
    const bool    first = half == HalfKick::first;
    double       *v = vectors->velocity.begin(), *received = vectors->received.begin();
    const double *f = vectors->contact.begin(), *kicking = f, *inverse = vectors->inverse_mass.begin();
    if (scaled)
      {
        scaled->update_contact(f);
        kicking = scaled->contact();
      }

    // contact leaves the moments at zero: what happens to rotations is nothing
    const auto kick = [=, this](const auto is_scaled) {
      return sum_components<2>([=](const auto &at, Eight *sum) {
        Eight force_on, before, mobility, so_far;
        at.read(f, force_on);
        at.read(received, so_far);
        at.read(v, before);
        at.read(inverse, mobility);
        const Eight impulse = half_step * force_on;
        Eight       change  = impulse * mobility;
        if constexpr (is_scaled)
          {
            at.read(kicking, change);
            change = half_step * change * mobility;
          }
        const Eight after = before + change;
        at.write(after, v);
        at.write(so_far + impulse, received);
        sum[0] += impulse;
        sum[1] += impulse * (first ? after : before);
      });
    };
    const auto sums = scaled ? kick(std::true_type{}) : kick(std::false_type{});
    for (unsigned int d = 0; d < 3; ++d)
      impulses.contact_impulse[d] += sums[0][d];
    booked.contact_work += sums[1][0] + sums[1][1] + sums[1][2];
    for (const std::uint32_t dof : held_dofs)
      book_support(dof, half_step * kicking[dof]);
    for (const Supports::Driven &support : driven) // takes what contact does to it
      for (const std::uint32_t dof : support.dofs)
        booked.external_work -= half_step * f[dof] * v[dof];
    for (const std::uint32_t dof : hub_dofs)
      booked.external_work -= half_step * f[dof] * v[dof];
    left_half    = first ? contact_half : 0.;
    contact_half = first ? 0. : half_step;
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::drift(const double step)
  {
    const double *v = vectors->velocity.begin(), *x_0 = vectors->reference.begin();
    double       *u = vectors->displacement.begin(), *du = vectors->increment.begin(), *x = vectors->position.begin();
    const bool    is_first = increment_time == 0.; // since the last forces
    for_nodes(n_nodes, [=](const std::size_t begin, const std::size_t end) {
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
  NodeForces NodalMechanics<n_unknowns>::clear_contact_forces()
  {
    std::fill_n(vectors->contact.begin(), n_unknowns * n_nodes, 0.);
    if (scaled)
      scaled->clear_contact();
    return {vectors->contact.begin(), n_unknowns};
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::add_internal_forces(const std::span<const NodalForce> forces)
  {
    if (forces.empty())
      return;
    added.assign(forces.begin(), forces.end());
    for (const NodalForce &one : added)
      for (unsigned int d = 0; d < 3; ++d)
        vectors->force.begin()[n_unknowns * one.node + d] += one.force[d];
    if (scaled)
      scaled->update_forces(vectors->force.begin(), vectors->external.begin());
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::update_loads()
  {
    if (loads.is_active())
      {
        std::fill_n(vectors->external.begin(), n_unknowns * n_nodes, 0.);
        loads.add_forces(time, vectors->position.begin(), vectors->external.begin());
      }
    if (scaled)
      scaled->update_forces(vectors->force.begin(), vectors->external.begin());
  }

  template <unsigned int n_unknowns>
  void NodalMechanics<n_unknowns>::scale(const NodeColumns  &columns,
                                         std::vector<double> coupling) requires(n_unknowns == 3)
  {
    if (!driven.empty())
      throw InputError("Blade/Mass scaling/Method: 'selective' cannot be combined with prescribed displacements.\nSet "
                       "it to off, or constrain the nodes of Supports/Driven.");
    scaled = std::make_unique<ScaledNodes>(
      ColumnMass(columns, std::move(coupling), vectors->inverse_mass.begin(), n_owned, pool), n_unknowns * n_nodes);
    scaled->update_forces(vectors->force.begin(), vectors->external.begin());
  }

  template class NodalMechanics<3>;
  template class NodalMechanics<6>;
} // namespace birdstrike
