#include "structure/elements/thickness_points.h"
#include <birdstrike/core/errors.h>

namespace birdstrike
{
  ThicknessPoints make_thickness_points(const ThicknessRule rule, const unsigned int n_points)
  {
    // Abramowitz & Stegun (1964), tables 25.4 and 25.6
    struct Half
    {
      std::array<double, 4> position, weight; // from the middle outwards
    };
    static const Half gauss_3{{0., 0.7745966692414834}, {0.8888888888888889, 0.5555555555555556}};
    static const Half gauss_5{{0., 0.5384693101056831, 0.9061798459386640},
                              {0.5688888888888889, 0.4786286704993665, 0.2369268850561891}};
    static const Half gauss_7{{0., 0.4058451513773972, 0.7415311855993945, 0.9491079123427585},
                              {0.4179591836734694, 0.3818300505051189, 0.2797053914892766, 0.1294849661688697}};
    static const Half lobatto_3{{0., 1.}, {4. / 3., 1. / 3.}};
    static const Half lobatto_5{{0., 0.6546536707079772, 1.}, {32. / 45., 49. / 90., 0.1}};
    static const Half lobatto_7{{0., 0.4688487934707142, 0.8302238962785670, 1.},
                                {0.4876190476190476, 0.4317453812098627, 0.2768260473615659, 1. / 21.}};
    if (n_points != 3 && n_points != 5 && n_points != 7)
      throw InputError("Points through the thickness of a shell: " + std::to_string(n_points) +
                       " was given; 3, 5 or 7 are possible.");
    const bool      is_gauss = rule == ThicknessRule::gauss;
    const Half     &half     = n_points == 3   ? (is_gauss ? gauss_3 : lobatto_3)
                               : n_points == 5 ? (is_gauss ? gauss_5 : lobatto_5)
                                               : (is_gauss ? gauss_7 : lobatto_7);
    ThicknessPoints points;
    points.n                  = n_points;
    const unsigned int middle = n_points / 2;
    for (unsigned int k = 0; k <= middle; ++k)
      {
        points.position[middle + k] = half.position[k];
        points.position[middle - k] = -half.position[k];
        points.weight[middle + k] = points.weight[middle - k] = half.weight[k];
      }
    return points;
  }
} // namespace birdstrike
