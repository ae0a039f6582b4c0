#include <birdstrike/material/power_law.h>

#include <gtest/gtest.h>

namespace birdstrike
{
  namespace
  {
    // Reference: the mathematical library's expm1 and log1p, each within an ulp or so; their composition loses
    // gamma log(1 + mu) ulps, hence the tolerance.
    TEST(PowerLaw, LanesAgreeWithTheLibraryFromTinyToHugeCompression)
    {
      for (const double gamma : {1., 4., 7.15, 7.98})
        for (const double size : {1e-300, 1e-18, 1e-9, 1e-3, 0.1, 0.3, 0.449, 0.451, 0.9, 0.999, 1. - 1e-12})
          for (const double sign : {-1., 1.})
            {
              const double mu = sign * size, expected = std::expm1(gamma * std::log1p(mu));
              EXPECT_NEAR(lane(compute_power_less_one(Lanes(mu), gamma), n_lanes - 1), expected,
                          1e-14 * std::abs(expected))
                << mu << " " << gamma;
            }
      EXPECT_EQ(lane(compute_power_less_one(Lanes(0.), 7.98), 0), 0.);
      for (const double mu : {1.5, 4., 19.})
        EXPECT_NEAR(lane(compute_power_less_one(Lanes(mu), 7.98), 0) / std::expm1(7.98 * std::log1p(mu)), 1., 1e-14)
          << mu;
      for (const double mu : {-1., -2., -1e300, double(INFINITY), 1e40, double(NAN)})
        {
          const double expected = std::expm1(7.98 * std::log1p(mu)),
                       found    = lane(compute_power_less_one(Lanes(mu), 7.98), 0);
          EXPECT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << mu;
        }
    }

    TEST(PowerLaw, LanesOfEveryKindDoNotDisturbOneAnother)
    {
      Lanes mu;
      for (std::size_t k = 0; k < n_lanes; ++k)
        mu[k] = k % 4 == 0 ? 3. : k % 4 == 1 ? 0.01 : k % 4 == 2 ? -0.7 : 1e30;
      const Lanes power = compute_power_less_one(mu, 7.98);
      for (std::size_t k = 0; k < n_lanes; ++k)
        EXPECT_NEAR(lane(power, k) / (std::pow(1. + lane(mu, k), 7.98) - 1.), 1., 1e-13);
    }
  } // namespace
} // namespace birdstrike
