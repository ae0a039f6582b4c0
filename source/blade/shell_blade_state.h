#pragma once

#include "nodal_mechanics.h"

#include <birdstrike/blade/contact_surface.h>
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

    /// After elements have failed: they are no facets any more, and nothing presses on them.
    void update_failed();

    ShellMesh         mesh;
    Supports          supports;
    ShellMesh::Mass   lumped;
    ShellElements     elements;
    NodalMechanics<6> nodes;
    RootSection       root;
    TipRow            tip;
    ContactSurface    surface;
    bool              can_fail;
    std::size_t       n_failed = 0; ///< elements, as the surface knows them
  };
} // namespace birdstrike
