#include "structure/shell_blade_state.h"
#include "structure/probes/strike_side.h"
#include "structure/section_choices.h"

#include <birdstrike/mesh/thickness_law.h>

namespace birdstrike
{
  namespace
  {
    ShellSection make_section(const BladeParameters &parameters)
    {
      ShellSection section;
      section.formulation           = shell_formulations().at(parameters.element.shell_formulation());
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

    std::vector<double> halves(std::vector<double> values)
    {
      for (double &value : values)
        value *= 0.5;
      return values;
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
    : mesh(parameters.mesh, parameters.is_halved)
    , supports(parameters.supports, with_dofs(mesh).surface())
    , lumped(mesh.compute_mass(parameters.material.metal().density, make_thickness_law(parameters)))
    , elements(points_of(mesh.surface()), mesh.surface().cells, lumped.element_thickness, make_section(parameters),
               pool)
    , nodes(mesh.surface().nodes, {lumped.node, lumped.rotary}, supports,
            Loads(parameters.loads, mesh.surface(), mesh.surface().cells, 6), pool)
    , root(mesh.surface(), supports.root_ids)
    , tip(mesh.surface(), supports.tip_ids)
    , surface(mesh.surface(), halves(lumped.element_thickness))
    , can_fail(parameters.material.metal().failure.can_fail())
  {
    elements.use_nodal_masses(lumped.node);
    if (parameters.is_halved)
      elements.add_symmetry_plane(mesh.surface().symmetry_nodes, Point3::UnitY());
    nodes.initialize_velocity(parameters.loads);
    nodes.watch(parameters.probes);
    turn_from_strike(compute_strike(parameters, nodes.momenta(), lumped.total), true, root, tip);
  }

  void ShellBlade::State::update_failed()
  {
    n_failed = elements.n_failed();
    surface.remove([this](const std::size_t element) { return elements.is_failed(element); });
    for (std::size_t element = 0; element < elements.n_elements(); ++element)
      if (elements.is_failed(element))
        nodes.stop_pressing(element);
  }
} // namespace birdstrike
