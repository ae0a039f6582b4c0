#include "structure/elements/thickness_points.h"
#include <birdstrike/core/errors.h>

#include <deal.II/base/quadrature_lib.h>

namespace birdstrike
{
  ThicknessPoints make_thickness_points(const ThicknessRule rule, const unsigned int n_points)
  {
    if (n_points < 3 || n_points > max_thickness_points || n_points % 2 == 0)
      throw InputError("Points through the thickness of a shell: " + std::to_string(n_points) +
                       " was given; an odd number from 3 to " + std::to_string(max_thickness_points) + " is possible.");
    const dealii::Quadrature<1> line = rule == ThicknessRule::gauss
                                         ? dealii::Quadrature<1>(dealii::QGauss<1>(n_points))
                                         : dealii::Quadrature<1>(dealii::QGaussLobatto<1>(n_points));
    ThicknessPoints             points;
    points.n = n_points;
    // Mirrored, so that a pair of points cancels to the last bit.
    for (unsigned int k = 0; k <= n_points / 2; ++k)
      {
        const unsigned int mirror = n_points - 1 - k;
        points.position[mirror]   = mirror == k ? 0. : 1. - 2. * line.point(k)[0];
        points.position[k]        = -points.position[mirror];
        points.weight[k] = points.weight[mirror] = 2. * line.weight(k);
      }
    return points;
  }
} // namespace birdstrike
