#pragma once

#include "nodal_mechanics.h"

#include <birdstrike/blade/solid_blade.h>
#include <birdstrike/blade/solid_elements.h>
#include <birdstrike/blade/solid_mesh.h>
#include <birdstrike/blade/solid_sections.h>

namespace birdstrike
{
  /// Everything a SolidBlade owns.
  struct SolidBlade::State
  {
    State(const BladeParameters &parameters, ThreadPool &pool);
    void scale_masses(const BladeParameters &parameters);

    SolidMesh           mesh;
    Supports            supports;
    SolidMesh::Mass     lumped;
    SolidElements       elements;
    NodalMechanics<3>   nodes;
    SolidRootSection    root;
    TipRow              tip;
    MassScalingReport   scaling;
    std::vector<double> half_thickness; ///< m, per facet of the skin: nothing lies beyond it
  };
} // namespace birdstrike
