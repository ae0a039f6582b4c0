#pragma once

#include "structure/nodes/nodal_mechanics.h"

#include "structure/elements/solid/elements.h"
#include "structure/probes/solid_sections.h"
#include "structure/solid_blade.h"
#include "structure/surface/eroding_skin.h"
#include <birdstrike/mesh/solid_mesh.h>

namespace birdstrike
{
  /// Everything a SolidBlade owns.
  struct SolidBlade::State
  {
    State(const BladeParameters &parameters, ThreadPool &pool);
    void scale_masses(const BladeParameters &parameters);

    /// After elements have failed: the skin is that of the others, and nothing presses on them.
    void update_failed();

    SolidMesh                  mesh;
    Supports                   supports;
    SolidMesh::Mass            lumped;
    SolidElements              elements;
    std::vector<std::uint32_t> pressed_cells; ///< behind the quadrilaterals that pressure acts on
    NodalMechanics<3>          nodes;
    SolidRootSection           root;
    TipRow                     tip;
    MassScalingReport          scaling;
    ErodingSkin                skin;
    bool                       can_fail;
    std::size_t                n_failed = 0; ///< elements, as the skin knows them
  };
} // namespace birdstrike
