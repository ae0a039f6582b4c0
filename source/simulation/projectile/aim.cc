#include "simulation/projectile/aim.h"
#include "simulation/projectile/projectile.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/bird/shape.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/rotor.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Unit normal of the surface where the bird aims, as spin and steady loads have turned it: of the blade's
    /// mid-surface, or of the facet nearest to that point.
    Point3 find_normal(const BirdParameters &bird, const Blade &blade)
    {
      const Point3 aim(bird.target().data());
      if (bird.aimed_surface)
        return blade.motion_of(aim).rotation * Point3(bird.aimed_surface->normal.data());
      const FacetsView facets  = blade.facets();
      Point3           normal  = Point3::Zero();
      double           nearest = INFINITY;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          std::array<Point3, 4> x;
          for (unsigned int k = 0; k < 4; ++k)
            x[k] = Point3(facets.position + 3 * facets.nodes[f][k]);
          if (const double d = (0.25 * (x[0] + x[1] + x[2] + x[3]) - aim).squaredNorm(); d < nearest)
            {
              nearest = d;
              normal  = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
            }
        }
      return normal;
    }

    /// Of the particles as bodies, m.
    double extent_along(const PointsView &points, const Point3 &direction)
    {
      double low = INFINITY, high = -INFINITY;
      for (std::size_t p = 0; p < points.n; ++p)
        {
          const double x = direction.dot(Point3(points.position[0][p], points.position[1][p], points.position[2][p]));
          low            = std::min(low, x);
          high           = std::max(high, x);
        }
      return high - low + points.spacing;
    }
  } // namespace

  StrikeAim compute_aim(const Projectile &projectile, const Blade &blade)
  {
    StrikeAim             aim;
    const BirdParameters &bird = projectile.parameters;
    const Point3          velocity(projectile.first_touch.closing_velocity.data());
    aim.point = bird.target();
    for (unsigned int d = 0; d < 3; ++d)
      aim.point[d] += projectile.first_touch.moved_by[d];
    aim.velocity              = projectile.first_touch.closing_velocity;
    aim.speed                 = velocity.norm();
    const Rotor *const rotor  = blade.rotor(); // which has turned the surface by then
    const Point3       normal = (rotor != nullptr ? rotor->turn(bird.arrival) : Turn())(find_normal(bird, blade));
    const double       sine   = std::min(1., std::abs(velocity.dot(normal)) / aim.speed);
    aim.normal_speed          = aim.speed * sine;
    aim.angle                 = std::asin(sine) * 180. / M_PI;
    if (const auto &surface = bird.aimed_surface; surface && bird.chordwise_offset == 0.)
      {
        aim.span  = surface->span_share;
        aim.chord = surface->chord_share;
      }
    if (sine > 0.)
      aim.hugoniot_pressure = EquationOfState(projectile.liquid, bird.density).hugoniot(aim.normal_speed).pressure;
    aim.stagnation_pressure = 0.5 * bird.density * aim.speed * aim.speed;
    if (!bird.position.empty())
      {
        std::ranges::copy(bird.position, aim.position.begin());
        aim.arrival = bird.arrival;
      }
    if (bird.shape != BirdShape::slab)
      aim.duration =
        (bird.is_slice() ? extent_along(projectile.bird->points(), velocity.normalized()) : Shape(bird).length()) /
        aim.speed;
    return aim;
  }
} // namespace birdstrike
