#include "blade_case.h"

#include "structure/deformable_blade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace birdstrike::solid_blade_failure_test
{
  namespace
  {
    /// A strip of 10 x 2 bricks in layers, 50 x 10 x 2 mm, clamped at x = 0, whose free part flies off; between 20 and
    /// 30 mm the velocity rises, so that a step strains by little.
    BladeParameters strip(const std::string &formulation, const unsigned int n_layers)
    {
      BladeParameters p;
      p.kind                            = BladeKind::solid;
      p.mesh.length                     = 0.05;
      p.mesh.chord                      = 0.01;
      p.mesh.n_span                     = 10;
      p.mesh.n_chord                    = 2;
      p.mesh.n_layers                   = n_layers;
      p.thickness.value                 = "0.002";
      p.element.formulation             = element_formulations().at(formulation);
      p.material.name                   = "Al 2024 Johnson-Cook";
      p.material.failure.law            = FailureLaw::plastic_strain;
      p.material.failure.plastic_strain = 0.1;
      p.loads.initial_velocity          = "200 * min(1, max(0, x/0.01 - 2)); 0; 0";
      return p;
    }

    void run(Blade &blade, const double time)
    {
      for (double t = 0.; t < time;)
        {
          const double dt = std::min({0.2 * blade.largest_stable_step(), 1e-6, time - t});
          test::advance(blade, dt, 1);
          t += dt;
        }
    }

    // Torn in two: what has come off flies on with its momentum, and nothing of the energy is lost.
    TEST(SolidBladeFailure, ATornStripKeepsItsBalanceAndItsMomentum)
    {
      ThreadPool pool;
      for (const auto &[formulation, n_layers] :
           {std::pair<std::string, unsigned int>("one point", 1), std::pair<std::string, unsigned int>("one point", 2),
            std::pair<std::string, unsigned int>("B-bar", 1)})
        {
          const auto p = strip(formulation, n_layers);
          SolidBlade blade(p, pool);
          const auto momentum = blade.momenta().momentum[0], before = test::balance(blade);
          EXPECT_TRUE(blade.failure().can_fail);
          EXPECT_EQ(blade.facets().n_facets, 2u * (20 + 10 * n_layers + 2 * n_layers));
          EXPECT_EQ(blade.facets().n_nodes, 33u * (n_layers + 1)) << "with those inside";
          run(blade, 100e-6);

          const FailureReport failure = blade.failure();
          EXPECT_GT(failure.n_elements, 1u) << formulation;
          EXPECT_LT(failure.n_elements, 10u * n_layers);
          EXPECT_EQ(failure.n_collapsed, 0u);
          EXPECT_NEAR(failure.mass, double(failure.n_elements) / (20. * n_layers) * blade.mass(), 1e-12);
          EXPECT_EQ(blade.mass(), SolidBlade(p, pool).mass()) << "no mass leaves";
          const auto m        = blade.momenta();
          const auto energies = blade.energies();
          EXPECT_NEAR(m.momentum[0] + m.support_impulse[0], momentum, 1e-12 * momentum);
          EXPECT_NEAR(test::balance(blade) / before, 1., 2e-3); // the step shrinks while elements stretch
          EXPECT_GT(energies.eroded, 0.);
          EXPECT_GT(energies.elastic, 0.);
          EXPECT_GT(energies.plastic, energies.eroded);

          const FacetsView facets = blade.facets();
          EXPECT_GT(facets.revision, 0u);
          EXPECT_FALSE(facets.two_sided);
          for (std::size_t f = 0; f < facets.n_facets; ++f)
            for (const std::int32_t neighbor : facets.neighbor[f])
              EXPECT_GE(neighbor, 0) << "closed again";
          const std::size_t   n_left   = 20 * n_layers - failure.n_elements;
          const FieldSnapshot snapshot = blade.snapshot();
          EXPECT_EQ(snapshot.cells.size(), 8 * n_left);
          for (const Field &field : snapshot.fields)
            {
              EXPECT_EQ(field.values.size(), (field.on_cells ? n_left : 33 * (n_layers + 1)) * field.n_components)
                << field.name;
              EXPECT_TRUE(
                std::all_of(field.values.begin(), field.values.end(), [](const double v) { return std::isfinite(v); }))
                << field.name;
            }
          run(blade, 20e-6);
          EXPECT_EQ(blade.failure().n_elements, failure.n_elements);
          EXPECT_EQ(blade.census().n_elements, 20u * n_layers);
        }
    }

    TEST(SolidBladeFailure, NothingPressesOnWhatHasFailed)
    {
      ThreadPool pool;
      auto       p                      = strip("one point", 1);
      p.supports.clamped                = "";
      p.supports.held                   = "0: hinged; 1: hinged; 2: hinged; 3: hinged";
      p.loads.initial_velocity          = "";
      p.loads.pressure                  = "2e9"; // tears everything at once
      p.material.failure.plastic_strain = 0.01;
      SolidBlade blade(p, pool);
      for (int k = 0; k < 4000 && blade.failure().n_elements < 20; ++k)
        test::advance(blade, 5e-8, 1);
      ASSERT_EQ(blade.failure().n_elements, 20u);
      EXPECT_EQ(blade.facets().n_facets, 0u);
      test::advance(blade, 5e-8, 2); // the last half kick with pressure is over
      const auto work = blade.energies().external_work, elastic = blade.energies().elastic;
      EXPECT_NEAR(elastic, 0., 1e-9 * blade.energies().eroded) << "nothing is left to hold any";
      test::advance(blade, 5e-8, 10);
      EXPECT_EQ(blade.energies().external_work, work);
      EXPECT_EQ(blade.step_limit().value, std::numeric_limits<double>::infinity());
      EXPECT_NEAR(blade.failure().free_mass, blade.mass(), 1e-12 * blade.mass());
      EXPECT_TRUE(blade.failure().has_lost_tip);
    }

    TEST(SolidBladeFailure, RootAndTipAreStillReported)
    {
      ThreadPool pool;
      auto       p             = strip("one point", 1);
      p.loads.initial_velocity = "if(x > 0.0001, 200, 0); 0; 0"; // torn off at the root
      SolidBlade blade(p, pool);
      run(blade, 60e-6);
      EXPECT_EQ(blade.failure().n_at_root, 2u);
      const auto root = blade.root_section();
      ASSERT_EQ(root.stress_rear.size(), 2u);
      EXPECT_EQ(root.peak_stress(), 0.);
      EXPECT_EQ(root.normal_force, 0.);
      EXPECT_FALSE(blade.failure().has_lost_tip);
      EXPECT_TRUE(std::isfinite(blade.tip_deflection().mid_chord));
      EXPECT_GT(find_largest(blade.peak_plastic_strains()).value, 0.1 - 1e-12) << "of failed elements too";
    }

    TEST(SolidBladeFailure, TheHalfTearsAsTheWhole)
    {
      ThreadPool pool;
      auto       p = strip("one point", 2);
      SolidBlade whole(p, pool);
      p.is_halved = true;
      SolidBlade half(p, pool);
      run(whole, 60e-6);
      run(half, 60e-6);
      ASSERT_GT(whole.failure().n_elements, 0u);
      EXPECT_EQ(half.failure().n_elements, whole.failure().n_elements);
      EXPECT_NEAR(half.failure().mass / whole.failure().mass, 1., 1e-12);
      EXPECT_NEAR(half.energies().eroded / whole.energies().eroded, 1., 1e-9);
    }
  } // namespace
} // namespace birdstrike::solid_blade_failure_test
