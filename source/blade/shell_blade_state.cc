#include "shell_blade_state.h"
#include "section_choices.h"

#include <birdstrike/blade/text_lists.h>
#include <birdstrike/core/errors.h>

#include <cmath>
#include <map>

namespace birdstrike
{
  namespace
  {
    ShellMesh::ThicknessLaw make_thickness(const BladeParameters::Thickness &parameters)
    {
      std::map<unsigned int, double> by_material;
      for (const auto &[key, value] : parse_pairs(parameters.by_material, "Thickness/By material"))
        for (const unsigned int id : parse_ids(key, "Thickness/By material"))
          by_material[id] = parse_numbers(value, 1, "Thickness/By material")[0];
      const auto expression = std::make_shared<Expression>(parameters.value, 1, "Thickness/Value");
      return [by_material, expression](const double *position, const unsigned int material_id) {
        const auto found = by_material.find(material_id);
        return found != by_material.end() ? found->second : expression->value(position, 0.);
      };
    }

    ShellSection make_section(const BladeParameters &parameters)
    {
      ShellSection section;
      section.formulation           = shell_formulations().at(parameters.element.formulation);
      section.rule                  = thickness_rules().at(parameters.element.rule);
      section.n_points              = parameters.element.n_points;
      section.material              = parameters.material.metal();
      section.hourglass_coefficient = parameters.element.hourglass;
      section.shear_factor          = parameters.element.shear_factor;
      section.has_thinning          = parameters.element.has_thinning;
      return section;
    }

    ShellMesh &with_dofs(ShellMesh &mesh)
    {
      mesh.distribute_dofs();
      return mesh;
    }

    std::vector<Point3> points_of(const SurfaceMesh &mesh)
    {
      std::vector<Point3> points;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        points.push_back(mesh.node(n));
      return points;
    }
  } // namespace

  ShellBlade::State::State(const BladeParameters &parameters, ThreadPool &pool)
    : pool(pool)
    , mesh(parameters.mesh, parameters.is_halved)
    , supports(parameters.supports, with_dofs(mesh).surface())
    , loads(parameters.loads, mesh.surface())
    , lumped(mesh.compute_mass(parameters.material.metal().density, make_thickness(parameters.thickness)))
    , elements(points_of(mesh.surface()), mesh.surface().cells, lumped.element_thickness, make_section(parameters),
               pool)
    , root(mesh.surface(), supports.root_ids)
    , tip(mesh.surface(), supports.tip_ids)
    , n_nodes(mesh.surface().nodes.size())
    , damping(parameters.loads.damping)
    , partial((n_nodes + chunk - 1) / chunk)
  {
    elements.use_nodal_masses(lumped.node);
    if (parameters.is_halved)
      elements.add_symmetry_plane(mesh.surface().symmetry_nodes, Point3::UnitY());
    initialize_nodes();
    initialize_velocity(parameters.loads);
    initialize_facets();
    update_loads();
    for (const auto &[name, where] : parse_pairs(parameters.probes, "Probes"))
      {
        const auto x = parse_numbers(where, 3, "Probes");
        watched.emplace_back(name, mesh.surface().nearest_node(Point3(x[0], x[1], x[2])));
      }
  }

  void ShellBlade::State::initialize_nodes()
  {
    n_padded = (6 * n_nodes + block - 1) / block * block;
    for (auto *vector : {&displacement, &velocity, &force, &mass, &inverse_mass, &increment, &contact, &external})
      vector->assign(n_padded, 0.);
    reference.resize(3 * n_nodes);
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        for (unsigned int d = 0; d < 3; ++d)
          reference[3 * n + d] = mesh.surface().nodes[n][d];
        for (unsigned int c = 0; c < 6; ++c)
          {
            mass[6 * n + c]         = c < 3 ? lumped.node[n] : lumped.rotary[n];
            inverse_mass[6 * n + c] = 1. / mass[6 * n + c];
          }
      }
    position = reference;
    for (const std::uint32_t dof : supports.held_dofs)
      inverse_mass[dof] = 0.;
  }

  void ShellBlade::State::initialize_velocity(const BladeParameters::Loads &parameters)
  {
    const double origin[3] = {0., 0., 0.};
    Point3       spin      = Point3::Zero();
    if (is_present(parameters.initial_spin))
      {
        const Expression expression(parameters.initial_spin, 3, "Loads/Initial spin");
        for (unsigned int d = 0; d < 3; ++d)
          spin[d] = expression.value(origin, 0., d);
      }
    std::vector<Expression> field;
    if (is_present(parameters.initial_velocity))
      field.emplace_back(parameters.initial_velocity, 3, "Loads/Initial velocity");
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        const Point3 turning = spin.cross(mesh.surface().node(n));
        for (unsigned int d = 0; d < 3; ++d)
          {
            velocity[6 * n + d]     = turning[d];
            velocity[6 * n + 3 + d] = spin[d];
            for (const auto &expression : field)
              velocity[6 * n + d] += expression.value(&reference[3 * n], 0., d);
          }
      }
    for (const std::uint32_t dof : supports.held_dofs)
      velocity[dof] = 0.;
  }

  void ShellBlade::State::initialize_facets()
  {
    for (const double t : lumped.element_thickness)
      half_thickness.push_back(0.5 * t);
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        bool is_held = true;
        for (unsigned int d = 0; d < 3; ++d)
          is_held = is_held && inverse_mass[6 * n + d] == 0.;
        node_inverse_mass.push_back(is_held ? 0. : 1. / lumped.node[n]);
      }
  }

  void ShellBlade::State::update_loads()
  {
    if (!loads.is_active())
      return;
    std::fill(external.begin(), external.end(), 0.);
    loads.add_forces(time, position.data(), external.data());
  }
} // namespace birdstrike
