#include "mass_scaling_case.h"

#include "structure/deformable_blade.h"

#include <gtest/gtest.h>

#include <map>

namespace birdstrike::mass_scaling_motion_test
{
  namespace
  {
    using test::advance;
    using test::balance;
    using test::scaled_plate;
    using test::without_viscosity;

    double norm(const std::array<double, 3> &a)
    {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    TEST(MassScalingMotion, FreePlateKeepsItsMomenta)
    {
      ThreadPool pool;
      auto       p             = scaled_plate(8, 4, 3);
      p.supports.clamped       = "";
      p.loads.initial_velocity = "3 + 20*sin(30*y); 2 - 8*cos(20*x); 10*sin(12*x+20*y) + 5 + 1000*z";
      p.loads.initial_spin     = "200; -300; 100";
      SolidBlade   blade(p, pool);
      const auto   before = blade.momenta();
      const double energy = balance(blade), dt = 0.8 * blade.step_limit().value;
      advance(blade, dt, 1000);
      const auto after = blade.momenta();
      for (unsigned int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * norm(before.momentum));
          EXPECT_NEAR(after.angular_momentum[d], before.angular_momentum[d], 1e-11 * norm(before.angular_momentum));
        }
      EXPECT_NEAR(balance(blade) / energy, 1., 2e-3);
    }

    // Ten turns of a stressed block of thin layers, whose spin winds and unwinds them: the step is four times that of
    // the layers.
    TEST(MassScalingMotion, SpinningBlockKeepsItsEnergy)
    {
      ThreadPool pool;
      auto       p       = without_viscosity(scaled_plate(3, 3, 4));
      p.supports.clamped = p.supports.tip = "";
      p.mesh.length = p.mesh.chord = 0.03;
      p.thickness.value            = "0.01";
      p.loads.initial_velocity     = "3000*x; -1500*y; 4000*z";
      p.loads.initial_spin         = "2000; 1000; 30000";
      SolidBlade   blade(p, pool);
      const double initial = balance(blade), dt = 0.8 * blade.largest_stable_step();
      const auto   momentum = blade.momenta().angular_momentum;
      EXPECT_GT(dt, 2. * blade.census().mass_scaling.step_before);
      const double turn  = 2. * M_PI / 30000.;
      double       worst = 0.;
      for (unsigned int k = 0; k < 100; ++k)
        {
          advance(blade, dt, static_cast<unsigned int>(0.1 * turn / dt) + 1);
          worst = std::max(worst, std::abs(balance(blade) / initial - 1.));
        }
      RecordProperty("worst", std::to_string(worst));
      EXPECT_LT(worst, 1e-3);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(blade.momenta().angular_momentum[d], momentum[d], 1e-10 * norm(momentum));
    }

    // Held columns, single held components within columns, loads that act on their nodes: what is not in the blade is
    // in its supports.
    TEST(MassScalingMotion, SupportsTakeTheImpulse)
    {
      ThreadPool pool;
      auto       p          = scaled_plate(8, 4, 3);
      p.loads.pressure      = "1e5*sin(2e3*t)";
      p.loads.point_loads   = "0.3112 0 0: 0; 10; 100 | 0.3112 0.0444 -0.0021: 3; 0; 20";
      p.supports.held_boxes = "0.31 0.044 -0.01 0.32 0.045 -0.001: ux uz; 0.15 -0.045 0 0.16 -0.044 0.001: uy";
      SolidBlade blade(p, pool);
      advance(blade, 0.8 * blade.step_limit().value, 500);
      const auto m = blade.momenta();
      EXPECT_GT(norm(m.external_impulse), 0.05);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(m.momentum[d] + m.support_impulse[d], m.external_impulse[d], 1e-12 * norm(m.external_impulse));
      const auto nodes = blade.nodes();
      for (std::size_t i = 0; i < 3 * nodes.n; ++i)
        if (nodes.inverse_mass[i] == 0.)
          {
            EXPECT_EQ(nodes.velocity[i], 0.);
          }
      EXPECT_NEAR(balance(blade) / blade.energies().external_work, 0., 1e-3);
    }

    TEST(MassScalingMotion, LoadsAndDampingCloseTheBalance)
    {
      ThreadPool pool;
      auto       p             = scaled_plate(14, 4, 2);
      p.loads.pressure         = "3e4*(1 - exp(-2e3*t))";
      p.loads.initial_velocity = "0; 0; 500*z";
      p.loads.damping          = 400.;
      SolidBlade   blade(p, pool);
      const double initial = balance(blade);
      advance(blade, 0.9 * blade.step_limit().value, 3000);
      const auto energy = blade.energies();
      EXPECT_GT(energy.damped, 0.05 * energy.external_work);
      EXPECT_LT(std::abs(balance(blade) - initial), 1e-3 * energy.external_work); // of stresses: 3.5e-4
      const double by_work = energy.kinetic + energy.staggering + energy.internal + energy.damped;
      EXPECT_LT(std::abs(by_work - energy.external_work - initial), 1e-5 * energy.external_work); // 2e-6, as dt^2
    }

    // Kicks by contact alone, on one face, before and after drifts: the kinetic energy with M_s grows by the work that
    // is booked, the impulse and its moment arrive.
    TEST(MassScalingMotion, ContactKicksAreConsistent)
    {
      ThreadPool pool;
      auto       p       = scaled_plate(6, 3, 3);
      p.supports.clamped = "";
      SolidBlade       blade(p, pool);
      const auto       view    = blade.facets();
      const double     h       = 1e-9;
      Point3           impulse = Point3::Zero(), moment = Point3::Zero();
      const NodeForces forces = blade.clear_contact_forces();
      for (std::size_t n = 0; n < view.n_nodes; n += 3)
        {
          const Point3 f(10. * std::sin(double(n)), 5., 100. * std::cos(2. * double(n)));
          for (unsigned int d = 0; d < 3; ++d)
            forces.of(n)[d] += f[d];
          impulse += 20. * h * f;
          moment += 20. * h * Point3(view.position + 3 * n).cross(f);
        }
      for (unsigned int k = 0; k < 10; ++k)
        {
          blade.kick_contact(h, HalfKick::first);
          blade.kick_contact(h, HalfKick::second);
        }
      blade.kick_contact(0., HalfKick::first); // the report is then at the present velocity
      const auto energy = blade.energies();
      const auto m      = blade.momenta();
      EXPECT_GT(energy.kinetic, 0.);
      EXPECT_NEAR(energy.kinetic / energy.contact_work, 1., 1e-12);
      for (unsigned int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(m.momentum[d], impulse[d], 1e-12 * impulse.norm());
          EXPECT_NEAR(m.contact_impulse[d], impulse[d], 1e-12 * impulse.norm());
          EXPECT_NEAR(m.angular_momentum[d], moment[d], 1e-12 * moment.norm());
        }
    }

    TEST(MassScalingMotion, IsBitwiseEqualForAnyNumberOfThreads)
    {
      const auto p = scaled_plate(60, 36, 2);
      EXPECT_TRUE(test::is_bitwise_equal(test::shake<SolidBlade>(p, 1), test::shake<SolidBlade>(p, 2)));
    }

    std::map<std::array<double, 3>, std::size_t> nodes_by_place(SolidBlade &blade)
    {
      const auto                                   nodes = blade.nodes();
      std::map<std::array<double, 3>, std::size_t> result;
      const auto                                   round = [](const double x) { return std::round(1e9 * x) + 0.; };
      for (std::size_t n = 0; n < nodes.n; ++n)
        {
          const double *x                                   = nodes.reference + 3 * n;
          result[{{round(x[0]), round(x[1]), round(x[2])}}] = n;
        }
      return result;
    }

    TEST(MassScalingMotion, HalfAPlateMovesLikeTheWhole)
    {
      ThreadPool pool;
      auto       p             = scaled_plate(14, 6, 2);
      p.loads.pressure         = "-2e6*exp(-(x-0.2)^2/0.001-y^2/0.0005)";
      p.loads.initial_velocity = "-20*x; 300*y; -200*(x/0.3)^2*(1-300*y^2)";
      SolidBlade whole(p, pool);
      p.is_halved = true;
      SolidBlade half(p, pool);
      EXPECT_NEAR(half.census().mass_scaling.added_rotary_inertia / whole.census().mass_scaling.added_rotary_inertia,
                  1., 1e-9);
      const double dt = 0.8 * whole.largest_stable_step();
      EXPECT_NEAR(half.largest_stable_step() / whole.largest_stable_step(), 1., 1e-9);
      advance(whole, dt, 500);
      advance(half, dt, 500);
      const auto a = whole.nodes(), b = half.nodes();
      const auto place  = nodes_by_place(whole);
      double     length = 0., largest = 0.;
      for (const auto &[where, n] : nodes_by_place(half))
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double u = a.displacement[3 * place.at(where) + c];
            length         = std::max(length, std::abs(u));
            largest        = std::max(largest, std::abs(u - b.displacement[3 * n + c]));
          }
      EXPECT_GT(length, 0.005);
      EXPECT_LT(largest, 1e-9 * length);
      EXPECT_NEAR(half.energies().total() / whole.energies().total(), 1., 1e-9);
    }
  } // namespace
} // namespace birdstrike::mass_scaling_motion_test
