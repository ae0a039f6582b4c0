#include <birdstrike/structure/rotor.h>

#include <birdstrike/core/errors.h>
#include <birdstrike/core/expression.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    constexpr double piece     = 2e-5;  // s, over which a formula is integrated at once
    constexpr double tolerance = 1e-12; // of the mean speed, or of 1000 rad/s
    constexpr double shortest  = 1e-16; // s, not halved further where the formula leaps

    template <class Law>
    double integrate_by_halves(const Law &law, const double from, const double to, const double whole)
    {
      using Rule          = boost::math::quadrature::gauss<double, 7>;
      const double middle = 0.5 * (from + to);
      const double left = Rule::integrate(law, from, middle), right = Rule::integrate(law, middle, to);
      const double allowed = tolerance * std::max(1e3 * (to - from), std::abs(left) + std::abs(right));
      if (std::abs(left + right - whole) <= allowed || to - from < shortest)
        return left + right;
      return integrate_by_halves(law, from, middle, left) + integrate_by_halves(law, middle, to, right);
    }
  } // namespace

  Turn::Turn(const Point3 &axis, const Point3 &centre, const double angle)
    : axis(axis)
    , centre(centre)
    , angle(angle)
    , sine(std::sin(angle))
    , versine(2. * std::sin(0.5 * angle) * std::sin(0.5 * angle))
  {
  }

  Rotor::Rotor(const BladeParameters::Spin &parameters)
    : axis(Point3(parameters.axis.data()).normalized()), centre(parameters.centre.data())
  {
    if (const auto number = evaluate_arithmetic(parameters.speed))
      constant = *number;
    else if (is_present(parameters.speed))
      law = std::make_shared<const TimeLaw>(parameters.speed, "Spin/Speed");
    speed(0.);
  }

  double Rotor::speed(const double time) const
  {
    return law ? (*law)(time) : constant;
  }

  Point3 Rotor::angular_acceleration(const double time) const
  {
    constexpr double h = 1e-7; // s; forward, since a formula need not know what was before 0
    return law ? Point3((speed(time + h) - speed(time)) / h * axis) : Point3(Point3::Zero());
  }

  void Rotor::require_known_until(const double time) const
  {
    constexpr int    n_samples = 1000;
    constexpr double beyond    = 1e-5; // s, longer than half a step
    for (int k = 0; law && k <= n_samples; ++k)
      speed((time + beyond) * k / n_samples);
  }

  double Rotor::angle(const double time) const
  {
    if (!law)
      return constant * time;
    const double whole = std::floor(time / piece);
    if (!(whole > 0.))
      return integrate(0., time);
    const auto n = static_cast<std::size_t>(whole);
    while (angles.size() <= n)
      {
        const auto k = static_cast<double>(angles.size());
        angles.push_back(angles.back() + integrate((k - 1.) * piece, k * piece));
      }
    return angles[n] + integrate(whole * piece, time);
  }

  double Rotor::integrate(const double from, const double to) const
  {
    const auto law = [this](const double t) { return speed(t); };
    return integrate_by_halves(law, from, to, boost::math::quadrature::gauss<double, 7>::integrate(law, from, to));
  }
} // namespace birdstrike
