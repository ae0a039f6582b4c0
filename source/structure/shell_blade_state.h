#pragma once

#include "structure/nodes/nodal_mechanics.h"

#include "structure/elements/shell/elements.h"
#include "structure/nodes/supports.h"
#include "structure/probes/sections.h"
#include "structure/shell_blade.h"
#include "structure/surface/contact_surface.h"
#include <birdstrike/mesh/shell_mesh.h>

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
