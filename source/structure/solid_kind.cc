#include "structure/solid_kind.h"
#include "structure/elements/solid/thickness.h"
#include "structure/elements/von_mises.h"
#include "structure/nodes/mass_scaling.h"
#include "structure/stress_fields.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>
#include <limits>

namespace birdstrike
{
  namespace
  {
    SolidSection make_section(const BladeParameters &parameters)
    {
      SolidSection section;
      section.formulation         = parameters.solid_formulation(parameters.mesh.n_layers); // of a file it is named
      section.material            = parameters.material.metal();
      section.rule                = parameters.element.rule;
      section.n_points            = parameters.element.n_points;
      section.linear_viscosity    = parameters.element.linear_viscosity;
      section.quadratic_viscosity = parameters.element.quadratic_viscosity;
      return section;
    }

    std::vector<Point3> points_of(const VolumeMesh &mesh)
    {
      std::vector<Point3> points;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        points.push_back(mesh.node(n));
      return points;
    }

    /// Bricks from skin to skin, per cell.
    std::vector<std::uint32_t> layers_of(const SolidMesh &mesh)
    {
      return mesh.layers > 0 ? std::vector<std::uint32_t>(mesh.cells.size(), mesh.layers)
                             : solid_shell::find_thickness(points_of(mesh), mesh.cells).n_layers;
    }
  } // namespace

  SectionTable SolidKind::assign_sections(const BladeParameters &parameters, const Mesh &mesh)
  {
    SectionTable table(parameters, mesh.material_ids, mesh.material_names, mesh.blades, mesh.file_element_ids);
    if (mesh.layers > 0)
      return table;
    const auto        n_layers = layers_of(mesh);
    std::vector<bool> has_more;
    for (const std::uint32_t n : n_layers)
      has_more.push_back(n != 1);
    for (std::size_t k = 0, n_given = table.all.size(); k < n_given; ++k)
      {
        BladeParameters &section = table.all[k];
        if (!std::holds_alternative<std::monostate>(section.element.formulation))
          continue;
        const auto first = static_cast<std::size_t>(std::ranges::find(table.of_element, k) - table.of_element.begin());
        const SolidFormulation of_one = section.solid_formulation(1), of_more = section.solid_formulation(2);
        const bool             is_single = first == n_layers.size() || !has_more[first];
        if (const auto other = of_one == of_more ? std::nullopt : table.split(k, has_more))
          {
            table.all[*other].element.formulation = of_more;
            table.all[k].element.formulation      = of_one;
          }
        else
          table.all[k].element.formulation = is_single ? of_one : of_more;
      }
    return table;
  }

  std::vector<unsigned int> SolidKind::count_layers(const Mesh &mesh, const SectionTable &sections)
  {
    const auto                of_cells = layers_of(mesh);
    std::vector<unsigned int> fewest(sections.all.size(), std::numeric_limits<unsigned int>::max());
    for (std::size_t e = 0; e < of_cells.size(); ++e)
      {
        unsigned int &of_section = fewest[sections.of_element[e]];
        of_section               = std::min(of_section, of_cells[e]);
      }
    return fewest;
  }

  SolidMesh::Mass SolidKind::compute_mass(const Mesh &mesh, const SectionTable &sections, const Supports &)
  {
    return mesh.compute_mass(sections.density_law());
  }

  SolidElements SolidKind::make_elements(const Mesh &mesh, const Mesh::Mass &, const SectionTable &table,
                                         ThreadPool &pool)
  {
    return SolidElements(points_of(mesh), mesh.cells, make_sections<SolidSection>(table, make_section), pool);
  }

  std::vector<double> SolidKind::stiffness_along(const Point3 &, const Mesh &mesh, const Mesh::Mass &,
                                                 const Elements &elements)
  {
    std::vector<double> stiffness;
    for (std::size_t e = 0; e < mesh.cells.size(); ++e)
      stiffness.push_back(elements.section(e).material.elasticity.young);
    return stiffness;
  }

  NodalMechanics<3>::Masses SolidKind::masses(const Mesh::Mass &mass)
  {
    return {mass.node, {}};
  }

  /// The skin facets that pressure acts on, turned so that their normals point inwards.
  PressedFacets SolidKind::find_pressed(const Mesh &mesh, const BladeParameters::Loads &loads)
  {
    PressedFacets pressed;
    if (!is_present(loads.pressure))
      return pressed;
    const auto ids = mesh.boundary_names.parse(loads.pressure_boundaries, "Blade/Loads/Pressure boundaries");
    for (const auto &face : mesh.boundary)
      if (std::find(ids.begin(), ids.end(), face.id) != ids.end())
        {
          pressed.facets.push_back({{face.nodes[0], face.nodes[3], face.nodes[2], face.nodes[1]}});
          pressed.elements.push_back(face.cell);
        }
    if (pressed.facets.empty())
      throw InputError(
        "Blade/Loads/Pressure boundaries: no face of the mesh has one of the ids '" + loads.pressure_boundaries +
        "'.\nPressure on a solid needs faces to act on; names in this mesh: " + mesh.boundary_names.list() + ".");
    return pressed;
  }

  ErodingSkin SolidKind::make_surface(const Mesh &mesh, const Mesh::Mass &)
  {
    return ErodingSkin(mesh);
  }

  std::size_t SolidKind::n_nodes_in_contact(const Mesh &mesh, const bool can_fail)
  {
    // where elements fail, nodes inside may become the skin's
    return can_fail ? mesh.nodes.size() : mesh.n_skin_nodes;
  }

  MassScalingReport SolidKind::finish(const BladeParameters &parameters, const Mesh &mesh, const Mesh::Mass &mass,
                                      Elements &elements, Nodes &nodes)
  {
    if (parameters.mass_scaling.method != MassScalingMethod::selective)
      return {};
    const NodeColumns columns(mesh);
    MassScaling       chosen = choose_mass_scaling(parameters, mesh, columns, elements, mass.node);
    elements.scale_masses(chosen.scale);
    nodes.scale(columns, std::move(chosen.coupling));
    chosen.report.step = elements.largest_stable_step();
    return chosen.report;
  }

  void SolidKind::add_fields(const Elements &elements, const std::vector<std::size_t> &cells,
                             std::vector<Field> &fields)
  {
    std::vector<SolidState>            states;
    std::vector<std::array<double, 6>> stresses;
    for (const std::size_t e : cells)
      {
        states.push_back(elements.state(e));
        stresses.push_back(states.back().stress);
      }
    const auto add = [&](const std::string &name, const std::string &unit, const auto &value) {
      Field field{name, unit, true, 1, {}};
      field.values.reserve(states.size());
      for (const SolidState &state : states)
        field.values.push_back(value(state));
      fields.push_back(std::move(field));
    };
    add("equivalent_plastic_strain", "-", [](const SolidState &s) { return s.plastic_strain; });
    add("largest_equivalent_plastic_strain", "-", [](const SolidState &s) { return s.max_plastic_strain; });
    add("von_mises_stress", "Pa", [](const SolidState &s) { return von_mises(s.stress); });
    add_stress_fields("", stresses, fields);
  }

  const std::array<std::uint32_t, 8> &SolidKind::nodes_of(const Mesh &mesh, const std::size_t cell)
  {
    return mesh.cells[cell];
  }
} // namespace birdstrike
