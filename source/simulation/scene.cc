#include "simulation/scene.h"
#include "simulation/bird_phase.h"
#include "simulation/first_touch.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/contact/self_contact.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/patch_forces.h>
#include <birdstrike/structure/make_blade.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Places on the arc of a node that turns with its hub, from now to the horizon of removal: between them it leaves
    /// their box by 1/500 of the radius at most (2 ms at 600 rad/s), less than particles lie beyond a box.
    constexpr unsigned int n_on_arc = 10;

    /// Largest growth of the bird's step from one macro step to the next.
    constexpr double step_growth = 1.02;

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
        return "Set Smallest step (0.1, say) of the material that fails to take such elements away.";
      if (can_fail)
        return "Look at the last fields; Smallest step of the material that fails takes elements away earlier.";
      return "An element is crushed, or the mesh has one that is far too small. A metal that fails "
             "(Blade/Material/Failure; Blade/Element/Formulation other than solid-shell) lets it go at "
             "Blade/Material/Smallest step; else change loads or mesh.";
    }
  } // namespace

  Scene::Scene(const CaseParameters &parameters)
    : pool(parameters.time.n_threads())
    , parameters(parameters)
    , largest_bird_step(INFINITY)
    , smallest_bird_step("bird", parameters.time.smallest_step)
    , smallest_blade_step("blade", parameters.time.smallest_step)
    , advice_on_crushed_elements(advise_on_crushed_elements(parameters.blade))
  {
    blade = make_blade(parameters.blade, pool);
    if (parameters.bird.enabled)
      bird = std::make_unique<Bird>(parameters.bird, parameters.equation_of_state, pool);
    if (!blade && !bird)
      throw InputError(
        "The case has neither a blade nor a bird.\nSet Blade/Kind to shell, solid or rigid, or Bird/Enabled to true.");
    if (blade)
      histories = blade->make_histories(parameters.output.histories);
    if (blade && blade->is_deformable() && parameters.contact.self_contact)
      self_contact = std::make_unique<SelfContact>();
    if (blade && bird && parameters.contact.is_enabled)
      {
        contact     = std::make_unique<Contact>(parameters.contact);
        first_touch = place_at_first_touch(*bird, *blade, parameters.bird);
        bird->set_closing_speed(first_touch.closing_speed);
        if (blade->rotor() != nullptr)
          seen_from_hub = bird->energies().kinetic * std::pow(first_touch.closing_speed, 2) /
                          std::max(1e-300, Point3(parameters.bird.velocity.data()).squaredNorm());
        largest_bird_step = bird->shocked_step(first_touch.closing_speed);
        limit_multirate();
      }
    watch_patches();
    if (bird)
      bird->compute_rates(); // where it has been moved to: its vote rests on them
    plan(parameters.time.end_time);
  }

  Scene::~Scene() = default;

  void Scene::watch_patches()
  {
    const HistoryRequests &requests = parameters.output.histories;
    if (!blade && requests.is_any())
      throw InputError(
        "Output/Histories asks for histories of a blade, and the case has none.\nLeave its entries empty, "
        "or set Blade/Kind.");
    if (requests.patches.empty())
      return;
    if (!contact)
      throw InputError("Output/Histories/Patches is set, and nothing can touch the blade.\nLeave it empty, or set "
                       "Bird/Enabled and Contact/Enabled to true.");
    auto table = std::make_unique<PatchForces>(requests.patches, blade->facets());
    patches    = table.get();
    histories.tables.push_back(std::move(table));
  }

  void Scene::limit_multirate()
  {
    if (!blade->is_deformable() || !parameters.time.multirate)
      return;
    const FacetsView facets = blade->facets();
    largest_step_in_contact = contact->node_step_limit(bird->points(), facets);
    if (is_contact_softened())
      log().info(
        "Multirate: the blade is so light that contact is softened for the step of the bird; its own is no longer "
        "while there is a bird.");
    else if (const double own = parameters.time.step_scale * blade->largest_stable_step();
             largest_step_in_contact < own)
      log().info("Multirate: the blade is light against a layer of particles, so contact holds its step to {:.3g} s "
                 "(its own limit is {:.3g} s) while there is a bird.",
                 largest_step_in_contact, own);
  }

  bool Scene::is_contact_softened() const
  {
    return largest_step_in_contact <= bird->strike_step();
  }

  double Scene::limit_in_contact(const double bird_step) const
  {
    // where contact is softened for the bird's step, a longer one of the blade makes energy (foil of 1/400 of a
    // particle, 1.8 steps of the bird in one: 4 %)
    return is_contact_softened() ? bird_step : largest_step_in_contact;
  }

  Schedule Scene::plan(const double remaining)
  {
    std::optional<StepVote> bird_vote, blade_vote;
    if (bird)
      {
        // contact is a few per cent of it, as many as the search has listed: in that the axes have a part
        bird_vote = StepVote{bird->step_limit(), bird->step_price()};
        bird_vote->limit.value *= parameters.time.bird_step_scale;
        if (const StepLimit in_touch = contact ? contact->step_limit() : StepLimit();
            in_touch.value < bird_vote->limit.value)
          bird_vote->limit = in_touch;
        smallest_bird_step.check(bird_vote->limit, remaining,
                                 "Reduce Bird/Courant number or Time/Bird step scale, and look at the last fields.");
        if (largest_bird_step < bird_vote->limit.value)
          bird_vote->limit = {largest_bird_step, "bird, smooth growth of the step", {}};
      }
    if (blade && blade->is_deformable())
      {
        blade_vote = StepVote{blade->step_limit(), blade->prices().of_step};
        blade_vote->limit.value *= parameters.time.step_scale;
        smallest_blade_step.check(blade_vote->limit, remaining, advice_on_crushed_elements);
        if (const double in_contact = contact ? limit_in_contact(bird_vote->limit.value) : INFINITY;
            in_contact < blade_vote->limit.value)
          blade_vote->limit = {in_contact, "contact, particles on light facets", {}};
      }
    latest = plan_step(bird_vote, blade_vote, parameters.time.multirate ? parameters.time.maximum_ratio : 1, remaining);
    if (bird && contact)
      largest_bird_step = step_growth * latest.bird_step();
    return latest;
  }

  const Schedule &Scene::last_plan() const
  {
    return latest;
  }

  SystemState Scene::state() const
  {
    SystemState state;
    state.bird          = bird ? bird->energies() : gone_energy;
    state.bird_momentum = bird ? bird->momenta() : gone_momentum;
    if (blade)
      {
        state.blade          = blade->energies();
        state.seen_from_hub  = seen_from_hub;
        state.blade_momentum = blade->momenta();
      }
    const ContactReport &of_contact = contact ? contact->report() : gone_contact;
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

  std::size_t Scene::retire_particles(const double horizon)
  {
    const FacetsView facets = blade->facets();
    Box              box;
    if (facets.n_facets == 0)
      return 0; // nothing is left to meet: the bird's phase ends by itself
    const Rotor *const rotor = blade->rotor();
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t n : facets.nodes[f]) // nodes without a facet meet nothing
        {
          const Point3 now(facets.position + 3 * n);
          const Point3 velocity(facets.velocity + facets.velocity_stride * n);
          box.add(now.data());
          for (unsigned int k = 1; k <= (rotor != nullptr ? n_on_arc : 1); ++k)
            {
              const double time = horizon * k / (rotor != nullptr ? n_on_arc : 1);
              const Point3 then = rotor != nullptr
                                    ? Point3(rotor->carried(now, time) +
                                             rotor->turned(Point3(time * (velocity - rotor->velocity(now))), time))
                                    : Point3(now + time * velocity);
              box.add(then.data());
            }
        }
    return bird->retire(box);
  }

  double Scene::compute_reachable_impulse(const double horizon)
  {
    return birdstrike::compute_reachable_impulse(bird->points(), blade->facets(), horizon);
  }

  std::uint64_t Scene::n_list_changes() const
  {
    std::uint64_t n = bird ? bird->n_list_builds() : 0;
    if (contact)
      n += contact->report().searches;
    if (self_contact)
      n += self_contact->report().looks;
    if (blade)
      n += blade->prices().n_with_points + blade->failure().n_elements;
    return n;
  }

  void Scene::drop_bird()
  {
    if (contact)
      gone_contact = contact->report();
    gone_energy         = bird->energies();
    gone_momentum       = bird->momenta();
    gone_energy.retired = gone_energy.total();
    gone_energy.retired_made += gone_energy.elastic + gone_energy.dissipated - gone_energy.internal;
    gone_energy.kinetic = gone_energy.staggering = gone_energy.elastic = gone_energy.dissipated = 0.;
    gone_energy.internal                                                                        = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      {
        gone_momentum.retired[d] += gone_momentum.momentum[d];
        gone_momentum.retired_moment[d] += gone_momentum.angular_momentum[d];
      }
    gone_momentum.momentum = gone_momentum.angular_momentum = {};
    contact.reset();
    bird.reset();
  }
} // namespace birdstrike
