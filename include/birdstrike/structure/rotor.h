#pragma once

#include <birdstrike/core/number.h>
#include <birdstrike/structure/parameters.h>

#include <cmath>

namespace birdstrike
{
  /// The rigid rotation of what sits on the hub, in closed form: at time t about an axis a through c by the angle
  /// w t. Points of the hub are at c + R(t) (X - c), with R of Rodrigues.
  class Rotor
  {
  public:
    Rotor() = default; ///< that stands still
    explicit Rotor(const BladeParameters::Spin &parameters)
      : speed(parameters.speed), axis(Point3(parameters.axis.data()).normalized()), centre(parameters.centre.data())
    {
    }

    bool turns() const
    {
      return speed != 0.;
    }
    Point3 angular_velocity() const ///< rad/s
    {
      return speed * axis;
    }
    double angle(const double time) const ///< rad
    {
      return speed * time;
    }
    /// R(t) v. Without a difference of close numbers: v + sin(angle) a x v + 2 sin^2(angle/2) a x (a x v).
    Point3 turned(const Point3 &v, const double time) const
    {
      const Point3 once = axis.cross(v);
      return v + change(once, time);
    }
    Point3 turned_back(const Point3 &v, const double time) const
    {
      return turned(v, -time);
    }
    /// Where a point of the hub at x is after some time.
    Point3 carried(const Point3 &x, const double time) const
    {
      return x + displacement(x, time);
    }
    /// u(t) of a point of the hub that is at X at t = 0, m.
    Point3 displacement(const Point3 &reference, const double time) const
    {
      return change(axis.cross(Point3(reference - centre)), time);
    }
    /// Of a point that turns with the hub, at its present place (m/s).
    Point3 velocity(const Point3 &position) const
    {
      return angular_velocity().cross(Point3(position - centre));
    }
    /// w^2 times the distance from the axis, outwards (m/s^2): what balances the elements in the turning frame.
    Point3 centrifugal_acceleration(const Point3 &position) const
    {
      const Point3 r = position - centre;
      return speed * speed * (r - axis.dot(r) * axis);
    }

  private:
    Point3 change(const Point3 &once, const double time) const
    {
      const double half = std::sin(0.5 * angle(time));
      return std::sin(angle(time)) * once + 2. * half * half * axis.cross(once);
    }

    double speed  = 0.; ///< rad/s
    Point3 axis   = Point3::UnitZ();
    Point3 centre = Point3::Zero(); ///< m
  };

  /// Directions of the hub as they lie at a time.
  struct Turned
  {
    Rotor  rotor;
    double time = 0.; ///< s

    Point3 operator()(const Point3 &v) const
    {
      return rotor.turns() ? rotor.turned(v, time) : v;
    }
  };
} // namespace birdstrike
