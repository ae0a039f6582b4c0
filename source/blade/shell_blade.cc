#include "shell_blade_state.h"

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  ShellBlade::ShellBlade(const BladeParameters &parameters, ThreadPool &pool)
    : state(std::make_unique<State>(parameters, pool))
  {
  }

  ShellBlade::~ShellBlade() = default;

  void ShellBlade::kick_internal(const double half_step, const HalfKick half)
  {
    State        &s     = *state;
    const double  decay = std::exp(-s.damping * half_step);
    const bool    first = half == HalfKick::first;
    double       *v     = s.velocity.data();
    const double *f = s.force.data(), *external = s.external.data(), *inverse = s.inverse_mass.data();

    if (s.damping == 0. && !s.loads.is_active())
      s.for_nodes([=](const std::size_t begin, const std::size_t end) {
        for (std::size_t i = 6 * begin; i < 6 * end; ++i)
          v[i] += half_step * f[i] * inverse[i];
      });
    else
      {
        const double     *m    = s.mass.data();
        const State::Sums sums = s.sum_nodes([=](const std::size_t n, State::Sums &sum) {
          for (std::size_t i = 6 * n; i < 6 * n + 6; ++i)
            {
              const double kick   = half_step * (f[i] + external[i]) * inverse[i];
              const double before = v[i];
              v[i]                = first ? before * decay + kick : (before + kick) * decay;
              const double drift = first ? v[i] : before, damped = first ? before : before + kick;
              sum[0] += half_step * external[i] * drift;
              sum[1] += m[i] * (1. - decay) * damped * drift;
            }
          for (unsigned int d = 0; d < 3; ++d)
            sum[2 + d] += half_step * external[6 * n + d];
        });
        s.booked.external_work += sums[0];
        s.booked.dissipated += sums[1];
        for (unsigned int d = 0; d < 3; ++d)
          s.impulses.external_impulse[d] += sums[2 + d];
      }
    for (const std::uint32_t dof : s.supports.held_dofs)
      if (dof % 6 < 3)
        s.impulses.support_impulse[dof % 6] += half_step * (f[dof] + external[dof]);
    s.internal_half = first ? 0. : half_step;
  }

  void ShellBlade::kick_contact(const double half_step, const HalfKick half)
  {
    State        &s     = *state;
    const bool    first = half == HalfKick::first;
    double       *v     = s.velocity.data();
    const double *f = s.contact.data(), *inverse = s.inverse_mass.data();

    // contact leaves the moments at zero: what happens to rotations is nothing
    const auto sums = s.sum_components<2>([=](const std::size_t i, Eight *sum) {
      Eight force, before, mobility;
      read(f + i, force);
      read(v + i, before);
      read(inverse + i, mobility);
      const Eight impulse = half_step * force, after = before + impulse * mobility;
      write(after, v + i);
      sum[0] += impulse;
      sum[1] += impulse * (first ? after : before);
    });
    for (unsigned int d = 0; d < 3; ++d)
      s.impulses.contact_impulse[d] += sums[0][d];
    s.booked.contact_work += sums[1][0] + sums[1][1] + sums[1][2];
    for (const std::uint32_t dof : s.supports.held_dofs)
      if (dof % 6 < 3)
        s.impulses.support_impulse[dof % 6] += half_step * f[dof];
    s.contact_half = first ? 0. : half_step;
  }

  void ShellBlade::drift(const double step)
  {
    State        &s = *state;
    const double *v = s.velocity.data(), *reference = s.reference.data();
    double       *u = s.displacement.data(), *du = s.increment.data(), *x = s.position.data();
    const bool    is_first = s.increment_time == 0.; // since the last forces
    s.for_nodes([=](const std::size_t begin, const std::size_t end) {
      if (is_first)
        for (std::size_t i = 6 * begin; i < 6 * end; ++i)
          du[i] = step * v[i];
      else
        for (std::size_t i = 6 * begin; i < 6 * end; ++i)
          du[i] += step * v[i];
      for (std::size_t i = 6 * begin; i < 6 * end; ++i)
        u[i] += step * v[i];
      for (std::size_t n = begin; n < end; ++n)
        for (unsigned int d = 0; d < 3; ++d)
          x[3 * n + d] = reference[3 * n + d] + u[6 * n + d];
    });
    s.time += step;
    s.increment_time += step;
  }

  void ShellBlade::compute_internal_forces()
  {
    State &s = *state;
    if (s.increment_time > 0.)
      s.elements.compute_internal_forces(s.position.data(), s.increment.data(), s.increment_time, s.force.data());
    s.increment_time = 0.;
    s.update_loads();
  }

  void ShellBlade::clear_contact_forces()
  {
    std::fill(state->contact.begin(), state->contact.end(), 0.);
  }

  FacetsView ShellBlade::facets()
  {
    State             &s    = *state;
    const SurfaceMesh &mesh = s.mesh.surface();
    FacetsView         view;
    view.n_nodes         = s.n_nodes;
    view.position        = s.position.data();
    view.velocity        = s.velocity.data();
    view.force           = s.contact.data();
    view.inverse_mass    = s.node_inverse_mass.data();
    view.velocity_stride = 6;
    view.n_facets        = mesh.cells.size();
    view.nodes           = mesh.cells.data();
    view.neighbor        = mesh.neighbors.data();
    view.half_thickness  = s.half_thickness.data();
    return view;
  }

  ShellBlade::Nodes ShellBlade::nodes()
  {
    State &s = *state;
    return {s.n_nodes,         s.reference.data(), s.position.data(), s.displacement.data(),
            s.velocity.data(), s.force.data(),     s.mass.data(),     s.inverse_mass.data()};
  }
} // namespace birdstrike
