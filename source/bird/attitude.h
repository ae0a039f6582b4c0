#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// How the bird lies: turned about its axis by roll, then the axis from the velocity by pitch and yaw; the columns
  /// are the images of x, y, z of the bird's frame. Without these angles z is the velocity v, and x, about which it
  /// yaws, what is left of the blade's span s without its part along v; of a bird that flies along the span of y, or of
  /// z where s is y.
  Matrix3<double> compute_attitude(const BirdParameters &parameters);

  /// Frame of a slice's lattice in fixed axes: z the normal of its planes, turned about it by roll; x as near to the x
  /// of the bird without roll as that allows. Of a slice across the bird's own axis that is its attitude.
  Matrix3<double> compute_slice_frame(const BirdParameters &parameters);
} // namespace birdstrike
