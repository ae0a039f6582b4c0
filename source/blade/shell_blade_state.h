#pragma once

#include "nodal_mechanics.h"

#include <birdstrike/blade/sections.h>
#include <birdstrike/blade/shell_blade.h>
#include <birdstrike/blade/shell_elements.h>
#include <birdstrike/blade/shell_mesh.h>
#include <birdstrike/blade/supports.h>

namespace birdstrike
{
  /// Everything a ShellBlade owns.
  struct ShellBlade::State
  {
    State(const BladeParameters &parameters, ThreadPool &pool);

    ShellMesh           mesh;
    Supports            supports;
    ShellMesh::Mass     lumped;
    ShellElements       elements;
    NodalMechanics<6>   nodes;
    RootSection         root;
    TipRow              tip;
    std::vector<double> half_thickness; ///< m, per element
  };
} // namespace birdstrike
