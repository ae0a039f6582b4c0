#include "mass_scaling_case.h"

namespace birdstrike::test
{
  BladeParameters scaled_plate(const unsigned int n_span, const unsigned int n_chord, const unsigned int n_layers)
  {
    BladeParameters p            = elastic_plate(n_span, n_chord);
    p.kind                       = BladeKind::solid;
    p.mesh.n_layers              = n_layers;
    p.mass_scaling.method        = MassScalingMethod::selective;
    p.mass_scaling.largest_added = 10.;
    return p;
  }

  BladeParameters without_viscosity(BladeParameters p)
  {
    p.element.linear_viscosity = p.element.quadratic_viscosity = 0.;
    return p;
  }
} // namespace birdstrike::test
