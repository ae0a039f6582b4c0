#include "simulation/explain.h"
#include "simulation/scene.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/core/machine.h>
#include <birdstrike/core/prices.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/time_control/schedule.h>

#include <algorithm>
#include <cmath>

/// What a run will take, told from its scene.
namespace birdstrike
{
  namespace
  {
    /// Until its particles have spread to spray a bird takes so many times in which it flies its diameter.
    constexpr double times_to_spray = 4.;

    double speed_of(const Projectile &projectile)
    {
      return projectile.contact ? projectile.first_touch.closing_speed
                                : Point3(projectile.parameters.velocity.data()).norm();
    }

    /// Behind the shock, which has passed after a few per cent of the strike: h/(c + 1.2 v) with the sound speed of the
    /// undisturbed liquid.
    double compute_steady_step(const Projectile &projectile, const double step_scale)
    {
      const BirdParameters &bird = projectile.parameters;
      return step_scale * bird.courant_number * bird.smoothing_ratio * projectile.bird->packing().spacing /
             (projectile.bird->points().undeformed_sound_speed + 1.2 * speed_of(projectile));
    }

    /// How long a particle is computed in the mean, s: it arrives, and crosses the blade and the margin around it at
    /// the bird's speed before it is removed.
    double compute_presence(const Projectile &projectile, const Scene &scene, const double end_time)
    {
      const BirdParameters &bird  = projectile.parameters;
      const StrikeAim      &aim   = projectile.aim;
      const double          whole = std::max(end_time - bird.arrival, 0.);
      if (!projectile.contact || !bird.retire || !(aim.speed > 0.) || std::isnan(aim.duration))
        return whole;
      constexpr double margin = 1.25; // diameters, as of removal
      const Box        blade  = scene.compute_reach_of_blade(0., 0.);
      const double     across =
        std::hypot(blade.high[0] - blade.low[0], blade.high[1] - blade.low[1], blade.high[2] - blade.low[2]);
      return std::min(whole, 0.5 * aim.duration + across / aim.speed + margin * projectile.passing_time());
    }

    /// Of the steps of a bird, ns.
    double price_of_bird(const Projectile &projectile, const double presence, const double step, const bool is_sloping)
    {
      const double dense =
        projectile.contact ? std::min(presence, times_to_spray * projectile.passing_time()) : presence;
      const double spray = presence - dense, n = static_cast<double>(projectile.bird->state().size());
      const double of_contact = !projectile.contact ? 0.
                                : is_sloping        ? prices::contact_on_slope
                                                    : prices::contact_particle;
      return (projectile.bird->step_price() * (dense + prices::spray_share * spray) + of_contact * n * presence) / step;
    }

    /// Of a step of the blade in the mean, ns: of a struck one half of the elements yield in half of the time.
    double price_of_blade_step(const CaseParameters &parameters, const Blade &blade)
    {
      const ElementPrices all = blade.prices();
      const double        n   = static_cast<double>(all.n_elements);
      double              ns  = all.of_step + 0.5 * all.of_points_spared + prices::element_motion * n;
      if (parameters.blade.can_fail() && !parameters.blade.is_laminate())
        ns += prices::failing_point * n * (blade.kind() == BladeKind::shell ? parameters.blade.element.n_points : 1.);
      if (parameters.blade.is_laminate())
        ns += prices::ply * n * static_cast<double>(parameters.blade.laminate.layers().size());
      return ns;
    }

    /// Steps of the birds together, and of the blade alone after them.
    struct Steps
    {
      Schedule with_birds, alone;
    };

    Steps plan_steps(const CaseParameters &parameters, const Scene &scene)
    {
      const TimeParameters   &time = parameters.time;
      std::optional<StepVote> birds, blade;
      for (const Projectile &each : scene.birds)
        {
          StepVote own{{compute_steady_step(each, time.bird_step_scale), "bird", {}}, each.bird->step_price()};
          if (birds)
            {
              own.price += birds->price;
              own.limit.value = std::min(own.limit.value, birds->limit.value);
            }
          birds = own;
        }
      if (scene.blade && scene.blade->is_deformable())
        {
          blade = StepVote{scene.blade->step_limit(), scene.blade->prices().of_step};
          blade->limit.value *= time.step_scale;
        }
      const unsigned int most = time.multirate ? time.maximum_ratio : 1;
      if (!birds && !blade)
        return {scene.last_plan(), scene.last_plan()};
      const Schedule together = plan_step(birds, blade, most, time.end_time);
      return {together, blade ? plan_step(std::nullopt, blade, most, time.end_time) : together};
    }
  } // namespace

  double compute_run_time(const CaseParameters &parameters, const Scene &scene)
  {
    const double end_time = parameters.time.end_time;
    const Steps  steps    = plan_steps(parameters, scene);
    double       presence = 0., ns = prices::starting;
    bool         is_sloping = false;
    if (scene.blade && scene.blade->kind() == BladeKind::shell)
      {
        const BladeCensus census = scene.blade->census();
        is_sloping               = census.thickest > (1. + 1e-6) * census.thinnest;
      }
    for (const Projectile &each : scene.birds)
      {
        const double own = compute_presence(each, scene, end_time);
        presence         = std::max(presence, own);
        ns += price_of_bird(each, own, steps.with_birds.bird_step(), is_sloping);
      }
    const double alone = std::max(end_time - presence, 0.), with = end_time - alone;
    if (scene.blade && scene.blade->is_deformable())
      ns += price_of_blade_step(parameters, *scene.blade) *
            (with / steps.with_birds.blade_step() + alone / steps.alone.blade_step());
    ns += prices::step * (with / steps.with_birds.step + alone / steps.alone.step);
    ns += prices::field_byte * compute_field_bytes(parameters, scene);
    return 1e-9 * ns;
  }

  double compute_run_memory(const CaseParameters &parameters, const Scene &scene)
  {
    const HeldMemory held = held_memory();
    if (!(held.now > 0.))
      return 0.;
    double bytes = held.now + prices::running;
    for (const Projectile &each : scene.birds)
      bytes += static_cast<double>(each.bird->state().size()) *
               ((each.contact ? prices::running_particle : 0.) +
                (parameters.output.bird_fields ? prices::field_particle : 0.));
    if (scene.blade && scene.blade->is_deformable())
      bytes += prices::running_element * static_cast<double>(scene.blade->n_elements());
    return std::max(bytes, held.most);
  }
} // namespace birdstrike
