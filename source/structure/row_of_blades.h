#pragma once

#include "structure/nodes/nodal_mechanics.h"
#include "structure/probes/sections.h"
#include "structure/section_table.h"
#include <birdstrike/mesh/roles.h>

#include <array>
#include <vector>

namespace birdstrike
{
  /// What is told of each blade of a row apart: its root section and tip, its elements' energies, its nodes' motion.
  /// Copies have the sides and nodes that the described blade has, and its axes turned there.
  template <class Kind>
  class RowOfBlades
  {
  public:
    using Mesh     = typename Kind::Mesh;
    using Elements = typename Kind::Elements;
    using Motion   = NodalMechanics<Kind::n_unknowns>;

    RowOfBlades() = default; ///< one blade: nothing
    /// `described`: roles of the blade that is; ids of root and tip as there.
    RowOfBlades(const MeshParameters::Row &row, const Mesh &mesh, const SectionTable &sections,
                const BladeRoles &described, const std::vector<unsigned int> &root_ids,
                const std::vector<unsigned int> &tip_ids);

    /// Forces, positions and displacements as RootSection and TipRow take them, on a hub that turns those in its frame.
    std::vector<BladeLoads>   loads(const double *force, const double *position, const double *displacement,
                                    const Elements &elements, const Turn &turned) const;
    void                      add_nodes(std::vector<std::uint32_t> &nodes) const; ///< those that loads() asks
    std::vector<BladeBalance> balance(const Motion &motion, const Elements &elements) const;

  private:
    struct Member
    {
      unsigned int               place;
      bool                       is_rigid;
      std::size_t                first_section; ///< of n_sections, among those of the elements
      std::vector<std::uint32_t> nodes;
      typename Kind::Root        root;
      TipRow                     tip;
    };
    std::size_t         n_sections = 0; ///< of each blade
    std::vector<Member> members;        ///< by place
  };
} // namespace birdstrike
