#include "structure/shell_kind.h"
#include "structure/elements/von_mises.h"
#include "structure/stress_fields.h"

#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/nodal_thickness.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace birdstrike
{
  namespace
  {
    /// Of PlyDamage.
    const std::array<std::string, PlyDamage<double>::n_modes> failure_modes{
      {"fibre_tension", "fibre_compression", "matrix_tension", "matrix_compression"}};

    std::shared_ptr<const Laminate> make_laminate(const LaminateParameters &p)
    {
      const auto       direction = p.reference();
      const PlyStack   stack     = p.stack();
      std::vector<Ply> plies;
      for (const PlyMaterial &material : stack.materials)
        plies.push_back(material.ply);
      auto laminate = std::make_shared<Laminate>(plies, stack.layers, Point3(direction.data()), p.n_per_ply);
      laminate->degradation_time      = p.degradation_time;
      laminate->failed_share          = p.failed_share;
      laminate->smallest_step         = p.smallest_step;
      laminate->matrix_failure_strain = p.matrix_failure_strain;
      return laminate;
    }

    ShellSection make_section(const BladeParameters &parameters)
    {
      ShellSection section;
      section.formulation = parameters.shell_formulation();
      section.rule        = parameters.element.rule;
      section.n_points    = parameters.element.n_points;
      if (parameters.is_laminate())
        section.laminate = make_laminate(parameters.laminate);
      else
        section.material = parameters.material.metal();
      section.hourglass_coefficient = parameters.element.hourglass;
      section.shear_factor          = parameters.element.shear_factor;
      section.has_thinning          = parameters.element.has_thinning;
      return section;
    }

    std::vector<Point3> points_of(const SurfaceMesh &mesh)
    {
      std::vector<Point3> points;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        points.push_back(mesh.node(n));
      return points;
    }
  } // namespace

  std::array<double, 2> ShellKind::failed_ply_mass(const Elements &elements, const std::size_t element)
  {
    return elements.failed_ply_mass(element);
  }

  ShellMesh::Mass ShellKind::compute_mass(const Mesh &mesh, const SectionTable &sections, const Supports &supports)
  {
    return mesh.compute_mass(sections.density_law(), sections.thickness_law(),
                             find_nodal_thickness(sections.all.front(), mesh, supports.root_ids, supports.tip_ids));
  }

  ShellElements ShellKind::make_elements(const Mesh &mesh, const Mesh::Mass &mass, const SectionTable &table,
                                         ThreadPool &pool)
  {
    return ShellElements(points_of(mesh), mesh.cells, mass.element_thickness,
                         make_sections<ShellSection>(table, make_section), pool);
  }

  std::vector<double> ShellKind::stiffness_along(const Point3 &direction, const Mesh &mesh, const Mesh::Mass &mass,
                                                 const Elements &elements)
  {
    std::vector<double> stiffness = mass.element_thickness;
    for (std::size_t e = 0; e < stiffness.size(); ++e)
      {
        const ShellSection &section = elements.section(e);
        if (!section.laminate)
          {
            stiffness[e] *= section.material.elasticity.young;
            continue;
          }
        const Point3 normal    = mesh.area_vector(e).normalized();
        const Point3 reference = section.laminate->reference;
        const Point3 first = (reference - reference.dot(normal) * normal).normalized(), second = normal.cross(first);
        const double cos = direction.dot(first), sin = direction.dot(second), norm = std::hypot(cos, sin);
        stiffness[e] *= norm > 0. ? section.laminate->uniaxial(cos / norm, sin / norm).modulus
                                  : section.laminate->uniaxial(1., 0.).modulus;
      }
    return stiffness;
  }

  NodalMechanics<6>::Masses ShellKind::masses(const Mesh::Mass &mass)
  {
    return {mass.node, mass.rotary};
  }

  PressedFacets ShellKind::find_pressed(const Mesh &mesh, const BladeParameters::Loads &loads)
  {
    if (!is_present(loads.pressure))
      return {};
    PressedFacets pressed{mesh.cells, std::vector<std::uint32_t>(mesh.cells.size())};
    std::iota(pressed.elements.begin(), pressed.elements.end(), 0);
    return pressed;
  }

  ContactSurface ShellKind::make_surface(const Mesh &mesh, const Mesh::Mass &mass)
  {
    std::vector<double> half_thickness = mass.element_thickness;
    for (double &value : half_thickness)
      value *= 0.5;
    return ContactSurface(mesh, std::move(half_thickness));
  }

  std::size_t ShellKind::n_nodes_in_contact(const Mesh &mesh, bool)
  {
    return mesh.nodes.size();
  }

  MassScalingReport ShellKind::finish(const BladeParameters &parameters, const Mesh &mesh, const Mesh::Mass &,
                                      Elements &elements, Nodes &)
  {
    if (parameters.is_halved)
      elements.add_symmetry_plane(mesh.symmetry_nodes, Point3::UnitY());
    return {};
  }

  void ShellKind::add_fields(const Elements &elements, const std::vector<std::size_t> &cells,
                             std::vector<Field> &fields)
  {
    static constexpr std::array<ShellLayer, 3> layers{{ShellLayer::bottom, ShellLayer::middle, ShellLayer::top}};
    static const std::array<std::string, 3>    names{{"bottom", "middle", "top"}};
    const auto add = [&](const std::string &name, const std::string &unit, const auto &value) {
      Field field{name, unit, true, 1, {}};
      field.values.reserve(cells.size());
      for (const std::size_t cell : cells)
        field.values.push_back(value(cell));
      fields.push_back(std::move(field));
    };
    for (unsigned int k = 0; k < layers.size(); ++k)
      {
        const auto stress = [&](const std::size_t e) { return elements.global_layer_stress(e, layers[k]); };
        add("equivalent_plastic_strain_" + names[k], "-",
            [&](const std::size_t e) { return elements.layer_plastic_strain(e, layers[k]); });
        add("von_mises_stress_" + names[k], "Pa", [&](const std::size_t e) { return von_mises(stress(e)); });
        if (layers[k] == ShellLayer::middle)
          continue; // the mid-surface stress follows from both faces
        std::vector<std::array<double, 6>> stresses;
        for (const std::size_t e : cells)
          stresses.push_back(stress(e));
        add_stress_fields("_" + names[k], stresses, fields);
      }
    add("thickness", "m", [&](const std::size_t e) { return elements.state(e).thickness; });
    if (std::any_of(cells.begin(), cells.end(), [&](const std::size_t e) {
          return elements.section(e).laminate && elements.section(e).can_fail();
        }))
      for (std::size_t mode = 0; mode < failure_modes.size(); ++mode)
        add("failed_" + failure_modes[mode], "-", [&](const std::size_t e) { return elements.failed_shares(e)[mode]; });
  }

  std::array<std::uint32_t, 4> ShellKind::nodes_of(const Mesh &mesh, const std::size_t cell)
  {
    const auto &c = mesh.cells[cell];
    return {c[0], c[1], c[3], c[2]};
  }
} // namespace birdstrike
