#include "contact/touch/thickness_slope.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    constexpr double on_edge       = 1e-12; // weights below are zero
    constexpr double largest_slope = 1.;

    /// Of a quantity that grows by `growth` along `way`.
    Point3 along(const Point3 &way, const double growth)
    {
      const double squared = way.squaredNorm();
      return squared > 0. ? Point3((growth / squared) * way) : Point3(0., 0., 0.);
    }

    /// Of one that grows by u along a, and by v along b.
    Point3 in_plane(const Point3 &a, const double u, const Point3 &b, const double v)
    {
      const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), det = aa * bb - ab * ab;
      return det > 1e-14 * aa * bb ? Point3(((u * bb - v * ab) * a + (v * aa - u * ab) * b) / det) : Point3(0., 0., 0.);
    }
  } // namespace

  Point3 compute_thickness_slope(const std::array<Point3, 4> &x, const std::array<double, 4> &half_thickness,
                                 const std::array<double, 4> &weights)
  {
    // q = c + s (x_k - c) + t (x_l - c): the weights of both other corners are the least, (1 - s - t)/4
    unsigned int k = 0;
    for (unsigned int i = 1; i < 4; ++i)
      if (weights[i] + weights[(i + 1) % 4] > weights[k] + weights[(k + 1) % 4])
        k = i;
    const unsigned int l     = (k + 1) % 4;
    const double       least = *std::min_element(weights.begin(), weights.end());
    const double       s = weights[k] - least, t = weights[l] - least;

    const Point3 centre = 0.25 * (x[0] + x[1] + x[2] + x[3]), a = x[k] - centre, b = x[l] - centre;
    const double mean = 0.25 * (half_thickness[0] + half_thickness[1] + half_thickness[2] + half_thickness[3]);
    const double u = half_thickness[k] - mean, v = half_thickness[l] - mean;
    Point3       slope(0., 0., 0.);
    if (least < on_edge) // of the facet, or in its corner
      slope = s > on_edge && t > on_edge ? along(b - a, v - u) : slope;
    else if (s > on_edge && t > on_edge)
      slope = in_plane(a, u, b, v);
    else if (s > on_edge || t > on_edge)
      slope = s > on_edge ? along(a, u) : along(b, v);
    const double size = slope.norm();
    return size > largest_slope ? Point3((largest_slope / size) * slope) : slope;
  }
} // namespace birdstrike
