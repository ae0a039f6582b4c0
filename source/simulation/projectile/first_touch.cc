#include "simulation/projectile/first_touch.h"
#include "simulation/projectile/moved_views.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/flight.h>
#include <birdstrike/contact/mass_in_the_way.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/blade.h>
#include <birdstrike/structure/rotor.h>

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

namespace birdstrike
{
  namespace
  {
    void move(Bird &bird, const BirdParameters &parameters, const Point3 &way)
    {
      bird.advance_in_flight(1., Point3(parameters.velocity.data()) - way);
    }

    /// Puts a bird, which stands off along its own velocity, where it flies through the aim point as the blade sees it
    /// come: back by the way that the blade has still to go.
    void aim_in_fixed_axes(Bird &bird, const BirdParameters &parameters, const Point3 &aim, const Point3 &frame)
    {
      const Point3 way = aim - Point3(parameters.target().data());
      move(bird, parameters, way);
      if (Point3(parameters.velocity.data()).norm() == 0.)
        throw InputError(parameters.section +
                         "/Velocity: a bird at rest has no path that could be aimed.\nGive it the speed of the "
                         "aircraft, in m/s.");
      const Point3 velocity(parameters.velocity.data()), to_aim = aim - (bird.packing().centre + way);
      const double time = to_aim.dot(velocity) / velocity.squaredNorm();
      bird.advance_in_flight(time, velocity - frame); // by time times `frame`
    }

    /// How long (s) before the present place of the points, which fly on with `velocity`, the first of them touched;
    /// 0 if none has. They are followed from where all of them were behind the whole surface.
    double find_earlier_touch(const PointsView &points, const FacetsView &facets, const Point3 &velocity)
    {
      const Point3 along = velocity.normalized();
      double       front = -INFINITY, rear = INFINITY, margin = points.spacing;
      for (std::size_t p = 0; p < points.n; ++p)
        front = std::max(front, along.dot(Point3(points.position[0][p], points.position[1][p], points.position[2][p])));
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          margin = std::max(margin, 2. * facets.half_thickness[f]);
          for (const std::uint32_t n : facets.nodes[f])
            rear = std::min(rear, along.dot(Point3(facets.position + 3 * n)));
        }
      const double behind = front - rear + 2. * margin; // m, how far to go back
      if (!(behind > 0.))
        return 0.;
      const double      time = behind / velocity.norm();
      const MovedPoints moved(points, -time * velocity, velocity);
      return std::max(0., time - time_to_first_touch(moved.view, facets));
    }

    /// To the first touch of this surface, part of which moves with the velocity `frame`.
    FirstTouch fly_to(Bird &bird, const FacetsView &facets, const BirdParameters &parameters, const Point3 &frame)
    {
      const Point3 velocity = Point3(parameters.velocity.data()) - frame;
      FirstTouch   touch{0., velocity.norm(), {{velocity[0], velocity[1], velocity[2]}}};
      const double before           = clearance * parameters.spacing / touch.closing_speed; // s
      const bool   is_free_to_start = parameters.stand_off == 0. && parameters.shape != BirdShape::slab;
      if (is_free_to_start)
        if (const double earlier = find_earlier_touch(bird.points(), facets, velocity); earlier > 0.)
          {
            bird.advance_in_flight(-earlier - before, frame);
            return touch;
          }
      if (const Overlap overlap = initial_overlap(bird.points(), facets); overlap.depth > 0.)
        refuse_overlap(overlap, parameters);
      touch.flight_time = time_to_first_touch(MovedPoints(bird.points(), Point3::Zero(), velocity).view, facets);
      if (!std::isfinite(touch.flight_time))
        refuse_miss(facets, parameters);
      touch.flight_time = std::max(0., touch.flight_time - before);
      bird.advance_in_flight(touch.flight_time, frame);
      return touch;
    }
  } // namespace

  FirstTouch place_at_first_touch(Bird &bird, Blade &blade, const BirdParameters &parameters)
  {
    const FacetsView      at_start = blade.facets();
    const Rotor *const    rotor    = blade.rotor();
    Point3                aim(parameters.target().data());
    std::array<double, 3> moved_by{};
    if (parameters.aimed_place)
      {
        const SurfaceMotion motion = blade.motion_of(Point3(parameters.aimed_place->data()));
        const Point3        shift  = aim - Point3(parameters.aim_point.data()); // along the chord, which turns
        const Point3        way    = motion.displacement + (motion.rotation * shift - shift);
        moved_by                   = {{way[0], way[1], way[2]}};
        aim += way;
      }
    std::optional<TurnedSurface> turned;
    if (rotor != nullptr && parameters.arrival > 0.)
      {
        turned.emplace(at_start, *rotor, parameters.arrival);
        aim = rotor->turn(parameters.arrival).carried(aim);
      }
    const FacetsView &facets = turned ? turned->view : at_start;
    // of a blade that turns, of the aim point itself: no mesh has a part in it, nor which face of a blade is nearer
    const Point3 frame =
      rotor != nullptr ? rotor->motion(parameters.arrival).velocity(aim) : find_velocity_at_aim(aim, facets);
    if (Point3(parameters.velocity.data()) == frame)
      throw InputError(fmt::format("The bird does not close in on the blade: {0}/Velocity is that of the blade where "
                                   "it aims.\nSet {0}/Velocity, in m/s, towards the blade.",
                                   parameters.section));
    if (rotor != nullptr)
      aim_in_fixed_axes(bird, parameters, aim, frame);
    FirstTouch touch       = fly_to(bird, facets, parameters, frame);
    touch.moved_by         = moved_by;
    touch.share_in_the_way = compute_share_in_the_way(bird.points(), facets, Point3(touch.closing_velocity.data()));
    if (parameters.arrival == 0.)
      return touch;
    bird.advance_in_flight(-parameters.arrival, rotor != nullptr ? Point3(Point3::Zero()) : frame);
    if (const Overlap overlap = initial_overlap(bird.points(), at_start); overlap.depth > 0.)
      refuse_overlap(overlap, parameters);
    return touch;
  }
} // namespace birdstrike
