#include "simulation/scene.h"

#include "simulation/projectile/bird_phase.h"
#include "simulation/projectile/first_touch.h"
#include "simulation/projectile/from_position.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/plane_folds.h>
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/patch_forces.h>
#include <birdstrike/report/row_history.h>
#include <birdstrike/structure/make_blade.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Places on the arc of a node that turns with its hub, from now to the horizon of removal: between them it leaves
    /// their box by 1/500 of the radius at most (2 ms at 600 rad/s), less than particles lie beyond a box.
    constexpr unsigned int n_on_arc = 10;

    /// What helps where an element is crushed to nothing.
    const char *advise_on_crushed_elements(const BladeParameters &blade)
    {
      bool can_fail = false, has_no_smallest_step = false;
      for (const auto &[number, of_section] : blade.by_section())
        if (of_section.material_can_fail())
          {
            can_fail = true;
            has_no_smallest_step =
              has_no_smallest_step || (of_section.is_laminate() ? of_section.laminate.smallest_step
                                                                : of_section.material.failure.smallest_step) == 0.;
          }
      if (has_no_smallest_step)
        return "Set Smallest step of the failing material, e.g. to 0.1, to remove such elements.";
      if (can_fail)
        return "Check the last fields. Smallest step of the failing material removes elements earlier.";
      return "An element is crushed, or the mesh has one that is far too small. A metal that fails "
             "(Blade/Material/Failure; Blade/Element/Formulation other than solid-shell) has it removed at "
             "Blade/Material/Smallest step. Otherwise change loads or mesh.";
    }

    /// Unit, as Bird/Yaw means it. Of half a blade x: nothing can turn out of the plane of symmetry.
    std::array<double, 3> span_of(const BladeParameters &parameters, const Blade *const blade)
    {
      if (blade != nullptr && parameters.mesh.generator == MeshGenerator::file && !parameters.is_halved)
        if (const std::optional<Point3> along = blade->span_direction())
          return {{(*along)[0], (*along)[1], (*along)[2]}};
      return {{1., 0., 0.}};
    }
  } // namespace

  Scene::Scene(const CaseParameters &parameters)
    : pool(parameters.time.n_threads())
    , parameters(parameters)
    , largest_bird_step(INFINITY)
    , smallest_blade_step("blade", parameters.time.smallest_step)
    , advice_on_crushed_elements(advise_on_crushed_elements(parameters.blade))
  {
    blade = make_blade(parameters.blade, pool);
    for (const BirdCase &each : parameters.birds())
      birds.emplace_back(each, span_of(parameters.blade, blade.get()), parameters.time, pool);
    if (!blade && birds.empty())
      throw InputError(
        "The case has neither a blade nor a bird.\nSet Blade/Kind to shell, solid or rigid, or Bird/Enabled to true.");
    if (blade)
      histories = blade->make_histories(parameters.output.histories);
    if (blade && !blade->loads_of_row().empty())
      histories.tables.push_back(std::make_unique<RowHistory>(*blade));
    if (blade && blade->is_deformable() && parameters.contact.self_contact)
      self_contact = std::make_unique<SelfContact>();
    place_birds();
    watch_patches();
    for (const Projectile &each : birds)
      each.bird->compute_rates(); // where it has been moved to: its vote rests on them
    if (blade && blade->rotor() != nullptr)
      blade->rotor()->require_known_until(parameters.time.end_time);
    plan(parameters.time.end_time);
    trim_memory(); // building takes more than is kept
  }

  void Scene::place_birds()
  {
    std::size_t n_ids = 0;
    for (Projectile &each : birds)
      {
        each.first_id = n_ids;
        n_ids += each.bird->state().n_ids;
        if (!blade || !parameters.contact.is_enabled)
          {
            move_to_position(*each.bird, each.parameters);
            continue;
          }
        each.place(*blade, parameters.blade, parameters.contact);
        if (blade->rotor() != nullptr)
          seen_from_hub += each.bird->energies().kinetic * std::pow(each.first_touch.closing_speed, 2) /
                           std::max(1e-300, Point3(each.parameters.velocity.data()).squaredNorm());
        if (each.is_here())
          largest_bird_step = std::min(largest_bird_step, each.bird->shocked_step(each.first_touch.closing_speed));
      }
    if (!has_contact())
      return;
    refuse_folds_on_plane(blade->facets());
    require_apart(birds);
    limit_multirate();
  }

  Scene::~Scene() = default;

  void Scene::watch_patches()
  {
    const HistoryRequests &requests = parameters.output.histories;
    if (!blade && requests.is_any())
      throw InputError(
        "Output/Histories asks for histories of a blade, and the case has none.\nLeave its entries empty, "
        "or set Blade/Kind.");
    std::vector<unsigned int> places; // of a row
    if (has_contact() && !blade->blades_of_facets().empty())
      places = parameters.blade.mesh.row.places();
    if (requests.patches.empty() && places.empty())
      return;
    if (!has_contact())
      throw InputError("Output/Histories/Patches is set, but the blade has no contact.\nLeave it empty, or set "
                       "Bird/Enabled and Contact/Enabled to true.");
    auto table = std::make_unique<PatchForces>(requests.patches, blade->facets(), blade->blades_of_facets(), places);
    patches    = table.get();
    histories.tables.push_back(std::move(table));
  }

  SystemState Scene::state() const
  {
    SystemState state;
    for (const Projectile &each : birds)
      {
        add(state.bird, each.energies());
        add(state.bird_momentum, each.momenta());
      }
    if (blade)
      {
        state.blade          = blade->energies();
        state.seen_from_hub  = seen_from_hub;
        state.blade_momentum = blade->momenta();
      }
    const ContactReport &of_contact = contact_report();
    state.contact.elastic           = of_contact.stored_energy;
    state.contact.dissipated        = of_contact.dissipated_energy;
    state.contact.staggering        = of_contact.staggering;
    state.contact_dissipation_fall  = of_contact.dissipation_fall;
    if (self_contact)
      {
        state.self_contact.elastic    = self_contact->report().stored_energy;
        state.self_contact.dissipated = self_contact->report().dissipated_energy;
      }
    return state;
  }

  Box Scene::compute_reach_of_blade(const double now, const double horizon) const
  {
    const FacetsView   facets = blade->facets();
    Box                box;
    const Rotor *const rotor = blade->rotor();
    const HubMotion    hub   = (rotor != nullptr ? *rotor : Rotor()).motion(now);
    std::vector<Turn>  turns; // that the hub will make; none without one
    for (unsigned int k = 1; rotor != nullptr && k <= n_on_arc; ++k)
      turns.push_back(rotor->turn(now, now + horizon * k / n_on_arc));
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t n : facets.nodes[f]) // nodes without a facet meet nothing
        {
          const Point3 x(facets.position + 3 * n), velocity(facets.velocity + facets.velocity_stride * n);
          box.add(x.data());
          if (rotor == nullptr)
            box.add(Point3(x + horizon * velocity).data());
          for (std::size_t k = 0; k < turns.size(); ++k)
            {
              const double time = horizon * (k + 1.) / n_on_arc;
              const Point3 then = turns[k].carried(x) + turns[k](Point3(time * (velocity - hub.velocity(x))));
              box.add(then.data());
            }
        }
    return box;
  }

  std::uint64_t Scene::n_list_changes() const
  {
    std::uint64_t n = 0;
    for (const Projectile &each : birds)
      n += (each.bird ? each.bird->n_list_builds() : 0) + (each.contact ? each.contact->report().searches : 0);
    if (self_contact)
      n += self_contact->report().looks;
    if (blade)
      n += blade->prices().n_with_points + blade->failure().n_elements;
    return n;
  }

  bool Scene::has_bird() const
  {
    return std::ranges::any_of(birds, [](const Projectile &each) { return each.bird != nullptr; });
  }

  bool Scene::has_contact() const
  {
    return std::ranges::any_of(birds, [](const Projectile &each) { return each.contact != nullptr; });
  }

  std::size_t Scene::n_particles_here() const
  {
    std::size_t n = 0;
    for (const Projectile &each : birds)
      n += each.is_here() ? each.bird->state().size() : 0;
    return n;
  }

  double Scene::flight_time() const
  {
    double time = INFINITY;
    for (const Projectile &each : birds)
      time = std::min(time, each.parameters.arrival > 0. ? 0. : each.first_touch.flight_time);
    return std::isfinite(time) ? time : 0.;
  }

  const ContactReport &Scene::contact_report() const
  {
    return birds.size() == 1 ? birds.front().contact_report() : all_contacts;
  }

  void Scene::add_up_contacts()
  {
    if (birds.size() > 1)
      add_up(birds, all_contacts);
  }
} // namespace birdstrike
