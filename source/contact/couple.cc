#include "contact/couple.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace birdstrike
{
  namespace
  {
    constexpr double largest_load = 4.; // on a node, over the force
  }

  Couple::Couple(const FacetsView &facets, const bool has_friction, const TouchRecord &touch)
    : touch(touch), arms(facet_nodes(facets, touch.facet))
  {
    const Point3    mean   = 0.25 * (arms[0] + arms[1] + arms[2] + arms[3]);
    Matrix3<double> moment = Matrix3<double>::Zero();
    for (Point3 &arm : arms)
      {
        arm -= mean;
        moment += arm.squaredNorm() * Matrix3<double>::Identity() - arm * arm.transpose();
      }
    inverse        = moment.inverse();
    double largest = 0.; // force on a node for a unit force along the normal, with friction along any direction
    for (const Point3 &arm : arms)
      largest = std::max(largest, has_friction ? norm_of(arm) : turn(touch.normal.normalized()).cross(arm).norm());
    if (!(largest < std::numeric_limits<double>::infinity())) // a facet without area
      {
        inverse.setZero();
        return;
      }
    const auto &nodes  = facets.nodes[touch.facet];
    const bool is_held = std::all_of(nodes.begin(), nodes.end(), [&](const auto n) { return !facets.inverse_mass[n]; });
    share              = largest > largest_load && !is_held ? largest_load / largest : 1.;
  }

  double Couple::norm_of(const Point3 &arm) const
  {
    double squared = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      squared += turn(Point3::Unit(d)).cross(arm).squaredNorm();
    return std::sqrt(squared);
  }

  Point3 Couple::velocity(const FacetsView &facets) const
  {
    Point3 moment = Point3::Zero();
    for (unsigned int k = 0; k < 4; ++k)
      moment += arms[k].cross(Point3(facets.velocity + facets.nodes[touch.facet][k] * facets.velocity_stride));
    const Point3 turned_by = share * (inverse * moment), spin = turned_by.cross(touch.offset);
    if (!touch.is_edge)
      return spin;
    double turned = turned_by.dot(touch.left_over) * squared_normal(); // m/s, along the normal's gradient
    for (unsigned int k = 0; k < 4; ++k)
      turned += touch.turn_weights[k] *
                touch.turn_normal.dot(Point3(facets.velocity + facets.nodes[touch.facet][k] * facets.velocity_stride));
    return of_couple(spin) + turned / squared_normal() * touch.normal;
  }

  std::array<double, 4> Couple::loads(const Point3 &direction) const
  {
    std::array<double, 4> sizes;
    const Point3          turned = turn(direction);
    for (unsigned int k = 0; k < 4; ++k)
      sizes[k] = force_on(k, direction, turned).norm();
    return sizes;
  }

  Point3 Couple::force_on(const unsigned int k, const Point3 &force, const Point3 &turned) const
  {
    return touch.weights[k] * force + turned.cross(arms[k]) + touch.turn_weights[k] * tilt(force);
  }

  std::array<double, 4> Couple::largest_loads_across(const Point3 &normal) const
  {
    // the force on a node is linear in that on the point: the larger singular value of the map from the plane
    std::array<double, 4> sizes;
    const Point3          one = normal.unitOrthogonal(), other = normal.cross(one);
    const Point3          turned_one = turn(one), turned_other = turn(other);
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Point3 a = force_on(k, one, turned_one), b = force_on(k, other, turned_other);
        const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
        sizes[k] = std::sqrt(0.5 * (aa + bb + std::hypot(aa - bb, 2. * ab)));
      }
    return sizes;
  }
} // namespace birdstrike
