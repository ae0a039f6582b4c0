#pragma once

#include <birdstrike/bird/bird.h>

#include <functional>

/// What the bird's tests share: small birds and a free step.
namespace birdstrike::test
{
  /// A column of N layers of six by six particles, periodic across, for plane waves along z.
  inline BirdParameters column(const std::size_t n_layers, const double spacing)
  {
    BirdParameters parameters;
    parameters.shape        = BirdShape::slab;
    parameters.slab_lengths = {6. * spacing, 6. * spacing, n_layers * spacing};
    parameters.is_periodic  = {{true, true, false}};
    parameters.spacing      = spacing;
    parameters.velocity     = {0., 0., 0.};
    parameters.aim_point    = {0., 0., 0.};
    return parameters;
  }

  inline void step(Bird &bird, const double dt)
  {
    bird.kick(0.5 * dt, HalfKick::first);
    bird.drift(dt);
    bird.update_neighbor_list();
    bird.compute_rates();
    bird.kick(0.5 * dt, HalfKick::second);
  }

  /// Free motion to t_end at the bird's own step; `observe` is called after each step. Returns the number of steps.
  inline int advance(
    Bird &bird, const double t_end, const std::function<void()> &observe = [] {})
  {
    int n_steps = 0;
    for (double t = 0.; t < t_end * (1. - 1e-12); ++n_steps)
      {
        const double dt = std::min(bird.step_limit().value, t_end - t);
        step(bird, dt);
        t += dt;
        observe();
      }
    return n_steps;
  }

  /// Of 4 mm particles, aimed at the origin.
  inline BirdParameters small_bird()
  {
    BirdParameters parameters;
    parameters.spacing   = 0.004;
    parameters.aim_point = {0., 0., 0.};
    return parameters;
  }
} // namespace birdstrike::test
