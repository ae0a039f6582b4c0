#include "simulation/symmetry.h"

namespace birdstrike
{
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
    const SymmetryPlane plane(mirrored);
    for (const PartOfSystem part : parts_of_system)
      state.*part = plane.whole(state.*part);
    state.bird_momentum  = plane.whole(state.bird_momentum);
    state.blade_momentum = plane.whole(state.blade_momentum);
    state.contact_dissipation_fall *= factor();
    return state;
  }
} // namespace birdstrike
