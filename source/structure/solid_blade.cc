#include "structure/nodes/mass_scaling.h"
#include "structure/probes/strike_side.h"
#include "structure/section_choices.h"
#include "structure/solid_blade_state.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>
#include <birdstrike/core/text_lists.h>

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    SolidSection make_section(const BladeParameters &parameters)
    {
      SolidSection section;
      section.formulation         = solid_formulations().at(parameters.solid_formulation());
      section.material            = parameters.material.metal();
      section.rule                = thickness_rules().at(parameters.element.rule);
      section.n_points            = parameters.element.n_points;
      section.linear_viscosity    = parameters.element.linear_viscosity;
      section.quadratic_viscosity = parameters.element.quadratic_viscosity;
      return section;
    }

    SolidMesh &with_dofs(SolidMesh &mesh)
    {
      mesh.distribute_dofs();
      return mesh;
    }

    std::vector<Point3> points_of(const VolumeMesh &mesh)
    {
      std::vector<Point3> points;
      for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        points.push_back(mesh.node(n));
      return points;
    }

    /// The skin facets that pressure acts on, turned so that their normals point inwards, and the cells behind them.
    std::vector<Loads::Quadrilateral> pressed_facets(const VolumeMesh &mesh, const BladeParameters::Loads &parameters,
                                                     std::vector<std::uint32_t> &cells)
    {
      std::vector<Loads::Quadrilateral> pressed;
      if (!is_present(parameters.pressure))
        return pressed;
      const auto ids = parse_ids(parameters.pressure_boundaries, "Loads/Pressure boundaries");
      for (const auto &face : mesh.faces)
        if (std::find(ids.begin(), ids.end(), face.id) != ids.end())
          {
            pressed.push_back({{face.nodes[0], face.nodes[3], face.nodes[2], face.nodes[1]}});
            cells.push_back(face.cell);
          }
      if (pressed.empty())
        throw InputError("Blade/Loads/Pressure boundaries: no face of the mesh has one of the ids '" +
                         parameters.pressure_boundaries + "'.\nPressure on a solid needs faces to act on.");
      return pressed;
    }
  } // namespace

  SolidBlade::State::State(const BladeParameters &parameters, ThreadPool &pool)
    : mesh(parameters)
    , supports(parameters.supports, with_dofs(mesh).volume())
    , lumped(mesh.compute_mass(parameters.material.metal().density))
    , elements(points_of(mesh.volume()), mesh.volume().cells, make_section(parameters), pool)
    , nodes(
        mesh.volume().nodes, {lumped.node, {}}, supports,
        Loads(parameters.loads, mesh.volume().skin, pressed_facets(mesh.volume(), parameters.loads, pressed_cells), 3),
        pool)
    , root(mesh.volume(), supports.root_ids, parameters.material.metal().hardening)
    , tip(make_tip_row(mesh.volume(), supports.tip_ids))
    , skin(mesh.volume())
    , can_fail(parameters.material.metal().failure.can_fail())
  {
    elements.use_nodal_masses(lumped.node);
    if (parameters.mass_scaling.method == "selective")
      scale_masses(parameters);
    nodes.initialize_velocity(parameters.loads);
    nodes.watch(parameters.probes);
    turn_from_strike(compute_strike(parameters, nodes.momenta(), lumped.total), mesh.volume().layers > 0, root, tip);
  }

  void SolidBlade::State::scale_masses(const BladeParameters &parameters)
  {
    const NodeColumns columns(mesh.volume());
    MassScaling       chosen = choose_mass_scaling(parameters, mesh.volume(), columns, elements, lumped.node);
    elements.scale_masses(chosen.scale);
    nodes.scale(columns, std::move(chosen.coupling));
    scaling      = chosen.report;
    scaling.step = elements.largest_stable_step();
  }

  void SolidBlade::State::update_failed()
  {
    n_failed = elements.n_failed();
    skin.remove([this](const std::size_t element) { return elements.is_failed(element); });
    for (std::size_t k = 0; k < pressed_cells.size(); ++k)
      if (elements.is_failed(pressed_cells[k]))
        nodes.stop_pressing(k);
  }

  SolidBlade::SolidBlade(const BladeParameters &parameters, ThreadPool &pool)
    : state(std::make_unique<State>(parameters, pool))
  {
  }

  SolidBlade::~SolidBlade() = default;

  void SolidBlade::kick_internal(const double half_step, const HalfKick half)
  {
    state->nodes.kick_internal(half_step, half);
  }

  void SolidBlade::kick_contact(const double half_step, const HalfKick half)
  {
    state->nodes.kick_contact(half_step, half);
  }

  void SolidBlade::drift(const double step)
  {
    state->nodes.drift(step);
  }

  void SolidBlade::compute_internal_forces()
  {
    state->nodes.compute_internal_forces(state->elements);
    if (state->elements.n_failed() != state->n_failed)
      state->update_failed();
  }

  NodeForces SolidBlade::clear_contact_forces()
  {
    return state->nodes.clear_contact_forces();
  }

  void SolidBlade::set_contact_in_transit(const double duration)
  {
    state->nodes.set_contact_in_transit(duration);
  }

  FacetsView SolidBlade::facets() const
  {
    FacetsView view = state->nodes.facets();
    if (!state->can_fail) // else nodes inside may become the skin's
      view.n_nodes = state->mesh.volume().n_skin_nodes;
    state->skin.offer(view);
    return view;
  }

  void SolidBlade::add_internal_forces(const std::span<const NodalForce> forces)
  {
    state->nodes.add_internal_forces(forces);
  }

  NodeArrays SolidBlade::nodes()
  {
    return state->nodes.arrays();
  }
} // namespace birdstrike
