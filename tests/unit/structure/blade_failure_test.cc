#include "blade_case.h"

#include "structure/deformable_blade.h"
#include "structure/surface/contact_surface.h"
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace birdstrike::blade_failure_test
{
  namespace
  {
    using test::advance;
    using test::balance;

    /// A strip of 10 x 2 elements, 50 x 10 x 1 mm, clamped at x = 0, whose free part flies off; between 20 and 30 mm
    /// the velocity rises, so that a step strains by little.
    BladeParameters strip()
    {
      BladeParameters p;
      p.mesh.length                     = 0.05;
      p.mesh.chord                      = 0.01;
      p.mesh.n_span                     = 10;
      p.mesh.n_chord                    = 2;
      p.thickness.value                 = "0.001";
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
          const double dt = std::min(0.2 * blade.largest_stable_step(), time);
          advance(blade, dt, 1);
          t += dt;
        }
    }

    TEST(ContactSurface, KeepsWhatIsLeftWithItsNeighbours)
    {
      // 0 1 2 in a row; 1 goes
      SurfaceMesh mesh;
      for (const double y : {0., 1.})
        for (const double x : {0., 1., 2., 3.})
          mesh.nodes.push_back({{x, y, 0.}});
      for (const std::uint32_t i : {0u, 1u, 2u})
        mesh.cells.push_back({{i, i + 1, i + 5, i + 4}});
      mesh.neighbors = {{-1, 1, -1, -1}, {-1, 2, -1, 0}, {FacetsView::symmetry_edge, -1, -1, 1}};
      ContactSurface surface(mesh, {0.1, 0.2, 0.3});
      FacetsView     view;
      surface.offer(view);
      EXPECT_EQ(view.n_facets, 3u);
      EXPECT_EQ(view.nodes, mesh.cells.data()) << "nothing is copied";
      EXPECT_EQ(view.revision, 0u);
      surface.remove([](const std::size_t f) { return f == 1; });
      surface.offer(view);
      ASSERT_EQ(view.n_facets, 2u);
      EXPECT_EQ(view.nodes[1], mesh.cells[2]);
      EXPECT_EQ(view.half_thickness[1], 0.3);
      EXPECT_EQ(view.neighbor[0], (std::array<std::int32_t, 4>{-1, -1, -1, -1}));
      EXPECT_EQ(view.neighbor[1], (std::array<std::int32_t, 4>{FacetsView::symmetry_edge, -1, -1, -1}));
      EXPECT_EQ(view.revision, 1u);
      surface.remove([](const std::size_t f) { return f != 0; });
      surface.offer(view);
      EXPECT_EQ(view.n_facets, 1u);
      EXPECT_EQ(view.revision, 2u);
    }

    // Torn in two: what has come off flies on with its momentum, and nothing of the energy is lost.
    TEST(BladeFailure, ATornStripKeepsItsBalanceAndItsMomentum)
    {
      ThreadPool pool;
      ShellBlade blade(strip(), pool);
      const auto momentum = blade.momenta().momentum[0];
      const auto before   = balance(blade);
      EXPECT_TRUE(blade.failure().can_fail);
      EXPECT_EQ(blade.failure().n_elements, 0u);
      EXPECT_EQ(blade.facets().n_facets, 20u);
      run(blade, 100e-6);

      const FailureReport failure = blade.failure();
      EXPECT_GT(failure.n_elements, 1u);
      EXPECT_LT(failure.n_elements, 8u);
      EXPECT_NEAR(failure.mass, static_cast<double>(failure.n_elements) * 0.05 * 0.01 * 0.001 * 2780. / 20., 1e-12);
      EXPECT_EQ(blade.mass(), ShellBlade(strip(), pool).mass()) << "no mass leaves";
      const auto m        = blade.momenta();
      const auto energies = blade.energies();
      EXPECT_NEAR(m.momentum[0] + m.support_impulse[0], momentum, 1e-12 * momentum);
      EXPECT_NEAR(balance(blade) / before, 1., 2e-3); // the step shrinks while elements stretch
      EXPECT_GT(energies.eroded, 0.);
      EXPECT_GT(energies.elastic, 0.);
      EXPECT_GT(energies.plastic, energies.eroded);

      const FacetsView facets = blade.facets();
      EXPECT_EQ(facets.n_facets, 20u - failure.n_elements);
      EXPECT_GT(facets.revision, 0u);
      const FieldSnapshot snapshot = blade.snapshot();
      EXPECT_EQ(snapshot.cells.size(), 4 * facets.n_facets);
      for (const Field &field : snapshot.fields)
        {
          EXPECT_EQ(field.values.size(), (field.on_cells ? facets.n_facets : 33) * field.n_components) << field.name;
          EXPECT_TRUE(
            std::all_of(field.values.begin(), field.values.end(), [](const double v) { return std::isfinite(v); }))
            << field.name;
        }
      // what has come off flies on
      run(blade, 20e-6);
      const auto later = blade.momenta();
      EXPECT_NEAR(later.momentum[0] + later.support_impulse[0], momentum, 1e-12 * momentum);
      EXPECT_GT(blade.nodes().velocity[6 * 10], 10.);
      EXPECT_EQ(blade.failure().n_elements, failure.n_elements);
      EXPECT_EQ(blade.census().n_elements, 20u);
    }

    TEST(BladeFailure, NothingPressesOnWhatHasFailed)
    {
      ThreadPool pool;
      auto       p                      = strip();
      p.supports.clamped                = "";
      p.supports.held                   = "0: hinged; 1: hinged; 2: hinged; 3: hinged";
      p.loads.initial_velocity          = "";
      p.loads.pressure                  = "1e9"; // tears everything at once
      p.material.failure.plastic_strain = 0.01;
      ShellBlade blade(p, pool);
      for (int k = 0; k < 2000 && blade.failure().n_elements < 20; ++k)
        advance(blade, 5e-8, 1);
      ASSERT_EQ(blade.failure().n_elements, 20u);
      EXPECT_EQ(blade.facets().n_facets, 0u);
      advance(blade, 5e-8, 2); // the last half kick with pressure is over
      const auto work = blade.energies().external_work;
      advance(blade, 5e-8, 10);
      EXPECT_EQ(blade.energies().external_work, work);
      EXPECT_EQ(blade.step_limit().value, std::numeric_limits<double>::infinity());
      EXPECT_NEAR(blade.failure().free_mass, blade.mass(), 1e-12 * blade.mass());
      EXPECT_EQ(blade.root_section().peak_stress(), 0.);
      EXPECT_TRUE(blade.failure().has_lost_tip);
    }

    // Elements at root and tip fail: what is reported stays finite, and zero where nothing is left.
    TEST(BladeFailure, RootAndTipAreStillReported)
    {
      ThreadPool pool;
      auto       p             = strip();
      p.loads.initial_velocity = "if(x > 0.0001, 200, 0); 0; 0"; // torn off at the root
      ShellBlade blade(p, pool);
      run(blade, 60e-6);
      const FailureReport failure = blade.failure();
      EXPECT_EQ(failure.n_at_root, 2u);
      const auto root = blade.root_section();
      ASSERT_EQ(root.stress_rear.size(), 2u);
      EXPECT_EQ(root.peak_stress(), 0.);
      EXPECT_EQ(root.normal_force, 0.);
      EXPECT_EQ(root.bending_moment, 0.);
      EXPECT_FALSE(failure.has_lost_tip);
      EXPECT_TRUE(std::isfinite(blade.tip_deflection().mid_chord));
      EXPECT_GT(find_largest(blade.peak_plastic_strains()).value, 0.1 - 1e-12) << "of failed elements too";
    }

    TEST(BladeFailure, TheHalfTearsAsTheWhole)
    {
      ThreadPool pool;
      ShellBlade whole(strip(), pool);
      auto       p   = strip();
      p.is_halved    = true;
      p.mesh.n_chord = 2;
      ShellBlade half(p, pool);
      run(whole, 60e-6);
      run(half, 60e-6);
      ASSERT_GT(whole.failure().n_elements, 0u);
      EXPECT_EQ(half.failure().n_elements, whole.failure().n_elements);
      EXPECT_NEAR(half.failure().mass / whole.failure().mass, 1., 1e-12);
      EXPECT_NEAR(half.energies().eroded / whole.energies().eroded, 1., 1e-9);
    }

    // Bent, not pulled: the outer layers fail while the middle ones carry the element on.
    TEST(BladeFailure, CountsPointsThatFailInElementsThatCarryOn)
    {
      ThreadPool      pool;
      BladeParameters p                 = strip();
      p.loads.initial_velocity          = "0; 0; 200 * min(1, max(0, x/0.01 - 2))";
      p.material.failure.plastic_strain = 0.008;
      ShellBlade whole(p, pool);
      run(whole, 100e-6);
      const FailureReport failure = whole.failure();
      ASSERT_GT(failure.n_points, 0u);
      EXPECT_LE(failure.n_partly, failure.n_points);

      // what the fields show of each element adds up to them
      const FieldSnapshot snapshot = whole.snapshot();
      const auto          points   = std::find_if(snapshot.fields.begin(), snapshot.fields.end(),
                                                  [](const Field &field) { return field.name == "failed_points"; });
      ASSERT_NE(points, snapshot.fields.end());
      EXPECT_EQ(std::accumulate(points->values.begin(), points->values.end(), 0.), failure.n_points);
      EXPECT_EQ(points->values.size(), 20u - failure.n_elements); // those that failed whole are left out
      EXPECT_EQ(points->values.size() - std::count(points->values.begin(), points->values.end(), 0.), failure.n_partly);
      const auto most = static_cast<std::size_t>(std::ranges::max_element(points->values) - points->values.begin());
      for (unsigned int d = 0; d < 3; ++d)
        {
          double mean = 0.; // of the corners, undeformed
          for (unsigned int v = 0; v < 4; ++v)
            mean += 0.25 * snapshot.points[3 * snapshot.cells[4 * most + v] + d];
          EXPECT_NEAR(failure.partly_at[d], mean, 1e-12);
        }

      p.is_halved    = true;
      p.mesh.n_chord = 2;
      ShellBlade half(p, pool);
      run(half, 100e-6);
      EXPECT_EQ(half.failure().n_points, failure.n_points);
      EXPECT_EQ(half.failure().n_partly, failure.n_partly);
    }
  } // namespace
} // namespace birdstrike::blade_failure_test
