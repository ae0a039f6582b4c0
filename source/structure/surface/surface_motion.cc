#include "structure/surface/surface_motion.h"
#include <birdstrike/core/closest_point.h>

#include <cmath>
#include <optional>

namespace birdstrike
{
  namespace
  {
    constexpr double farthest = 4.; ///< times as far as the nearest face, that the opposite one counts

    /// Right-handed and orthonormal, columns: the first halves the angle between the facet's axes, so that a shear does
    /// not turn it; the last is the normal.
    Matrix3<double> frame_of(const std::array<Point3, 4> &x)
    {
      const Point3    one = (x[1] + x[2] - x[0] - x[3]).normalized(), other = (x[2] + x[3] - x[0] - x[1]).normalized();
      Matrix3<double> frame;
      frame.col(2) = one.cross(other).normalized();
      frame.col(0) = (one + other).normalized();
      frame.col(1) = frame.col(2).cross(frame.col(0));
      return frame;
    }

    struct Nearest
    {
      const std::array<std::uint32_t, 4> *nodes;
      ClosestPoint<double>                closest;
    };
  } // namespace

  SurfaceMotion compute_surface_motion(const FacetsView &facets, const Point3 &place,
                                       const FunctionRef<Point3(std::uint32_t)> rest,
                                       const FunctionRef<Point3(std::uint32_t)> displacement)
  {
    const auto at_rest = [&](const std::array<std::uint32_t, 4> &nodes) {
      return std::array<Point3, 4>{rest(nodes[0]), rest(nodes[1]), rest(nodes[2]), rest(nodes[3])};
    };
    const auto find_nearest = [&](const auto &is_offered) { // the first of equals
      std::optional<Nearest> nearest;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        if (const auto closest = compute_closest_point(place, at_rest(facets.nodes[f]));
            is_offered(closest) && (!nearest || closest.distance_squared < nearest->closest.distance_squared))
          nearest = Nearest{&facets.nodes[f], closest};
      return nearest;
    };
    const auto interpolate = [&](const Nearest &at) {
      Point3 sum = Point3::Zero();
      for (unsigned int k = 0; k < 4; ++k)
        sum += at.closest.weights[k] * displacement((*at.nodes)[k]);
      return sum;
    };
    const std::optional<Nearest> one = find_nearest([](const auto &) { return true; });
    if (!one)
      return {};
    SurfaceMotion result;
    result.displacement = interpolate(*one);
    if (!facets.two_sided)
      {
        const double depth         = std::sqrt(one->closest.distance_squared);
        const auto   is_other_side = [&](const auto &closest) {
          const double distance = std::sqrt(closest.distance_squared);
          return distance < farthest * depth && closest.offset.dot(one->closest.offset) < -0.5 * distance * depth;
        };
        if (const auto other = find_nearest(is_other_side))
          {
            const double share  = depth / (depth + std::sqrt(other->closest.distance_squared));
            result.displacement = (1. - share) * result.displacement + share * interpolate(*other);
          }
      }

    std::array<Point3, 4> x         = at_rest(*one->nodes);
    const Matrix3<double> before    = frame_of(x);
    bool                  has_moved = false;
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Point3 moved = displacement((*one->nodes)[k]);
        has_moved          = has_moved || moved.squaredNorm() > 0.;
        x[k] += moved;
      }
    if (has_moved) // else exactly as it was
      result.rotation = frame_of(x) * before.transpose();
    return result;
  }
} // namespace birdstrike
