#include "bird/attitude.h"

#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    constexpr double degree = std::numbers::pi / 180.;
  }

  Matrix3<double> compute_attitude(const BirdParameters &parameters)
  {
    const Point3 v(parameters.velocity[0], parameters.velocity[1], parameters.velocity[2]);
    const Point3 direction = v.norm() > 0. ? Point3(v.normalized()) : Point3(0., 0., 1.);
    const Point3 of_blade(parameters.span.data());
    Point3       span = of_blade - direction.dot(of_blade) * direction;
    if (span.norm() < 1e-3)
      span = Point3::UnitY() - direction[1] * direction;
    if (span.norm() < 1e-3) // along a span that is y
      span = Point3::UnitZ() - direction[2] * direction;
    span.normalize();
    Matrix3<double> frame;
    frame << span, direction.cross(span), direction;
    return Eigen::AngleAxisd(parameters.yaw * degree, span) *
           Eigen::AngleAxisd(parameters.pitch * degree, frame.col(1)) *
           Eigen::AngleAxisd(parameters.roll * degree, direction) * frame;
  }

  Matrix3<double> compute_slice_frame(const BirdParameters &parameters)
  {
    if (parameters.slice_normal.empty())
      return compute_attitude(parameters);
    BirdParameters without_roll = parameters;
    without_roll.roll           = 0.;
    const Matrix3<double> bird  = compute_attitude(without_roll);
    const Point3          n     = Point3(parameters.slice_normal.data()).normalized();
    Point3                x     = bird.col(0) - bird.col(0).dot(n) * n;
    if (x.norm() < 0.1)
      x = bird.col(2) - bird.col(2).dot(n) * n;
    x.normalize();
    Matrix3<double> frame;
    frame << x, n.cross(x), n;
    return Eigen::AngleAxisd(parameters.roll * degree, n) * frame;
  }
} // namespace birdstrike
