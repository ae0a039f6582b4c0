#include "simulation/projectile/from_position.h"
#include "simulation/projectile/moved_views.h"
#include <birdstrike/bird/bird.h>
#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/mass_in_the_way.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/blade.h>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace birdstrike
{
  namespace
  {
    /// When (s) a point of the path x + v t is on the triangle; infinity if never. (Moeller and Trumbore 1997.)
    double time_to_triangle(const Point3 &x, const Point3 &v, const Point3 &a, const Point3 &b, const Point3 &c)
    {
      const Point3 ab = b - a, ac = c - a, across = v.cross(ac), from_a = x - a, other = from_a.cross(ab);
      const double volume = ab.dot(across);
      if (volume == 0.)
        return INFINITY;
      const double     s = from_a.dot(across) / volume, t = v.dot(other) / volume, time = ac.dot(other) / volume;
      constexpr double rim = 1e-9; // between two triangles there is no gap
      return s >= -rim && t >= -rim && s + t <= 1. + rim && time >= 0. ? time : INFINITY;
    }

    /// Where the path through x along v goes through the surface, or is nearest to it.
    Point3 find_crossing(const Point3 &x, const Point3 &v, const FacetsView &facets)
    {
      double first = INFINITY, nearest = INFINITY, beside = 0.;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          const auto nodes = facet_nodes(facets, f);
          first            = std::min({first, time_to_triangle(x, v, nodes[0], nodes[1], nodes[2]),
                                       time_to_triangle(x, v, nodes[0], nodes[2], nodes[3])});
          for (const Point3 &node : nodes)
            {
              const double time = (node - x).dot(v) / v.squaredNorm();
              if (const double distance = (x + time * v - node).squaredNorm(); distance < nearest)
                {
                  nearest = distance;
                  beside  = time;
                }
            }
        }
      return x + (std::isfinite(first) ? first : beside) * v;
    }

    /// What the path of a bird meets, and when.
    struct Meeting
    {
      double time;         ///< s
      Point3 aim, frame;   ///< m, in fixed axes then; m/s, of the surface there
      Point3 aim_at_start; ///< m, the same place of the blade as it lies at the start
    };

    Meeting meet_in_frame(const PointsView &points, const FacetsView &facets, const BirdParameters &parameters)
    {
      const Point3 position(parameters.position.data()), velocity(parameters.velocity.data());
      Point3       aim = position, frame = Point3::Zero();
      for (unsigned int pass = 0; pass < 3; ++pass) // which part of the surface it is says how fast it comes
        {
          aim   = find_crossing(position, velocity - frame, facets);
          frame = find_velocity_at_aim(aim, facets);
          if (velocity == frame)
            throw InputError(parameters.section +
                             "/Velocity is that of the blade: the bird does not close in on it.\nSet it, in m/s, so "
                             "that the bird flies from Position to the blade.");
        }
      const Point3 closing = velocity - frame;
      const double time    = time_to_first_touch(MovedPoints(points, Point3::Zero(), closing).view, facets);
      if (!std::isfinite(time))
        refuse_miss(facets, parameters);
      return {std::max(0., time - clearance * parameters.spacing / closing.norm()), aim, frame, aim};
    }

    Box bounds_of(const PointsView &points)
    {
      Box box;
      for (std::size_t p = 0; p < points.n; ++p)
        box.add(Point3(points.position[0][p], points.position[1][p], points.position[2][p]).data(), points.spacing);
      return box;
    }

    Box bounds_of(const FacetsView &facets)
    {
      Box box;
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        for (const std::uint32_t n : facets.nodes[f])
          box.add(facets.position + 3 * n, facets.half_thickness[f]);
      return box;
    }

    /// Follows a bird through what a blade on a hub sweeps.
    class SweptMeeting
    {
    public:
      SweptMeeting(const PointsView &points, const FacetsView &facets, const Rotor &rotor,
                   const BirdParameters &parameters)
        : points(points)
        , facets(facets)
        , rotor(rotor)
        , parameters(parameters)
        , velocity(parameters.velocity.data())
        , bird(bounds_of(points))
      {
        const HubMotion hub = rotor.motion(0.);
        for (std::size_t f = 0; f < facets.n_facets; ++f)
          for (const std::uint32_t n : facets.nodes[f])
            reach = std::max(reach, (Point3(facets.position + 3 * n) - hub.centre).norm() + facets.half_thickness[f]);
        centre = hub.centre;
      }

      Meeting find() const
      {
        const auto [enters, leaves] = time_within_reach();
        double before               = 0.;
        for (double now = enters; now <= leaves;)
          {
            const double room = step_of_no_touch(now);
            if (room <= 0.)
              return meeting(now == 0. ? 0. : bisect(before, now));
            before = now;
            now += room;
          }
        refuse_miss(facets, parameters);
      }

    private:
      const PointsView     &points;
      const FacetsView     &facets;
      const Rotor          &rotor;
      const BirdParameters &parameters;
      Point3                velocity;
      Box                   bird;
      Point3                centre = Point3::Zero();
      double                reach  = 0.; ///< m, of the blade from the centre

      /// While the sphere around the bird meets the one that holds all that the blade sweeps.
      std::array<double, 2> time_within_reach() const
      {
        const Point3 low(bird.low.data()), high(bird.high.data()), way = 0.5 * (low + high) - centre;
        const double radius = reach + 0.5 * (high - low).norm(), v2 = velocity.squaredNorm(), b = way.dot(velocity),
                     root = b * b - v2 * (way.squaredNorm() - radius * radius);
        if (!(v2 > 0.) || root < 0. || std::sqrt(root) < b)
          refuse_miss(facets, parameters);
        return {{std::max(0., (-b - std::sqrt(root)) / v2), (-b + std::sqrt(root)) / v2}};
      }

      double closing_speed(const double now) const ///< m/s, at most
      {
        return velocity.norm() + std::abs(rotor.speed(now)) * reach;
      }

      bool touches(const double now) const
      {
        const TurnedSurface turned(facets, rotor, now);
        return initial_overlap(MovedPoints(points, now * velocity, velocity).view, turned.view).depth > 0.;
      }

      /// How long nothing can touch from now on, s; 0 where something does.
      double step_of_no_touch(const double now) const
      {
        const TurnedSurface turned(facets, rotor, now);
        const MovedPoints   moved(points, now * velocity, velocity);
        const double        apart = bounds_of(moved.view).separation(bounds_of(turned.view));
        if (apart <= 0. && initial_overlap(moved.view, turned.view).depth > 0.)
          return 0.;
        return std::max(apart, 0.5 * points.spacing) / closing_speed(now);
      }

      double bisect(double before, double after) const
      {
        while ((after - before) * closing_speed(after) > clearance * parameters.spacing)
          {
            const double middle = 0.5 * (before + after);
            if (middle <= before || middle >= after)
              break;
            (touches(middle) ? after : before) = middle;
          }
        return before;
      }

      Meeting meeting(const double time) const
      {
        const TurnedSurface turned(facets, rotor, time);
        const Turn          turn  = rotor.turn(time);
        const HubMotion     hub   = rotor.motion(time);
        const Point3        place = Point3(parameters.position.data()) + time * velocity;
        Point3              aim   = place;
        for (unsigned int pass = 0; pass < 3; ++pass)
          aim = find_crossing(place, velocity - hub.velocity(aim), turned.view);
        return {time, aim, hub.velocity(aim), hub.centre + turn.back(aim - hub.centre)};
      }
    };

    /// What is given besides the position must be what follows from it: to what a particle can tell.
    void require_agreement(const Meeting &meeting, const BirdParameters &parameters, const Rotor *const rotor)
    {
      const Point3 position(parameters.position.data()), velocity(parameters.velocity.data());
      const double speed = (velocity - meeting.frame).norm();
      if (const double given = parameters.arrival;
          given > 0. && std::abs(given - meeting.time) > std::max(1e-3 * meeting.time, parameters.spacing / speed))
        throw InputError(
          fmt::format("{0}/Arrival time = {1:.6g} s contradicts {0}/Position, from which the bird comes at "
                      "{2:.6g} s.\nLeave one of the two out, or correct it.",
                      parameters.section, given, meeting.time));
      if (!parameters.is_aim_given)
        return;
      const Point3 given(parameters.aim_point.data());
      const Point3 then     = rotor != nullptr ? rotor->turn(meeting.time).carried(given) : given;
      const Point3 along    = (rotor != nullptr ? velocity : Point3(velocity - meeting.frame)).normalized();
      const Point3 way      = then - position;
      const double distance = (way - way.dot(along) * along).norm();
      const double allowed  = (rotor != nullptr ? 1. : 0.1) * parameters.spacing + 1e-3 * way.norm();
      if (distance > allowed)
        throw InputError(fmt::format("{0}/Aim point contradicts {0}/Position: the path of the centre along Velocity "
                                     "passes it at {1:.4g} m.\nLeave "
                                     "one of the two out, or correct it.",
                                     parameters.section, distance));
    }
  } // namespace

  void move_to_position(Bird &bird, const BirdParameters &parameters)
  {
    if (parameters.position.empty())
      return;
    const Point3 way = Point3(parameters.position.data()) - bird.packing().centre;
    bird.advance_in_flight(1., Point3(parameters.velocity.data()) - way);
  }

  FirstTouch place_at_position(Bird &bird, Blade &blade, BirdParameters &parameters)
  {
    const FacetsView   facets = blade.facets();
    const Rotor *const rotor  = blade.rotor();
    const Point3       velocity(parameters.velocity.data());
    move_to_position(bird, parameters);
    const PointsView points = bird.points();
    if (const Overlap overlap = initial_overlap(points, facets); overlap.depth > 0.)
      refuse_overlap(overlap, parameters);
    const Meeting meeting = rotor != nullptr ? SweptMeeting(points, facets, *rotor, parameters).find()
                                             : meet_in_frame(points, facets, parameters);
    require_agreement(meeting, parameters, rotor);
    const Point3                 closing = velocity - meeting.frame;
    FirstTouch                   touch{0., closing.norm(), {{closing[0], closing[1], closing[2]}}};
    std::optional<TurnedSurface> turned;
    if (rotor != nullptr)
      turned.emplace(facets, *rotor, meeting.time);
    const MovedPoints then(points, meeting.time * (rotor != nullptr ? velocity : closing), closing);
    touch.share_in_the_way = compute_share_in_the_way(then.view, turned ? turned->view : facets, closing);
    parameters.arrival     = meeting.time;
    if (!parameters.is_aim_given)
      for (unsigned int d = 0; d < 3; ++d)
        parameters.aim_point[d] = meeting.aim_at_start[d];
    return touch;
  }
} // namespace birdstrike
