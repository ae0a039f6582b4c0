#include "io/aim/aimed_velocity.h"
#include "io/aim/contradiction.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/rotor.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace birdstrike
{
  namespace
  {
    constexpr double degree     = std::numbers::pi / 180.;
    constexpr double same_angle = 0.05 * degree;

    Point3 direction_by_angle(const AimedSurface &surface, const double degrees)
    {
      const Point3 n(surface.normal.data()), chord(surface.chord.data());
      if (std::abs(degrees) == 90.)
        return degrees > 0. ? n : Point3(-n);
      const Point3 tangent = (chord - chord.dot(n) * n).normalized();
      return std::sin(degrees * degree) * n + std::cos(degrees * degree) * tangent;
    }

    void check_angle(const BirdParameters &bird, const BladeParameters &blade)
    {
      if (!blade.loads.initial_spin.empty() || !blade.loads.initial_velocity.empty())
        throw InputError(
          bird.section +
          "/Angle to surface: the blade moves at the start (Blade/Loads/Initial spin or Initial velocity), so that the "
          "bird's velocity alone does not set the angle at which they meet.\nGive Speed with Flight direction, or "
          "Velocity; explain says at which angle they meet.");
      if (Rotor(blade.spin).turns())
        throw InputError(bird.section + "/Angle to surface: the blade turns (Blade/Spin/Speed), so that the bird's "
                                        "velocity alone does not set the angle at which they meet.\nGive Speed with "
                                        "Flight direction, or Velocity; explain says at which angle they meet.");
      if (const double degrees = bird.angle_to_surface[0]; degrees == 0. || std::abs(degrees) == 180.)
        throw InputError(bird.section +
                         "/Angle to surface: along the surface the bird never meets it.\nGive an angle other than 0 "
                         "and 180 degrees; 90 is along the normal.");
    }

    /// The direction that is given besides Velocity; nothing if none is.
    std::optional<Point3> find_direction(const BirdParameters &bird, const BladeParameters &blade)
    {
      std::optional<Point3> by_angle;
      if (!bird.angle_to_surface.empty())
        {
          check_angle(bird, blade);
          by_angle = direction_by_angle(*bird.aimed_surface, bird.angle_to_surface[0]);
        }
      if (bird.flight_direction.empty())
        return by_angle;
      const Point3 given = Point3(bird.flight_direction.data()).normalized();
      // any direction at that angle will do, in whatever plane
      if (by_angle)
        if (const Point3 n(bird.aimed_surface->normal.data());
            std::abs(std::asin(std::clamp(given.dot(n), -1., 1.)) - std::asin(by_angle->dot(n))) > same_angle)
          refuse_difference(bird, "Angle to surface", fmt::format("{:g} degrees", bird.angle_to_surface[0]),
                            "Flight direction", fmt::format("{:.4g} degrees", std::asin(given.dot(n)) / degree));
      return given;
    }
  } // namespace

  Point3 find_velocity(const BirdParameters &bird, const BladeParameters &blade, const bool is_given)
  {
    const Point3                given(bird.velocity.data());
    const std::optional<Point3> direction = find_direction(bird, blade);
    if (!is_given)
      {
        if (bird.speed.empty() && !direction)
          return given; // the default
        if (bird.speed.empty() || !direction)
          throw InputError(bird.section + "/" + (direction ? "Speed" : "Angle to surface") +
                           " is missing.\nA velocity is Velocity, or Speed together with Angle to surface or Flight "
                           "direction; a further "
                           "bird that gives one of these does not take Velocity from section Bird.");
        return bird.speed[0] * *direction;
      }
    if (!bird.speed.empty() && std::abs(given.norm() - bird.speed[0]) > given_tolerance * bird.speed[0])
      refuse_difference(bird, "Speed", fmt::format("{:g} m/s", bird.speed[0]), "Velocity",
                        fmt::format("{:.6g} m/s", given.norm()));
    if (direction && (given.normalized() - *direction).norm() > given_tolerance)
      {
        if (bird.flight_direction.empty())
          refuse_difference(bird, "Angle to surface", fmt::format("{:g} degrees", bird.angle_to_surface[0]), "Velocity",
                            "along " + shown(given.normalized()) + " instead of " + shown(*direction));
        refuse_difference(bird, "Flight direction", shown(Point3(bird.flight_direction.data())), "Velocity",
                          shown(given.normalized()));
      }
    return given;
  }
} // namespace birdstrike
