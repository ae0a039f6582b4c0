#include "structure/deformable_blade.h"
#include "structure/histories/watched_blade.h"
#include "structure/implicit/modes.h"
#include "structure/implicit/static_solve.h"
#include "structure/surface/surface_motion.h"
#include <birdstrike/core/numerical_failure.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Of the bird relative to the described blade's node nearest to where it aims, at the start.
    template <class Mesh>
    Approach compute_approach(const BladeParameters &parameters, const Mesh &mesh, const NodeArrays &nodes)
    {
      if (!parameters.bird)
        return {};
      const Point3  place(parameters.bird->target.data());
      std::uint32_t nearest  = 0;
      double        smallest = INFINITY;
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        for (const std::uint32_t n : mesh.cells[cell])
          if (mesh.blade_of(cell) == 0)
            if (const double d = (mesh.node(n) - place).squaredNorm(); d < smallest)
              {
                smallest = d;
                nearest  = n;
              }
      return {place, Point3(parameters.bird->velocity.data()) - Point3(nodes.velocity + nodes.n_unknowns * nearest)};
    }

    /// Of a blade whose hub turns at a speed (rad/s) for which no equilibrium was found.
    FailureFacts with_speed(FailureFacts facts, const double speed)
    {
      constexpr double rpm = M_PI / 30.; // rad/s
      facts.quantity       = "Blade/Spin/Speed";
      facts.value          = speed;
      facts.unit           = "rad/s";
      facts.details = fmt::format("That is {0:.5g} rpm; a number without a unit is in rad/s, '{1:.5g} rpm' would be "
                                  "{2:.5g} rad/s.{3}{4}",
                                  speed / rpm, speed, speed * rpm, facts.details.empty() ? "" : "\n", facts.details);
      return facts;
    }
  } // namespace

  template <class Kind>
  DeformableBlade<Kind>::DeformableBlade(const BladeParameters &parameters, ThreadPool &pool)
    : plane(parameters.is_halved)
    , row(parameters.mesh.row.places())
    , mesh(parameters)
    , hub(parameters.spin)
    , supports(parameters.supports, mesh, hub.turns(), parameters.mesh.row.is_rigid())
    , sections(Kind::assign_sections(parameters, mesh))
    , n_layers(Kind::count_layers(mesh, sections))
    , lumped(Kind::compute_mass(mesh, sections, supports))
    , elements(Kind::make_elements(mesh, lumped, sections, pool))
    , pressed(Kind::find_pressed(mesh, parameters.loads))
    , motion(mesh, Kind::masses(lumped), supports, Loads(parameters.loads, mesh, pressed.facets), hub, pool)
    , surface(Kind::make_surface(mesh, lumped))
    , can_fail(parameters.can_fail())
    , implicit(parameters.spin)
  {
    elements.set_owned(mesh.space.n_owned(), mesh.owned_cells());
    elements.use_nodal_masses(lumped.node);
    scaling = Kind::finish(parameters, mesh, lumped, elements, motion);
    if (hub.turns() && parameters.spin.has_prestress)
      find_equilibrium();
    if (hub.turns())
      motion.turn_with_hub();
    else
      motion.initialize_velocity(parameters.loads);
    motion.watch(parameters.probes, mesh);
    probe_warnings = warn_of_far_probes(parameters.probes, mesh);
    stiffness = Kind::stiffness_along(BladeEnd(mesh, SpanEnd::root, supports.root_ids).span, mesh, lumped, elements);
    roles = BladeRoles(mesh, supports.root_ids, supports.tip_ids, compute_approach(parameters, mesh, motion.arrays()),
                       stiffness);
    roles.take_row(parameters.mesh.row);
    root    = typename Kind::Root(mesh, roles.root);
    tip     = TipRow(mesh, roles.tip);
    members = RowOfBlades<Kind>(parameters.mesh.row, mesh, sections, roles, supports.root_ids, supports.tip_ids);
    std::vector<std::uint32_t> reported;
    root.add_nodes(reported);
    tip.add_nodes(reported);
    members.add_nodes(reported);
    motion.report_nodes(std::move(reported));
  }

  template <class Kind>
  StaticReport DeformableBlade<Kind>::find_equilibrium()
  {
    if (prestress.n_unknowns == 0)
      {
        BladeEquilibrium<Kind::n_unknowns> equilibrium(mesh, motion, elements, supports.held_dofs, hub);
        try
          {
            prestress = solve_static(equilibrium, implicit.n_load_steps, implicit.linear_solver);
          }
        catch (const NumericalFailure &failure)
          {
            if (!hub.turns())
              throw;
            throw NumericalFailure(with_speed(failure.facts(), hub.speed(0.)));
          }
        motion.update_loads();
      }
    return prestress;
  }

  template <class Kind>
  VibrationModes DeformableBlade<Kind>::compute_modes(const std::size_t n, const std::size_t n_spare)
  {
    if (row.size() > 1)
      throw InputError("Blade/Mesh/Row/Blades: modes of a row, which come in as many alike, are not computed.\n"
                       "Set it to 1: each blade has the modes of one.");
    BladeEquilibrium<Kind::n_unknowns> equilibrium(mesh, motion, elements, supports.held_dofs, hub);
    const std::size_t                  most = equilibrium.unknowns().size() / 3; // refused beyond
    return birdstrike::compute_modes(equilibrium, std::max(n, std::min(n + n_spare, most > 0 ? most - 1 : 0)),
                                     implicit.linear_solver);
  }

  template <class Kind>
  void DeformableBlade<Kind>::compute_internal_forces()
  {
    motion.compute_internal_forces(elements);
    if (elements.n_failed() != n_failed)
      update_failed();
  }

  template <class Kind>
  void DeformableBlade<Kind>::update_failed()
  {
    n_failed = elements.n_failed();
    surface.remove([this](const std::size_t element) { return elements.is_failed(element); });
    for (std::size_t k = 0; k < pressed.elements.size(); ++k)
      if (elements.is_failed(pressed.elements[k]))
        motion.stop_pressing(k);
  }

  template <class Kind>
  void DeformableBlade<Kind>::archive(Archive &archive)
  {
    const auto group = archive.group("blade");
    motion.archive(archive);
    elements.archive(archive, motion.positions());
    if (archive.is_reading() && elements.n_failed() > 0)
      update_failed();
    surface.archive(archive);
  }

  template <class Kind>
  FacetsView DeformableBlade<Kind>::facets() const
  {
    FacetsView view = motion.facets();
    view.n_nodes    = Kind::n_nodes_in_contact(mesh, can_fail);
    view.plane      = plane;
    surface.offer(view);
    return view;
  }

  template <class Kind>
  SurfaceMotion DeformableBlade<Kind>::motion_of(const Point3 &place) const
  {
    return compute_surface_motion(
      facets(), place, [&](const std::uint32_t n) -> Point3 { return mesh.node(n); },
      [&](const std::uint32_t n) { return Point3(motion.displacements() + Kind::n_unknowns * n); });
  }

  template class DeformableBlade<ShellKind>;
  template class DeformableBlade<SolidKind>;
} // namespace birdstrike
