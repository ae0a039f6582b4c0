#pragma once

#include "simulation/projectile/first_touch.h"

namespace birdstrike
{
  /// Moves the undeformed bird to BirdParameters::position, where there is one.
  void move_to_position(Bird &bird, const BirdParameters &parameters);

  /// Leaves the bird at BirdParameters::position, where its centre is at time 0, and finds when and where it will meet
  /// the blade, which is not deformed until then: into `arrival` and `aim_point` of `parameters`.
  ///
  /// A blade that moves as a whole is met as in its own frame. Of one that turns with its hub the bird is followed
  /// along its straight path in fixed axes, and the blade is turned by as much as it will have been by then: from no
  /// touch to a touch by steps in which no particle passes half a spacing of the surface, then by bisection.
  ///
  /// The aim point is where the path of the centre goes through the surface at the first touch, or comes nearest to it;
  /// of a blade that turns as a place of the blade as it lies at the start.
  ///
  /// @throws InputError for a bird that starts inside the blade or misses it, and for an arrival time or aim point that
  /// are given too and contradict the position.
  FirstTouch place_at_position(Bird &bird, Blade &blade, BirdParameters &parameters);
} // namespace birdstrike
