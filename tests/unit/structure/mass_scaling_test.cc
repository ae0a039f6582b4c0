#include "mass_scaling_case.h"
#include "solid_frequencies.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

namespace birdstrike::mass_scaling_test
{
  namespace
  {
    using test::scaled_plate;
    using test::without_viscosity;

    TEST(MassScaling, TakesTheStepOfThePlaneForAnyNumberOfLayers)
    {
      ThreadPool pool;
      double     of_one = 0.;
      for (const unsigned int n_layers : {1u, 2u, 4u, 8u})
        {
          auto             p = without_viscosity(scaled_plate(14, 4, n_layers)); // whose length is the layer
          const SolidBlade blade(p, pool);
          const auto       scaling = blade.census().mass_scaling;
          EXPECT_NEAR(blade.largest_stable_step() / scaling.step, 1., 1e-12);
          EXPECT_EQ(scaling.n_scaled, blade.n_elements());
          p.mass_scaling.method = MassScalingMethod::off;
          const SolidBlade plain(p, pool);
          EXPECT_NEAR(scaling.step_before / plain.largest_stable_step(), 1., 1e-12);
          EXPECT_EQ(plain.census().mass_scaling.step, 0.);
          EXPECT_EQ(blade.mass(), plain.mass());
          of_one = n_layers == 1 ? scaling.step : of_one;
          EXPECT_NEAR(scaling.step / of_one, 1., 3e-4); // factors end at 2^20
          EXPECT_GT(scaling.step / plain.largest_stable_step(), 3. * n_layers);
        }
    }

    // A plate of width b with added r^2 per mass: 12 r^2/b^2; r^2 = (factor - 1) h^2/4 in layers of height h.
    TEST(MassScaling, ReportsWhatItAdds)
    {
      ThreadPool pool;
      for (const unsigned int n_layers : {1u, 3u})
        {
          const SolidBlade blade(scaled_plate(28, 8, n_layers), pool);
          const auto       scaling = blade.census().mass_scaling;
          const double     height = 0.00427 / n_layers, b = 0.0889 * std::sqrt(1. + 2. / 64.); // nodes, not bricks
          const double     expected = 3. * (scaling.largest_factor - 1.) * height * height / (b * b);
          EXPECT_NEAR(scaling.added_rotary_inertia / expected, 1., 0.01); // thickness in the plate's own inertia
        }
    }

    TEST(MassScaling, KeepsToItsLimits)
    {
      ThreadPool pool;
      auto       p                 = scaled_plate(14, 4, 4);
      const auto most              = SolidBlade(p, pool).census().mass_scaling;
      p.mass_scaling.largest_added = 0.5 * most.added_rotary_inertia;
      const auto half              = SolidBlade(p, pool).census().mass_scaling;
      EXPECT_LE(half.added_rotary_inertia, p.mass_scaling.largest_added);
      EXPECT_GT(half.added_rotary_inertia, 0.98 * p.mass_scaling.largest_added);
      EXPECT_LT(half.step, most.step);
      p.mass_scaling.target_step = 0.5 * (half.step + half.step_before);
      const SolidBlade wanted(p, pool);
      EXPECT_NEAR(wanted.largest_stable_step() / p.mass_scaling.target_step, 1., 1e-6);
      p.mass_scaling.target_step = 0.5 * half.step_before; // allowed as it is
      EXPECT_EQ(SolidBlade(p, pool).census().mass_scaling.n_scaled, 0u);

      const auto expect_refused = [&](const double step, const std::string &why) {
        p.mass_scaling.target_step = step;
        try
          {
            SolidBlade blade(p, pool);
            ADD_FAILURE() << step;
          }
        catch (const InputError &error)
          {
            EXPECT_NE(std::string(error.what()).find("Mass scaling/Target step"), std::string::npos);
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
          }
      };
      expect_refused(most.step, "Largest added inertia");
      expect_refused(2. * most.step, "dimensions in the plane");
    }

    // Benchmarks A4 and B8 (Mindlin's theory, as in SolidBlade) with the step of the plane: bending is lowered by
    // (2 pi r/L)^2/2, torsion by half of what the report says.
    TEST(MassScaling, LowersFrequenciesByWhatItSays)
    {
      ThreadPool pool;
      const auto p          = without_viscosity(scaled_plate(28, 8, 2));
      auto       q          = p;
      q.mass_scaling.method = MassScalingMethod::off;
      SolidBlade   scaled(p, pool), plain(q, pool);
      const auto   f = test::scaled_frequencies(scaled, 4), g = test::natural_frequencies(plain, 4);
      const double added = scaled.census().mass_scaling.added_rotary_inertia;
      for (unsigned int k = 0; k < 4; ++k)
        {
          RecordProperty("mode_" + std::to_string(k + 1), std::to_string(f[k]));
          EXPECT_LT(f[k], g[k]);
        }
      EXPECT_NEAR(f[0] / 36.863, 1., 0.01);
      EXPECT_NEAR(f[1] / 230.15, 1., 0.01);
      EXPECT_NEAR((1. - f[2] / g[2]) / (0.5 * added), 1., 0.15); // first torsion
      EXPECT_LT(1. - f[0] / g[0], 0.05 * added);
      EXPECT_LT(1. - f[1] / g[1], 0.3 * added);
    }

    TEST(MassScaling, MeansNothingForAShell)
    {
      auto p = scaled_plate(4, 2, 1);
      EXPECT_TRUE(p.unused_entries().empty());
      p.kind = BladeKind::shell;
      EXPECT_EQ(p.unused_entries(),
                (std::vector<std::string>{"Mass scaling/Method", "Mass scaling/Largest added inertia"}));
    }
  } // namespace
} // namespace birdstrike::mass_scaling_test
