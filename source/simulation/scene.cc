#include <birdstrike/bird/bird.h>
#include <birdstrike/blade/make_blade.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/simulation/scene.h>

#include <fmt/format.h>

#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Work of one step of one entity relative to the others (measured ns on one core); only their ratio matters.
    constexpr double particle_cost = 200., element_cost = 150.;
  } // namespace

  Scene::Scene(const CaseParameters &parameters) : pool(parameters.time.n_threads()), parameters(parameters)
  {
    blade = make_blade(parameters.blade, pool);
    if (parameters.bird.enabled)
      bird = std::make_unique<Bird>(parameters.bird, pool);
    if (!blade && !bird)
      throw InputError(
        "The case has neither a blade nor a bird.\nSet Blade/Kind to shell or rigid, or Bird/Enabled to true.");
    if (blade && bird && parameters.contact.enabled)
      {
        contact = std::make_unique<Contact>(parameters.contact);
        place_at_first_touch();
      }
  }

  Scene::~Scene() = default;

  void Scene::place_at_first_touch()
  {
    const auto overlap = contact->initial_overlap(bird->points(), blade->facets());
    if (overlap.n_points > 0)
      throw InputError(fmt::format(
        "{} particles of the bird start inside the blade, the deepest by {:.3g} m at ({:.4g}, {:.4g}, {:.4g}).\n"
        "Move Bird/Aim point or enlarge Bird/Standoff.",
        overlap.n_points, overlap.depth, overlap.position[0], overlap.position[1], overlap.position[2]));
    flight_time = contact->time_to_first_touch(bird->points(), blade->facets());
    if (!std::isfinite(flight_time))
      throw InputError("The bird misses the blade: no particle meets it along Bird/Velocity.\n"
                       "Change Bird/Aim point, Bird/Chordwise offset or Bird/Velocity.");
    bird->advance_in_flight(flight_time);
  }

  Schedule Scene::plan(const double remaining) const
  {
    std::optional<StepVote> bird_vote, blade_vote;
    if (bird)
      {
        bird_vote = StepVote{bird->step_limit(), particle_cost * static_cast<double>(bird->n_particles())};
        bird_vote->limit.value *= parameters.time.bird_step_scale;
      }
    if (blade && blade->is_deformable())
      {
        blade_vote = StepVote{blade->step_limit(), element_cost * static_cast<double>(blade->n_elements())};
        blade_vote->limit.value *= parameters.time.step_scale;
      }
    return plan_step(bird_vote, blade_vote, parameters.time.multirate ? parameters.time.maximum_ratio : 1, remaining);
  }

  SystemState Scene::state() const
  {
    SystemState state;
    state.bird          = bird ? bird->energies() : gone_energy;
    state.bird_momentum = bird ? bird->momenta() : gone_momentum;
    if (blade)
      {
        state.blade          = blade->energies();
        state.blade_momentum = blade->momenta();
      }
    if (contact)
      state.contact_stored = contact->stored_energy();
    return state;
  }

  void Scene::drop_bird()
  {
    gone_energy   = bird->energies();
    gone_momentum = bird->momenta();
    contact.reset();
    bird.reset();
  }
} // namespace birdstrike
