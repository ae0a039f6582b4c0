#include <birdstrike/simulation/symmetry.h>

namespace birdstrike
{
  std::array<double, 3> Symmetry::whole(std::array<double, 3> vector) const
  {
    return mirrored ? std::array<double, 3>{{2. * vector[0], 0., 2. * vector[2]}} : vector;
  }

  EnergyReport Symmetry::whole(EnergyReport energy) const
  {
    for (double *part :
         {&energy.kinetic, &energy.elastic, &energy.plastic, &energy.hourglass, &energy.viscous, &energy.dissipated,
          &energy.retired, &energy.eroded, &energy.external_work, &energy.contact_work})
      *part *= factor();
    return energy;
  }

  MomentumReport Symmetry::whole(MomentumReport momentum) const
  {
    for (auto *vector : {&momentum.momentum, &momentum.support_impulse, &momentum.retired, &momentum.external_impulse,
                         &momentum.contact_impulse})
      *vector = whole(*vector);
    if (mirrored)
      momentum.angular_momentum = {{0., 2. * momentum.angular_momentum[1], 0.}};
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
            factor() * state.self_contact_dissipated};
  }
} // namespace birdstrike
