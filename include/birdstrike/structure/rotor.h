#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/structure/parameters.h>

#include <memory>
#include <vector>

namespace birdstrike
{
  class TimeLaw;

  /// What sits on a hub, turned by an angle about an axis a through c: points that were at X are at c + R (X - c), with
  /// R of Rodrigues.
  class Turn
  {
  public:
    Turn() = default; ///< by nothing
    Turn(const Point3 &axis, const Point3 &centre, double angle);

    /// R v. Without a difference of close numbers: v + sin(angle) a x v + 2 sin^2(angle/2) a x (a x v).
    Point3 operator()(const Point3 &v) const
    {
      return v + change(axis.cross(v), sine);
    }
    Point3 back(const Point3 &v) const ///< R^T v
    {
      return v + change(axis.cross(v), -sine);
    }
    Point3 carried(const Point3 &x) const
    {
      return x + displacement(x);
    }
    /// Of a point of the hub that was at X, m.
    Point3 displacement(const Point3 &reference) const
    {
      return change(axis.cross(Point3(reference - centre)), sine);
    }
    Point3 rotation() const ///< rad, about the axis
    {
      return angle * axis;
    }

  private:
    Point3 change(const Point3 &once, const double of_sine) const
    {
      return of_sine * once + versine * axis.cross(once);
    }

    Point3 axis = Point3::UnitZ(), centre = Point3::Zero(); ///< -, m
    double angle = 0., sine = 0., versine = 0.;             ///< rad, -, -
  };

  /// Velocities and centripetal accelerations of what sits on a hub, at an instant.
  struct HubMotion
  {
    Point3 axis, centre; ///< -, m
    double speed;        ///< rad/s

    Point3 angular_velocity() const
    {
      return speed * axis;
    }
    /// Of the place x (m), m/s.
    Point3 velocity(const Point3 &x) const
    {
      return angular_velocity().cross(Point3(x - centre));
    }
    Point3 centripetal_acceleration(const Point3 &x) const ///< m/s^2
    {
      const Point3 r = x - centre;
      return -speed * speed * (r - axis.dot(r) * axis);
    }
  };

  /// The rigid rotation of what sits on the hub: about an axis, with a constant speed, or with one that is a formula of
  /// the time. Its angle is the integral of the formula, by adaptive quadrature of Gauss in pieces of time that do not
  /// depend on what was asked before. Not thread-safe with a formula.
  class Rotor
  {
  public:
    Rotor() = default; ///< that stands still
    /// @throws InputError for a speed that is neither a number nor a formula of t, or not finite.
    explicit Rotor(const BladeParameters::Spin &parameters);

    bool turns() const
    {
      return law != nullptr || constant != 0.;
    }
    bool is_steady() const
    {
      return law == nullptr;
    }
    double    speed(double time) const; ///< rad/s
    HubMotion motion(const double time) const
    {
      return {axis, centre, speed(time)};
    }
    Point3 angular_acceleration(double time) const; ///< rad/s^2, by a difference over 0.1 us from this time on
    /// Throws InputError where a formula has no value from the start to a little after this time (s).
    void require_known_until(double time) const;
    /// From the start, or from another time, on.
    Turn turn(const double time) const
    {
      return {axis, centre, angle(time)};
    }
    Turn turn(const double from, const double to) const
    {
      return {axis, centre, angle(to) - angle(from)};
    }

  private:
    double angle(double time) const; ///< rad
    double integrate(double from, double to) const;

    double                         constant = 0.; ///< rad/s
    std::shared_ptr<const TimeLaw> law;           ///< rad/s
    mutable std::vector<double>    angles{0.};    ///< rad, at whole multiples of the piece of time
    Point3                         axis   = Point3::UnitZ();
    Point3                         centre = Point3::Zero(); ///< m
  };
} // namespace birdstrike
