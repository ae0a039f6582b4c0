#include "structure/shell_blade_state.h"

namespace birdstrike
{
  ShellBlade::ShellBlade(const BladeParameters &parameters, ThreadPool &pool)
    : state(std::make_unique<State>(parameters, pool))
  {
  }

  ShellBlade::~ShellBlade() = default;

  void ShellBlade::kick_internal(const double half_step, const HalfKick half)
  {
    state->nodes.kick_internal(half_step, half);
  }

  void ShellBlade::kick_contact(const double half_step, const HalfKick half)
  {
    state->nodes.kick_contact(half_step, half);
  }

  void ShellBlade::drift(const double step)
  {
    state->nodes.drift(step);
  }

  void ShellBlade::compute_internal_forces()
  {
    state->nodes.compute_internal_forces(state->elements);
    if (state->elements.n_failed() != state->n_failed)
      state->update_failed();
  }

  NodeForces ShellBlade::clear_contact_forces()
  {
    return state->nodes.clear_contact_forces();
  }

  void ShellBlade::set_contact_in_transit(const double duration)
  {
    state->nodes.set_contact_in_transit(duration);
  }

  FacetsView ShellBlade::facets() const
  {
    FacetsView view = state->nodes.facets();
    state->surface.offer(view);
    return view;
  }

  void ShellBlade::add_internal_forces(const std::span<const NodalForce> forces)
  {
    state->nodes.add_internal_forces(forces);
  }

  NodeArrays ShellBlade::nodes()
  {
    return state->nodes.arrays();
  }
} // namespace birdstrike
