#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/log.h>
#include <birdstrike/core/simd/larger.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>

#include <spdlog/logger.h>

#include <algorithm>
#include <cmath>

/// The next step of a scene: who takes part in it, and how long it is.
namespace birdstrike
{
  namespace
  {
    /// Largest growth of the bird's step from one macro step to the next.
    constexpr double step_growth = 1.02;

    /// Of several contacts on the same nodes: squared frequencies add up.
    struct CommonLimit
    {
      double       smallest = INFINITY; ///< s
      double       squares  = 0.;       ///< 1/s^2
      unsigned int n        = 0;

      void add(const double step)
      {
        if (std::isinf(step))
          return;
        smallest = smaller(smallest, step);
        squares += 1. / (step * step);
        ++n;
      }
      double step() const
      {
        return n > 1 ? 1. / std::sqrt(squares) : smallest;
      }
    };
  } // namespace

  void Scene::limit_multirate()
  {
    if (!blade->is_deformable() || !parameters.time.multirate)
      return;
    bool is_softened = false;
    for (Projectile &each : birds)
      {
        each.largest_blade_step = each.contact->node_step_limit(each.bird->points(), blade->facets());
        is_softened             = is_softened || each.is_contact_softened();
      }
    if (is_softened)
      log().info("Multirate: the blade is so light that contact is softened for the step of the bird. While there is a "
                 "bird, the blade's own step is not longer.");
    else if (const double own = parameters.time.step_scale * blade->largest_stable_step(),
             in_contact       = limit_of_layers([](const Projectile &) { return true; });
             in_contact < own)
      log().info("Multirate: the blade is light against a layer of particles, so contact limits its step to {:.3g} s "
                 "(its own limit is {:.3g} s) while there is a bird.",
                 in_contact, own);
  }

  /// Layers of several birds may lie on the same nodes: their stiffnesses add up.
  template <class Predicate>
  double Scene::limit_of_layers(const Predicate &counts) const
  {
    CommonLimit limit;
    for (const Projectile &each : birds)
      if (counts(each))
        limit.add(each.largest_blade_step);
    return limit.step();
  }

  double Scene::limit_in_contact(const double bird_step) const
  {
    const auto is_here = [](const Projectile &each) { return each.is_here() && each.contact; };
    // where contact is softened for the bird's step, a longer one of the blade makes energy (foil of 1/400 of a
    // particle, 1.8 steps of the bird in one: 4 %)
    for (const Projectile &each : birds)
      if (is_here(each) && each.is_contact_softened())
        return bird_step;
    return limit_of_layers(is_here);
  }

  /// Of the birds that are computed now, which take one step.
  std::optional<StepVote> Scene::vote_of_birds(const double remaining)
  {
    std::optional<StepVote> vote;
    StepLimit               in_touch;
    CommonLimit             of_touches;
    for (Projectile &each : birds)
      {
        if (!each.is_here())
          continue;
        // contact is a few per cent of it, as many as the search has listed: in that the axes have a part
        StepVote own{each.bird->step_limit(), each.bird->step_price()};
        own.limit.value *= parameters.time.bird_step_scale;
        const StepLimit touches = each.contact ? each.contact->step_limit() : StepLimit();
        of_touches.add(touches.value);
        if (goes_before(touches.value, in_touch.value))
          in_touch = touches;
        if (goes_before(touches.value, own.limit.value))
          own.limit = touches;
        each.smallest_step.check(own.limit, remaining,
                                 "Reduce Bird/Courant number or Time/Bird step scale, and check the last fields.");
        if (vote)
          own.price += vote->price;
        if (!vote || goes_before(own.limit.value, vote->limit.value))
          vote = own;
        vote->price = own.price;
      }
    if (!vote && !(blade && blade->is_deformable())) // all wait: nothing else has a step
      for (const Projectile &each : birds)
        if (each.waits())
          if (const double step = each.bird->shocked_step(each.first_touch.closing_speed);
              !vote || step < vote->limit.value)
            vote = StepVote{{step, "birds that wait", {}}, 1.};
    in_touch.value = of_touches.step();
    if (vote && goes_before(in_touch.value, vote->limit.value))
      vote->limit = in_touch;
    return vote;
  }

  Schedule Scene::plan(const double remaining)
  {
    std::optional<StepVote> bird_vote = vote_of_birds(remaining), blade_vote;
    if (bird_vote && largest_bird_step < bird_vote->limit.value)
      bird_vote->limit = {largest_bird_step, "bird, smooth growth of the step", {}};
    if (blade && blade->is_deformable())
      {
        blade_vote = StepVote{blade->step_limit(), blade->prices().of_step};
        blade_vote->limit.value *= parameters.time.step_scale;
        smallest_blade_step.check(blade_vote->limit, remaining, advice_on_crushed_elements);
        if (const double in_contact = bird_vote ? limit_in_contact(bird_vote->limit.value) : INFINITY;
            in_contact < blade_vote->limit.value)
          blade_vote->limit = {in_contact, "contact, particles on light facets", {}};
      }
    latest = plan_step(bird_vote, blade_vote, parameters.time.multirate ? parameters.time.maximum_ratio : 1, remaining);
    if (bird_vote && has_contact())
      largest_bird_step = step_growth * latest.bird_step();
    return latest;
  }

  unsigned int Scene::divide_blade_steps(const double step, const unsigned int n_steps)
  {
    if (step <= blade->largest_stable_step())
      return n_steps;
    StepLimit limit = blade->step_limit();
    limit.value *= parameters.time.step_scale;
    smallest_blade_step.check(limit, n_steps * step, advice_on_crushed_elements);
    return static_cast<unsigned int>(std::ceil(n_steps * step / limit.value));
  }

  const Schedule &Scene::last_plan() const
  {
    return latest;
  }

  void Scene::wake_birds(const double now)
  {
    const auto waits = [](const Projectile &each) { return each.waits(); };
    if (std::ranges::none_of(birds, waits))
      return;
    const FacetsView facets = blade->facets();
    for (Projectile &each : birds)
      if (each.waits() && each.wake(facets, latest.step, now))
        largest_bird_step = std::min(largest_bird_step, each.bird->shocked_step(each.first_touch.closing_speed));
  }
} // namespace birdstrike
