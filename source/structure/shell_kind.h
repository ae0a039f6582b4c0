#pragma once

#include "structure/elements/shell/elements.h"
#include "structure/nodes/nodal_mechanics.h"
#include "structure/nodes/supports.h"
#include "structure/pressed_facets.h"
#include "structure/probes/sections.h"
#include "structure/section_table.h"
#include "structure/surface/contact_surface.h"
#include <birdstrike/mesh/blade_mesh.h>

namespace birdstrike
{
  /// What makes a DeformableBlade one of quadrilateral shells: nodes have three displacements and three rotations,
  /// contact meets the mid-surface with half the thickness on either side, pressure pushes along its normal.
  struct ShellKind
  {
    using Mesh     = ShellMesh;
    using Elements = ShellElements;
    using Root     = RootSection;
    using Surface  = ContactSurface;
    using Nodes    = NodalMechanics<6>;

    static constexpr unsigned int n_unknowns = 6, dim = 2;
    static constexpr BladeKind    kind           = BladeKind::shell;
    static constexpr double       bytes_per_cell = 600.; ///< of deal.II's mesh, about

    static SectionTable assign_sections(const BladeParameters &parameters, const Mesh &mesh)
    {
      return SectionTable(parameters, mesh.material_ids, mesh.material_names, mesh.blades, mesh.file_element_ids);
    }
    static ElementFormulation formulation_of(const BladeParameters &section)
    {
      return section.shell_formulation();
    }
    static std::vector<unsigned int> count_layers(const Mesh &, const SectionTable &sections)
    {
      return std::vector<unsigned int>(sections.all.size(), 0);
    }
    static Mesh::Mass    compute_mass(const Mesh &mesh, const SectionTable &sections, const Supports &supports);
    static Elements      make_elements(const Mesh &mesh, const Mesh::Mass &mass, const SectionTable &sections,
                                       ThreadPool &pool);
    static Nodes::Masses masses(const Mesh::Mass &mass);

    /// N/m, of the elements in tension along a direction (zero: an unknown one): Young's modulus times thickness, of
    /// plies that of a membrane that does not bend.
    static std::vector<double> stiffness_along(const Point3 &direction, const Mesh &mesh, const Mesh::Mass &mass,
                                               const Elements &elements);

    static PressedFacets find_pressed(const Mesh &mesh, const BladeParameters::Loads &loads);
    static Surface       make_surface(const Mesh &mesh, const Mesh::Mass &mass);
    static std::size_t   n_nodes_in_contact(const Mesh &mesh, bool can_fail);

    /// What is left to do once nodes and elements are there; of what it scales of the masses a report.
    static MassScalingReport finish(const BladeParameters &parameters, const Mesh &mesh, const Mesh::Mass &mass,
                                    Elements &elements, Nodes &nodes);

    /// kg, of the element's plies whose fibres have failed, and of others whose matrix has.
    static std::array<double, 2> failed_ply_mass(const Elements &elements, std::size_t element);

    /// Of the elements in the list.
    static void add_fields(const Elements &elements, const std::vector<std::size_t> &cells, std::vector<Field> &fields);
    /// Nodes of a cell in the order of FieldSnapshot::cells.
    static std::array<std::uint32_t, 4> nodes_of(const Mesh &mesh, std::size_t cell);
  };
} // namespace birdstrike
