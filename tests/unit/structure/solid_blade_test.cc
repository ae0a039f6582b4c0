#include "blade_case.h"
#include "solid_frequencies.h"

#include "structure/deformable_blade.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <map>

namespace birdstrike::solid_blade_test
{
  namespace
  {
    using test::advance;
    using test::balance;

    double norm(const std::array<double, 3> &a)
    {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    /// The plate of benchmark A4 in bricks.
    BladeParameters solid_plate(const unsigned int n_span, const unsigned int n_chord, const unsigned int n_layers)
    {
      BladeParameters p = test::elastic_plate(n_span, n_chord);
      p.kind            = BladeKind::solid;
      p.mesh.n_layers   = n_layers;
      return p;
    }

    BladeParameters without_viscosity(BladeParameters p)
    {
      p.element.linear_viscosity = p.element.quadratic_viscosity = 0.;
      return p;
    }

    // The sums of element forces vanish to round-off: a thousand steps leave 1e-12 of the largest momentum around.
    TEST(SolidBlade, FreePlateKeepsItsMomenta)
    {
      ThreadPool pool;
      auto       p             = solid_plate(8, 4, 2);
      p.supports.clamped       = "";
      p.loads.initial_velocity = "3 + 20*sin(30*y); 2 - 8*cos(20*x); 10*sin(12*x+20*y) + 5";
      p.loads.initial_spin     = "20; -30; 10";
      SolidBlade   blade(p, pool);
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

    // Benchmark F2: midpoint strains close the balance; with the bulk viscosity's part, which is booked.
    TEST(SolidBlade, VibratingPlateKeepsItsEnergy)
    {
      for (const double viscosity : {0., 1.})
        {
          ThreadPool pool;
          auto       p = solid_plate(14, 4, 2);
          p.element.linear_viscosity *= viscosity;
          p.element.quadratic_viscosity *= viscosity;
          p.loads.initial_velocity = "0; 0; 30*(x/0.3112)^2 + 100*x*y";
          SolidBlade   blade(p, pool);
          const double initial = balance(blade), dt = 0.9 * blade.step_limit().value;
          double       worst = 0.;
          for (unsigned int k = 0; k < 50; ++k)
            {
              advance(blade, dt, 50);
              worst = std::max(worst, std::abs(balance(blade) / initial - 1.));
            }
          EXPECT_LT(worst, 1e-4) << viscosity;
          EXPECT_EQ(blade.energies().viscous > 0., viscosity > 0.);
        }
    }

    TEST(SolidBlade, SupportsTakeTheImpulse)
    {
      ThreadPool pool;
      auto       p        = solid_plate(8, 4, 2);
      p.loads.pressure    = "1e5*sin(2e3*t)";
      p.loads.point_loads = "0.3112 0 0: 0; 10; 100";
      SolidBlade blade(p, pool);
      advance(blade, 0.8 * blade.step_limit().value, 500);
      const auto m = blade.momenta();
      EXPECT_GT(norm(m.external_impulse), 0.05);
      for (unsigned int d = 0; d < 3; ++d)
        EXPECT_NEAR(m.momentum[d] + m.support_impulse[d], m.external_impulse[d], 1e-12 * norm(m.external_impulse));
    }

    // The same parameters, one word changed: pressure pushes on the face below, along +z as on the shell, and its
    // impulse is p A t; on both faces it cancels.
    TEST(SolidBlade, PressurePushesAsOnTheShell)
    {
      ThreadPool pool;
      for (const auto &[kind, faces, impulse] : {std::tuple("shell", "5", 1.), std::tuple("solid", "5", 1.),
                                                 std::tuple("solid", "6", -1.), std::tuple("solid", "5, 6", 0.)})
        {
          auto p                      = solid_plate(8, 4, 1);
          p.kind                      = blade_kinds().at(kind);
          p.loads.pressure            = "1e4";
          p.loads.pressure_boundaries = faces;
          const auto blade            = make_blade(p, pool);
          advance(*blade, 1e-7, 100);
          const double unit = 1e4 * 0.3112 * 0.0889 * 1e-5;
          EXPECT_NEAR(blade->momenta().external_impulse[2] / unit, impulse, 1e-6) << kind << ' ' << faces;
        }
    }

    TEST(SolidBlade, LoadsAndDampingCloseTheBalance)
    {
      ThreadPool pool;
      auto       p     = solid_plate(14, 4, 2);
      p.loads.pressure = "3e4*(1 - exp(-2e3*t))";
      p.loads.damping  = 400.;
      SolidBlade blade(p, pool);
      advance(blade, 0.9 * blade.step_limit().value, 6000);
      const auto energy = blade.energies();
      EXPECT_GT(energy.damped, 0.05 * energy.external_work);
      EXPECT_LT(std::abs(balance(blade)), 1e-4 * energy.external_work);
    }

    // Contact sees the skin only: n_skin nodes, facets that close, none beyond the surface, outward normals.
    TEST(SolidBlade, OffersItsSkinToContact)
    {
      ThreadPool pool;
      SolidBlade blade(solid_plate(6, 4, 3), pool);
      const auto view    = blade.facets();
      const auto n_inner = 5u * 3u * 2u;
      EXPECT_EQ(view.n_nodes + n_inner, blade.n_nodes());
      EXPECT_EQ(view.n_facets, 2u * (6u * 4u + 6u * 3u + 4u * 3u));
      EXPECT_FALSE(view.two_sided);
      double volume = 0.;
      for (std::size_t f = 0; f < view.n_facets; ++f)
        {
          const auto x = [&](const unsigned int k) { return Point3(view.position + 3 * view.nodes[f][k]); };
          volume += 0.5 * (x(2) - x(0)).cross(x(3) - x(1)).dot(0.25 * (x(0) + x(1) + x(2) + x(3))) / 3.;
          EXPECT_EQ(view.half_thickness[f], 0.);
          for (unsigned int k = 0; k < 4; ++k)
            EXPECT_GE(view.neighbor[f][k], 0) << "closed";
        }
      EXPECT_NEAR(volume / (0.3112 * 0.0889 * 0.00427), 1., 1e-12); // divergence theorem: all normals point outwards
      blade.clear_contact_forces().of(7)[2] = 5.;
      EXPECT_EQ(blade.contact_force()[2], 5.);
    }

    // Benchmark F15.
    TEST(SolidBlade, IsBitwiseEqualForAnyNumberOfThreads)
    {
      const auto p = solid_plate(60, 36, 2);
      EXPECT_TRUE(test::is_bitwise_equal(test::shake<SolidBlade>(p, 1), test::shake<SolidBlade>(p, 2)));
    }

    // Static tip load by damping, as of the shell: w = F / 6533.5 N/m, stiffer by (36.863/36.099)^2 because the clamped
    // end cannot contract; 2 %, because here nothing at the root may contract through the thickness either. Root forces
    // follow from equilibrium alone; the face stress, half an element from the root, is M y / I in the mean.
    TEST(SolidBlade, RelaxesToTheStaticSolution)
    {
      ThreadPool pool;
      auto       p        = solid_plate(14, 4, 1);
      p.loads.point_loads = "0.3112 0 0.002: 0; 0; 1";
      p.loads.damping     = 400.;
      p.probes            = "tip: 0.3112 0 0.002";
      SolidBlade   blade(p, pool);
      const double dt = 0.9 * blade.step_limit().value;
      advance(blade, dt, static_cast<unsigned int>(0.04 / dt));
      const auto root = blade.root_section();
      EXPECT_NEAR(blade.tip_deflection().mid_chord * 6533.5, std::pow(36.099 / 36.863, 2), 0.02);
      EXPECT_NEAR(blade.probes()[0].displacement[2] / blade.tip_deflection().mid_chord, 1., 1e-3);
      EXPECT_NEAR(root.transverse_force, 1., 2e-3);
      EXPECT_NEAR(root.bending_moment / 0.3112, 1., 2e-3);
      EXPECT_NEAR(root.normal_force, 0., 2e-3);
      const double face = 6. * (0.3112 - 0.5 * 0.3112 / 14) / (0.0889 * 0.00427 * 0.00427);
      double       mean = 0.;
      for (const double s : root.stress_struck)
        mean += s / root.stress_struck.size();
      ASSERT_EQ(root.stress_struck.size(), 4u);
      EXPECT_NEAR(mean / face, 1., 0.01);
      RecordProperty("mean_face_stress", std::to_string(mean / face));
      EXPECT_NEAR(root.stress_rear[1], -root.stress_struck[1], 1e-3 * face);
      EXPECT_LT(root.chord_position[0], root.chord_position[3]);
    }

    // Benchmarks A4 and B8: the modes of the plate by Mindlin's theory (converged), which bricks with two layers must
    // meet as the shell's elements do on this mesh: bending 1 %, torsion 3 %.
    TEST(SolidBlade, HasTheFrequenciesOfThePlate)
    {
      ThreadPool pool;
      SolidBlade blade(without_viscosity(solid_plate(28, 8, 2)), pool);
      const auto f = test::natural_frequencies(blade, 4);
      for (unsigned int k = 0; k < 4; ++k)
        RecordProperty("mode_" + std::to_string(k + 1), std::to_string(f[k]));
      EXPECT_NEAR(f[0] / 36.863, 1., 0.01);
      EXPECT_NEAR(f[1] / 230.15, 1., 0.01);
      EXPECT_NEAR(f[2] / 254.00, 1., 0.03);
      EXPECT_NEAR(f[3] / 645.67, 1., 0.01);
    }

    /// A plate that bends along both directions, stretches and yields at the root, symmetrically about y = 0.
    BladeParameters struck_plate(const bool is_halved)
    {
      BladeParameters p        = solid_plate(14, 6, 2);
      p.material.hardening     = "perfect";
      p.is_halved              = is_halved;
      p.loads.pressure         = "-2e6*exp(-(x-0.2)^2/0.001-y^2/0.0005)";
      p.loads.initial_velocity = "-20*x; 300*y; -200*(x/0.3)^2*(1-300*y^2)";
      return p;
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

    TEST(SolidBlade, HalfAPlateMovesLikeTheWhole)
    {
      ThreadPool pool;
      SolidBlade whole(struck_plate(false), pool), half(struck_plate(true), pool);
      EXPECT_EQ(half.n_elements(), whole.n_elements());
      EXPECT_EQ(half.n_nodes(), whole.n_nodes());
      EXPECT_NEAR(half.mass() / whole.mass(), 1., 1e-14);
      const double dt = 0.8 * std::min(whole.step_limit().value, half.step_limit().value);
      advance(whole, dt, 1000);
      advance(half, dt, 1000);
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
      EXPECT_LT(largest, 1e-10 * length);
      EXPECT_GT(half.energies().plastic, 1.);
      EXPECT_NEAR(half.energies().total() / whole.energies().total(), 1., 1e-10);

      const auto w = whole.root_section(), h = half.root_section();
      EXPECT_NEAR(h.bending_moment / w.bending_moment, 1., 1e-9);
      EXPECT_NEAR(h.normal_force / w.normal_force, 1., 1e-9);
      EXPECT_NEAR(h.peak_stress() / w.peak_stress(), 1., 1e-9);
      ASSERT_EQ(h.chord_position.size(), 3u);
      for (unsigned int k = 0; k < 3; ++k)
        EXPECT_NEAR(h.chord_position[k], w.chord_position[3 + k], 1e-12) << "from the middle of the whole section";
      const auto t = whole.tip_deflection(), s = half.tip_deflection();
      EXPECT_NEAR(s.mid_chord / t.mid_chord, 1., 1e-9);
      EXPECT_NEAR(s.leading / t.leading, 1., 1e-9);
      EXPECT_NEAR(s.trailing / t.trailing, 1., 1e-9);
    }

    TEST(SolidBlade, ShowsItsFields)
    {
      ThreadPool pool;
      SolidBlade blade(solid_plate(4, 2, 2), pool);
      const auto snapshot = blade.snapshot();
      EXPECT_EQ(snapshot.dim, 3u);
      EXPECT_EQ(snapshot.points.size(), 3 * blade.n_nodes());
      EXPECT_EQ(snapshot.cells.size(), 8 * blade.n_elements());
      for (const auto &field : snapshot.fields)
        EXPECT_EQ(field.values.size(), field.n_components * (field.on_cells ? blade.n_elements() : blade.n_nodes()))
          << field.name;
      const auto census = blade.census();
      EXPECT_EQ(census.n_held_dofs, 27u);
      EXPECT_NEAR(census.area, 2. * (0.3112 * 0.0889 + 0.3112 * 0.00427 + 0.0889 * 0.00427), 1e-15);
      EXPECT_NEAR(census.smallest_edge, 0.00427 / 2., 1e-15);
      EXPECT_NEAR(census.mass, 4430. * 0.3112 * 0.0889 * 0.00427, 1e-12);
    }

    TEST(SolidBlade, RefusesBadInput)
    {
      ThreadPool pool;
      const auto refuses = [&](const auto &change) {
        auto p = solid_plate(4, 2, 1);
        change(p);
        EXPECT_THROW(make_blade(p, pool), InputError);
      };
      EXPECT_NO_THROW(make_blade(solid_plate(4, 2, 1), pool));
      refuses([](auto &p) { p.element.formulation = ShellFormulation::one_point_physical; });
      refuses([](auto &p) { p.element.formulation = ShellFormulation::belytschko_tsay; });
      refuses([](auto &p) {
        p.kind                = BladeKind::shell;
        p.element.formulation = SolidFormulation::b_bar;
      });
      refuses([](auto &p) { p.supports.clamped = "7"; });
      refuses([](auto &p) { p.supports.held = "1: rx"; });
      refuses([](auto &p) { p.supports.held_boxes = "0 -1 -1 1 1 1: uz ry"; });
      refuses([](auto &p) { p.loads.point_loads = "0.3112 0 0: 1; 1; 1; 1; 1; 1"; });
      refuses([](auto &p) {
        p.loads.pressure            = "1e5";
        p.loads.pressure_boundaries = "9";
      });
      refuses([](auto &p) { p.thickness.value = "-0.001"; });
      refuses([](auto &p) { p.material.failure.law = FailureLaw::plastic_strain; }); // of shells alone, as yet
    }

    // One file may hold the entries of both kinds: those of the other are named, not refused.
    TEST(SolidBlade, AutomaticIsTheSolidShellWhereItCan)
    {
      BladeParameters p    = solid_plate(4, 2, 1);
      p.material.hardening = "perfect";
      EXPECT_EQ(p.solid_formulation(1), SolidFormulation::solid_shell);
      EXPECT_EQ(p.solid_formulation(2), SolidFormulation::one_point) << "the layers resolve the thickness";
      p.material.failure.law = FailureLaw::plastic_strain;
      EXPECT_EQ(p.solid_formulation(1), SolidFormulation::one_point) << "solid-shells do not fail";
      p.element.formulation = SolidFormulation::solid_shell;
      ThreadPool pool;
      EXPECT_THROW(make_blade(p, pool), InputError);
    }

    TEST(SolidBlade, NamesEntriesThatMeanNothingForIt)
    {
      BladeParameters p = solid_plate(4, 2, 2);
      EXPECT_TRUE(p.unused_entries().empty());
      p.element.n_points         = 9;
      p.element.linear_viscosity = 0.1;
      EXPECT_EQ(p.unused_entries(), std::vector<std::string>{"Element/Points through thickness"});
      p.mesh.n_layers = 1;
      EXPECT_TRUE(p.unused_entries().empty()) << "one layer: solid-shells";
      p.kind = BladeKind::shell;
      EXPECT_EQ(p.unused_entries(), std::vector<std::string>{"Element/Linear viscosity"});
    }
  } // namespace
} // namespace birdstrike::solid_blade_test
