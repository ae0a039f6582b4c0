#include "blade_case.h"

#include "structure/deformable_blade.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

namespace birdstrike::shell_blade_test
{
  namespace
  {
    using test::advance;
    using test::balance;
    using test::elastic_plate;
    using test::free_plate;

    double norm(const std::array<double, 3> &a)
    {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    // Pairs of element forces cancel to round-off: a thousand steps leave 1e-12 of the largest momentum around.
    TEST(ShellBlade, FreePlateKeepsItsMomenta)
    {
      ThreadPool pool;
      auto       p             = free_plate(8, 4);
      p.loads.initial_velocity = "3 + 20*sin(30*y); 2 - 8*cos(20*x); 10*sin(12*x+20*y) + 5";
      p.loads.initial_spin     = "20; -30; 10";
      ShellBlade   blade(p, pool);
      const auto   before = blade.momenta();
      const double dt     = 0.8 * blade.step_limit().value;
      advance(blade, dt, 1000);
      const auto after = blade.momenta();
      for (unsigned int d = 0; d < 3; ++d)
        {
          EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * norm(before.momentum));
          EXPECT_NEAR(after.angular_momentum[d], before.angular_momentum[d], 1e-12 * norm(before.angular_momentum));
        }
    }

    // Trap 0.1: strains on the midpoint geometry close the balance; the bound is that of benchmark F2.
    TEST(ShellBlade, VibratingPlateKeepsItsEnergy)
    {
      ThreadPool pool;
      auto       p             = elastic_plate(14, 4);
      p.loads.initial_velocity = "0; 0; 30*(x/0.3112)^2 + 100*x*y";
      ShellBlade   blade(p, pool);
      const double initial = balance(blade), dt = 0.9 * blade.step_limit().value;
      double       worst = 0.;
      for (unsigned int k = 0; k < 100; ++k)
        {
          advance(blade, dt, 50);
          worst = std::max(worst, std::abs(balance(blade) / initial - 1.));
        }
      RecordProperty("worst_energy_error", std::to_string(worst));
      EXPECT_LT(worst, 1e-4);
    }

    TEST(ShellBlade, SupportsTakeTheImpulse)
    {
      ThreadPool pool;
      auto       p        = elastic_plate(8, 4);
      p.loads.pressure    = "1e5*sin(2e3*t)";
      p.loads.point_loads = "0.3112 0 0: 0; 10; 100";
      ShellBlade blade(p, pool);
      advance(blade, 0.8 * blade.step_limit().value, 500);
      const auto m = blade.momenta();
      EXPECT_GT(norm(m.external_impulse), 0.1);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(m.momentum[d] + m.support_impulse[d], m.external_impulse[d], 1e-12 * norm(m.external_impulse));
    }

    // Work of loads and of damping is booked with the velocity of the drift: the same bound as without them.
    TEST(ShellBlade, LoadsAndDampingCloseTheBalance)
    {
      ThreadPool pool;
      auto       p     = elastic_plate(14, 4);
      p.loads.pressure = "3e4*(1 - exp(-2e3*t))";
      p.loads.damping  = 200.;
      ShellBlade blade(p, pool);
      advance(blade, 0.9 * blade.step_limit().value, 3000);
      const auto energy = blade.energies();
      EXPECT_GT(energy.damped, 0.05 * energy.external_work);
      EXPECT_LT(std::abs(balance(blade)), 1e-4 * energy.external_work);
    }

    // Contact forces are kicked, booked and reported apart from the internal ones.
    TEST(ShellBlade, ContactForcesAreBooked)
    {
      ThreadPool   pool;
      ShellBlade   blade(free_plate(4, 2), pool);
      const auto   facets = blade.facets();
      const double f = 7., dt = 1e-7;
      const auto   set = [&] {
        const NodeForces forces = blade.clear_contact_forces();
        for (std::size_t n = 0; n < facets.n_nodes; ++n)
          forces.of(n)[2] = f / facets.inverse_mass[n];
      };
      set();
      for (unsigned int step = 0; step < 10; ++step)
        {
          blade.kick_contact(0.5 * dt, HalfKick::first);
          blade.drift(dt);
          set();
          blade.kick_contact(0.5 * dt, HalfKick::second);
        }
      // Uniform acceleration: v = 10 f dt, impulse M v, work M v^2/2 up to the half-step product (f dt)^2/8.
      const double v = 10. * f * dt, mass = blade.mass();
      EXPECT_NEAR(blade.contact_force()[2] / (f * mass), 1., 1e-13);
      EXPECT_NEAR(blade.momenta().contact_impulse[2] / (mass * v), 1., 1e-13);
      EXPECT_NEAR(blade.momenta().momentum[2] / (mass * v), 1., 1e-13);
      EXPECT_NEAR(blade.energies().contact_work / (0.5 * mass * v * v), 1., 1e-13);
      EXPECT_NEAR(blade.energies().kinetic / (0.5 * mass * v * v), 1., 1e-13);
    }

    // Contact may sub-cycle within the blade's step (r-RESPA): works booked in its own kicks still close the balance,
    // to second order in the step. The force here rises and falls within forty steps of the blade, four sub-steps each.
    TEST(ShellBlade, SubcycledContactClosesTheBalance)
    {
      ThreadPool   pool;
      ShellBlade   blade(elastic_plate(14, 4), pool);
      const auto   facets = blade.facets();
      const double step = 0.5 * blade.step_limit().value, sub_step = 0.25 * step, duration = 40. * step;
      double       time = 0.;
      const auto   push = [&] {
        const NodeForces forces = blade.clear_contact_forces();
        const double     phase  = std::min(time / duration, 1.);
        for (std::size_t n = 0; n < facets.n_nodes; ++n)
          if (facets.position[3 * n] > 0.2)
            forces.of(n)[2] = 100. * std::pow(std::sin(M_PI * phase), 2);
      };
      for (unsigned int k = 0; k < 500; ++k)
        {
          blade.kick_internal(0.5 * step, HalfKick::first);
          for (unsigned int j = 0; j < 4; ++j)
            {
              blade.kick_contact(0.5 * sub_step, HalfKick::first);
              blade.drift(sub_step);
              time += sub_step;
              push();
              blade.kick_contact(0.5 * sub_step, HalfKick::second);
            }
          blade.compute_internal_forces();
          blade.kick_internal(0.5 * step, HalfKick::second);
        }
      const auto energy = blade.energies();
      EXPECT_GT(energy.contact_work, 0.01);
      RecordProperty("relative_error", std::to_string(balance(blade) / energy.contact_work));
      EXPECT_LT(std::abs(balance(blade)), 1e-3 * energy.contact_work);
    }

    // Benchmark F10: mirror symmetry about the mid-chord plane after a thousand steps.
    TEST(ShellBlade, KeepsSymmetry)
    {
      ThreadPool pool;
      auto       p             = elastic_plate(8, 4);
      p.loads.initial_velocity = "0; 0; 50*(x/0.3112)^2*(1 + (y/0.05)^2)";
      ShellBlade blade(p, pool);
      advance(blade, 0.8 * blade.step_limit().value, 1000);
      const auto tip = blade.tip_deflection();
      EXPECT_GT(std::abs(tip.leading), 1e-3);
      EXPECT_NEAR(tip.leading, tip.trailing, 1e-10);
    }

    // Benchmark F11: a uniform velocity added to everything changes nothing but the momentum.
    TEST(ShellBlade, IsGalileanInvariant)
    {
      ThreadPool pool;
      const auto run = [&](const std::string &velocity, const double dt, std::vector<double> &u) {
        auto p                   = free_plate(6, 3);
        p.loads.initial_velocity = velocity;
        ShellBlade blade(p, pool);
        advance(blade, dt, 500);
        const auto nodes = blade.nodes();
        u.assign(nodes.displacement, nodes.displacement + 6 * nodes.n);
      };
      const double        dt = 2e-6;
      std::vector<double> at_rest, moving;
      run("0; 0; 40*sin(20*x+30*y)", dt, at_rest);
      run("500; -300; 200 + 40*sin(20*x+30*y)", dt, moving);
      const double frame[3] = {500., -300., 200.};
      double       largest = 0., difference = 0.;
      for (std::size_t i = 0; i < at_rest.size(); ++i)
        {
          const double carried = i % 6 < 3 ? frame[i % 6] * dt * 500 : 0.;
          largest              = std::max(largest, std::abs(at_rest[i]));
          difference           = std::max(difference, std::abs(moving[i] - carried - at_rest[i]));
        }
      EXPECT_LT(difference, 1e-9 * largest);
    }

    // Benchmark F15.
    TEST(ShellBlade, IsBitwiseEqualForAnyNumberOfThreads)
    {
      const auto p = elastic_plate(120, 70); // more nodes than one thread takes
      EXPECT_TRUE(test::is_bitwise_equal(test::shake<ShellBlade>(p, 1), test::shake<ShellBlade>(p, 2)));
    }

    // Static tip load, by damping: a beam bends by w = F L^3/(3 EI) = F / 6533.5 N/m. A plate whose clamped edge cannot
    // contract is stiffer, in its first mode by (36.863/36.099)^2 (benchmark A4), nearly the static shape: 1 %.
    // Root forces follow from equilibrium alone: F, F L, 0; the rest is what relaxation has left.
    TEST(ShellBlade, RelaxesToTheStaticSolution)
    {
      ThreadPool pool;
      auto       p        = elastic_plate(14, 4);
      p.loads.point_loads = "0.3112 0 0: 0; 0; 1";
      p.loads.damping     = 400.;
      p.probes            = "tip: 0.3112 0 0; middle: 0.15 0 0";
      ShellBlade blade(p, pool);
      advance(blade, 0.9 * blade.step_limit().value, 15000);
      const auto root = blade.root_section();
      EXPECT_NEAR(blade.tip_deflection().mid_chord * 6533.5, std::pow(36.099 / 36.863, 2), 0.01);
      EXPECT_NEAR(blade.probes()[0].displacement[2], blade.tip_deflection().mid_chord, 1e-18);
      EXPECT_NEAR(root.transverse_force, 1., 1e-3);
      EXPECT_NEAR(root.bending_moment / 0.3112, 1., 1e-3);
      EXPECT_NEAR(root.normal_force, 0., 1e-3);
      // Equilibrium again: the mean over the chord of the stress, half an element from the root, is M y / I at the
      // outermost of the points through the thickness.
      const double outermost =
        make_thickness_points(p.element.rule, p.element.n_points).position[p.element.n_points - 1];
      const double face = outermost * 6. * (0.3112 - 0.5 * 0.3112 / 14) / (0.0889 * 0.00427 * 0.00427);
      double       mean = 0.;
      for (const double s : root.stress_struck)
        mean += s / root.stress_struck.size();
      ASSERT_EQ(root.stress_struck.size(), 4u);
      EXPECT_NEAR(mean / face, 1., 2e-3);
      EXPECT_NEAR(root.stress_rear[1], -root.stress_struck[1], 1e-3 * face);
      EXPECT_LT(root.chord_position[0], root.chord_position[3]);
    }

    TEST(ShellBlade, ShowsItsFields)
    {
      ThreadPool pool;
      ShellBlade blade(elastic_plate(4, 2), pool);
      const auto snapshot = blade.snapshot();
      EXPECT_EQ(snapshot.points.size(), 3 * blade.n_nodes());
      EXPECT_EQ(snapshot.cells.size(), 4 * blade.n_elements());
      for (const auto &field : snapshot.fields)
        EXPECT_EQ(field.values.size(), field.n_components * (field.on_cells ? blade.n_elements() : blade.n_nodes()))
          << field.name;
      const auto census = blade.census();
      EXPECT_EQ(census.n_held_dofs, 18u);
      EXPECT_NEAR(census.area, 0.3112 * 0.0889, 1e-15);
      EXPECT_NEAR(census.smallest_edge, 0.0889 / 2., 1e-15);
    }

    TEST(ShellBlade, RefusesBadInput)
    {
      ThreadPool pool;
      const auto refuses = [&](const auto &change) {
        auto p = elastic_plate(4, 2);
        change(p);
        EXPECT_THROW(make_blade(p, pool), InputError);
      };
      refuses([](auto &p) { p.supports.clamped = "7"; });
      refuses([](auto &p) { p.supports.hub = "9"; });
      refuses([](auto &p) { p.supports.free = "4"; });
      refuses([](auto &p) { p.supports.tip = "5"; });
      refuses([](auto &p) { p.supports.clamped = "rot"; });
      refuses([](auto &p) { p.supports.held = "1: ux uq"; });
      refuses([](auto &p) { p.supports.held = "1 ux"; });
      refuses([](auto &p) { p.supports.held_boxes = "1 1 1 2 2 2: ux"; });
      refuses([](auto &p) { p.supports.held_boxes = "1 1 1: ux"; });
      refuses([](auto &p) { p.thickness.value = "-0.001"; });
      refuses([](auto &p) { p.thickness.value = "0.004*("; });
      refuses([](auto &p) { p.loads.pressure = "1e5*q"; });
      refuses([](auto &p) { p.loads.initial_velocity = "1; 2"; });
      refuses([](auto &p) { p.loads.initial_spin = "0; 0; 100"; }); // of a clamped blade
      refuses([](auto &p) { p.loads.point_loads = "5 5 5: 1; 1; 1"; });
      refuses([](auto &p) { p.probes = "tip 0 0 0"; });
      refuses([](auto &p) { p.element.n_points = 4; });
      refuses([](auto &p) { p.mesh.generator = MeshGenerator::file; });
    }

    // Held at x = 0 in all but what the spin about y makes of them, nothing stands against it.
    TEST(ShellBlade, SpinsAboutAHinge)
    {
      ThreadPool pool;
      auto       p         = elastic_plate(4, 2);
      p.supports.clamped   = "";
      p.supports.held      = "0: ux uy uz rx rz";
      p.loads.initial_spin = "0; 100; 0";
      EXPECT_NO_THROW(make_blade(p, pool));
      p.loads.initial_spin = "0; 0; 100";
      EXPECT_THROW(make_blade(p, pool), InputError) << "which rz is held against";
    }

    TEST(MakeBlade, GivesWhatWasAskedFor)
    {
      ThreadPool pool;
      auto       p = elastic_plate(4, 2);
      EXPECT_EQ(make_blade(p, pool)->kind(), BladeKind::shell);
      p.kind = BladeKind::solid;
      EXPECT_EQ(make_blade(p, pool)->kind(), BladeKind::solid);
      p.kind = BladeKind::rigid;
      EXPECT_EQ(make_blade(p, pool)->kind(), BladeKind::rigid);
      p.kind = BladeKind::none;
      EXPECT_EQ(make_blade(p, pool), nullptr);
    }
  } // namespace
} // namespace birdstrike::shell_blade_test
