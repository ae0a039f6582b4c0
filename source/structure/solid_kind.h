#pragma once

#include "structure/elements/solid/elements.h"
#include "structure/nodes/nodal_mechanics.h"
#include "structure/nodes/supports.h"
#include "structure/pressed_facets.h"
#include "structure/probes/solid_sections.h"
#include "structure/section_table.h"
#include "structure/surface/eroding_skin.h"
#include <birdstrike/mesh/blade_mesh.h>

namespace birdstrike
{
  /// What makes a DeformableBlade one of hexahedra.
  ///
  /// The same parameters make the shell and the solid of a part. What differs: nodes have three displacements, and
  /// clamped ids are faces whose nodes lose these; pressure acts on the facets of Loads/Pressure boundaries, pushing
  /// inwards (on the built-in face at minus the normal this is the shell's direction); contact sees the skin, closed
  /// and one-sided, without any thickness beyond it; the tip row is the mean of both faces, the root stress that on
  /// both faces. Selective mass scaling (source/structure/nodes/mass_scaling.h) keeps thin layers from ruling the step.
  struct SolidKind
  {
    using Mesh     = SolidMesh;
    using Elements = SolidElements;
    using Root     = SolidRootSection;
    using Surface  = ErodingSkin;
    using Nodes    = NodalMechanics<3>;

    static constexpr unsigned int n_unknowns = 3, dim = 3;
    static constexpr BladeKind    kind           = BladeKind::solid;
    static constexpr double       bytes_per_cell = 1200.; ///< of deal.II's mesh, about

    /// With `automatic` formulations chosen, brick by brick where a mesh from a file has other numbers of layers.
    static SectionTable       assign_sections(const BladeParameters &parameters, const Mesh &mesh);
    static ElementFormulation formulation_of(const BladeParameters &section) ///< of the table
    {
      return section.solid_formulation(section.mesh.n_layers);
    }
    /// By section of the table: the fewest bricks from skin to skin through one of its own.
    static std::vector<unsigned int> count_layers(const Mesh &mesh, const SectionTable &sections);
    static Mesh::Mass    compute_mass(const Mesh &mesh, const SectionTable &sections, const Supports &supports);
    static Elements      make_elements(const Mesh &mesh, const Mesh::Mass &mass, const SectionTable &sections,
                                       ThreadPool &pool);
    static Nodes::Masses masses(const Mesh::Mass &mass);

    /// Pa, of the elements: Young's modulus.
    static std::vector<double> stiffness_along(const Point3 &direction, const Mesh &mesh, const Mesh::Mass &mass,
                                               const Elements &elements);

    static PressedFacets find_pressed(const Mesh &mesh, const BladeParameters::Loads &loads);
    static Surface       make_surface(const Mesh &mesh, const Mesh::Mass &mass);
    static std::size_t   n_nodes_in_contact(const Mesh &mesh, bool can_fail);

    static MassScalingReport finish(const BladeParameters &parameters, const Mesh &mesh, const Mesh::Mass &mass,
                                    Elements &elements, Nodes &nodes);

    /// There are no laminates of bricks.
    static std::array<double, 2> failed_ply_mass(const Elements &, std::size_t)
    {
      return {};
    }

    static void add_fields(const Elements &elements, const std::vector<std::size_t> &cells, std::vector<Field> &fields);
    static const std::array<std::uint32_t, 8> &nodes_of(const Mesh &mesh, std::size_t cell);
  };
} // namespace birdstrike
