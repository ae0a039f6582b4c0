#include "bird/kernel.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace birdstrike;

namespace
{
  template <class Kernel>
  void check(const double h)
  {
    const Kernel kernel(h);
    const int    n      = 20000;
    const double dr     = 2. * h / n;
    double       volume = 0.;
    for (int k = 0; k < n; ++k)
      {
        const double r = (k + 0.5) * dr;
        volume += 4. * std::numbers::pi * r * r * kernel.value(r) * dr;
        const double step = 1e-5 * h;
        // central difference: truncation about step^2/h^2
        EXPECT_NEAR(kernel.slope(r) * r, -(kernel.value(r + step) - kernel.value(r - step)) / (2. * step),
                    1e-7 * kernel.value(0.) / h);
      }
    EXPECT_NEAR(volume, 1., 1e-7); // midpoint rule: (dr/h)^2
    EXPECT_EQ(kernel.value(2. * h), 0.);
    EXPECT_EQ(kernel.slope(2.5 * h), 0.);
    EXPECT_TRUE(std::isfinite(kernel.slope(0.)));
    const Lanes r([&](const auto k) { return 0.3 * k * h; }), w = kernel.slope(r);
    for (std::size_t k = 0; k < n_lanes; ++k)
      EXPECT_NEAR(w[k], kernel.slope(static_cast<double>(r[k])), 1e-14 * kernel.slope(0.));
  }
} // namespace

TEST(Kernel, WendlandIsNormalisedAndItsSlopeIsItsDerivative)
{
  check<WendlandC2>(0.0026);
}

TEST(Kernel, CubicSplineIsNormalisedAndItsSlopeIsItsDerivative)
{
  check<CubicSpline>(0.0026);
}
