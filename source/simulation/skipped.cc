#include "simulation/bird_strike.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/contact.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/text.h>
#include <birdstrike/structure/blade.h>

#include <algorithm>
#include <cmath>

/// What a run did not compute, and what that saved, counted in the entities that it does compute. Every saving is units
/// skipped times the measured time of one such unit in this run, over the run time plus that saving:  p = s / (run time
/// + s).
namespace birdstrike
{
  namespace
  {
    double ratio(const double a, const double b)
    {
      return b > 0. ? a / b : 0.;
    }
  } // namespace

  double BirdStrike::n_elements() const
  {
    return scene.blade ? static_cast<double>(scene.blade->prices().n_elements) : 0.;
  }

  BirdStrike::UnitCosts BirdStrike::compute_unit_costs() const
  {
    const Stepper::Counts &counts = stepper.counts();
    UnitCosts              costs;
    const Stepper::Seconds seconds = stepper.seconds();
    costs.particle_step            = ratio(seconds.bird, static_cast<double>(counts.particle_steps));
    costs.element_step             = ratio(seconds.blade, n_elements() * static_cast<double>(counts.blade));
    const ContactReport &report    = scene.contact_report();
    costs.contact_step             = ratio(seconds.contact, static_cast<double>(report.calls - report.skipped));
    return costs;
  }

  double BirdStrike::estimate_seconds_per_time() const
  {
    const UnitCosts costs   = compute_unit_costs();
    double          seconds = 0.;
    if (const std::size_t n = scene.n_particles_here(); n > 0)
      seconds += (costs.particle_step * static_cast<double>(n) + (scene.has_contact() ? costs.contact_step : 0.)) *
                 ratio(static_cast<double>(stepper.counts().bird), now);
    if (scene.blade)
      seconds += costs.element_step * n_elements() * ratio(static_cast<double>(stepper.counts().blade), now);
    return seconds;
  }

  std::vector<SkippedWork> BirdStrike::compute_skipped() const
  {
    const Stepper::Counts   &counts  = stepper.counts();
    const UnitCosts          costs   = compute_unit_costs();
    const double             n_cells = n_elements();
    std::vector<SkippedWork> skipped;
    const auto               add = [&](const char *what, const double count, const char *unit, const double seconds) {
      if (count > 0.)
        skipped.push_back({what, count, unit, ratio(seconds, timings.wall() + seconds)});
    };
    double        n = 0., dropped = 0., bird_time = now;
    unsigned long n_steps_with_bird = n_steps;
    for (const Projectile &each : scene.birds)
      {
        n += static_cast<double>(each.n_at_start);
        dropped += static_cast<double>(each.n_dropped);
      }
    if (!scene.has_bird())
      {
        bird_time         = 0.;
        n_steps_with_bird = 0;
        for (const Projectile &each : scene.birds)
          {
            bird_time         = std::max(bird_time, each.time_gone);
            n_steps_with_bird = std::max(n_steps_with_bird, each.n_steps_with);
          }
      }
    add("flight before first touch", scene.flight_time(), "s",
        scene.flight_time() * (n * costs.particle_step * ratio(static_cast<double>(counts.bird), bird_time) +
                               n_cells * costs.element_step * ratio(static_cast<double>(counts.blade), now)));

    const ContactReport &report  = scene.contact_report();
    const double         apart   = static_cast<double>(report.skipped);
    const double         without = static_cast<double>(n_steps - n_steps_with_bird);
    const double         waited  = static_cast<double>(counts.particle_steps_waited);
    const double retired = n * static_cast<double>(counts.bird) - static_cast<double>(counts.particle_steps) - waited +
                           (n - dropped) * without;
    add("birds that wait", waited, "particle-steps", waited * costs.particle_step);
    add("contact steps with boxes apart", apart, "steps", apart * costs.contact_step);
    add("removed particles", retired, "particle-steps", retired * costs.particle_step);
    if (!scene.birds.empty())
      add("bird and contact after the bird's phase", without, "steps",
          without * (dropped * costs.particle_step + costs.contact_step));
    const double not_done = n_cells * static_cast<double>(counts.blade_not_done);
    add("blade steps by multirate", not_done, "element-steps", not_done * costs.element_step);
    add("bird steps by multirate", static_cast<double>(counts.particle_steps_not_done), "particle-steps",
        static_cast<double>(counts.particle_steps_not_done) * costs.particle_step);
    if (scene.blade && scene.blade->is_deformable())
      {
        // the number at the end: points are never given back, so that more elements went without before
        const ElementPrices prices = scene.blade->prices();
        add("points of elements that never yielded", static_cast<double>(prices.n_elements - prices.n_with_points),
            "elements", prices.of_points_spared / prices.of_step * stepper.seconds().blade);
      }
    if (why_ended == EndReason::tip_peak)
      add("time after the tip's peak", parameters.time.end_time - now, "s",
          (parameters.time.end_time - now) * estimate_seconds_per_time());
    if (parameters.has_symmetry_plane) // the other half: as much again
      add("the mirrored half", 2., "times less work",
          costs.particle_step * static_cast<double>(counts.particle_steps) +
            costs.element_step * n_cells * static_cast<double>(counts.blade) + stepper.seconds().contact);
    add_parts_never_built(skipped);
    return skipped;
  }

  void BirdStrike::add_parts_never_built(std::vector<SkippedWork> &skipped) const
  {
    const auto add = [&](const char *what) { skipped.push_back({what, 1., "part never built", NAN}); };
    if (!scene.blade)
      add("blade");
    else if (!scene.blade->is_deformable())
      add("finite elements of the rigid target");
    if (scene.birds.empty())
      add("bird");
    if (!has_contact)
      add("contact");
  }
} // namespace birdstrike
