#include "simulation/symmetry.h"

namespace birdstrike
{
  std::array<double, 3> Symmetry::whole(std::array<double, 3> vector) const
  {
    return mirrored ? std::array<double, 3>{{2. * vector[0], 0., 2. * vector[2]}} : vector;
  }

  EnergyReport Symmetry::whole(EnergyReport energy) const
  {
    for (double *part : {&energy.kinetic, &energy.staggering, &energy.elastic, &energy.plastic, &energy.hourglass,
                         &energy.viscous, &energy.dissipated, &energy.retired, &energy.eroded, &energy.external_work,
                         &energy.contact_work, &energy.internal, &energy.retired_made})
      *part *= factor();
    return energy;
  }

  MomentumReport Symmetry::whole(MomentumReport momentum) const
  {
    for (auto *vector : {&momentum.momentum, &momentum.support_impulse, &momentum.retired, &momentum.external_impulse,
                         &momentum.contact_impulse})
      *vector = whole(*vector);
    if (mirrored)
      for (auto *axial :
           {&momentum.angular_momentum, &momentum.support_moment, &momentum.retired_moment, &momentum.external_moment})
        *axial = {{0., 2. * (*axial)[1], 0.}};
    momentum.impulse_scale *= factor();
    momentum.moment_scale *= factor();
    return momentum;
  }

  RootSectionReport Symmetry::whole(RootSectionReport root) const
  {
    for (double *part : {&root.normal_force, &root.bending_moment, &root.transverse_force})
      *part *= factor();
    return root;
  }

  FailureReport Symmetry::whole(FailureReport failure) const
  {
    for (std::size_t *count : {&failure.n_elements, &failure.n_collapsed, &failure.n_at_root, &failure.n_free_nodes})
      *count *= factor();
    for (double *mass : {&failure.mass, &failure.free_mass})
      *mass *= factor();
    return failure;
  }

  SystemState Symmetry::whole(SystemState state) const
  {
    return {whole(state.bird),
            whole(state.blade),
            whole(state.bird_momentum),
            whole(state.blade_momentum),
            factor() * state.contact_stored,
            factor() * state.contact_dissipated,
            factor() * state.self_contact_stored,
            factor() * state.self_contact_dissipated,
            factor() * state.contact_dissipation_fall};
  }
} // namespace birdstrike
