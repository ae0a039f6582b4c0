#pragma once

#include "structure/elements/solid/elements.h"
#include "structure/probes/sections.h"
#include <birdstrike/mesh/cell_mesh.h>
#include <birdstrike/structure/rotor.h>

#include <vector>

namespace birdstrike
{
  /// The clamped faces of a solid as a section: forces from their nodes, stresses at the middle of the skin facets that
  /// adjoin them, half an element from the root as in the shell, with no stress across (SolidElements::face_state):
  /// that of a brick beside the clamp is hundreds of MPa, the more the thinner it is. A bird's pressure there is left
  /// out.
  class SolidRootSection
  {
  public:
    SolidRootSection() = default; ///< absent
    SolidRootSection(const SolidMesh &mesh, const BladeEnd &root);

    /// From the nodal forces [n_nodes][3] that elements exert (N) at positions [n_nodes][3] (m), and the stresses at
    /// the faces. Each facet of the struck side is paired with the nearest of the rear. On a blade that turns, forces
    /// and positions are those in the turning frame; stresses are turned back.
    RootSectionReport compute_report(const double *force, const double *position, const SolidElements &elements,
                                     const Turn &turned = {}) const;

    std::size_t count_failed(const SolidElements &elements) const;  ///< of the elements whose stress it reports
    void        add_nodes(std::vector<std::uint32_t> &nodes) const; ///< those that a report asks

  private:
    struct Facet
    {
      std::uint32_t                cell;
      std::array<std::uint32_t, 4> nodes;          ///< counter-clockwise about the outward normal
      SolidFace                    face;           ///< of the cell
      double                       chord_position; ///< m from the middle of the section
    };
    std::vector<Facet> make_facets(const VolumeMesh &mesh, const std::vector<std::size_t> &faces) const;
    double stress(const Facet &facet, const double *position, const SolidElements &elements, const Turn &turned) const;

    BladeEnd                          root;
    std::array<std::vector<Facet>, 2> facets; ///< struck and rear, as many, by chord position
  };
} // namespace birdstrike
