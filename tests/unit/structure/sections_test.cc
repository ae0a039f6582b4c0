#include "blade_case.h"
#include "solid_frequencies.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

// Sections by material id, in whole blades.
namespace birdstrike::sections_test
{
  namespace
  {
    constexpr BladeKind both_kinds[] = {BladeKind::shell, BladeKind::solid};
    constexpr double    length = 0.3112, chord = 0.0889, thickness = 0.00427;

    const std::string near_root = "0 -1 -1 0.15 1 1: 7", one_edge = "0 -1 -1 1 -0.001 1: 7";

    /// The elastic plate whose cells in the boxes have a section of their own.
    BladeParameters two_sections(const BladeKind kind, const std::string &boxes = near_root)
    {
      BladeParameters p          = test::elastic_plate(14, 6);
      p.kind                     = kind;
      p.mesh.material_boxes      = boxes;
      p.sections[1].material_ids = "7";
      return p;
    }

    /// Two metals without lateral strain; the section's is denser and softer, waves are slower by 2.2.
    BladeParameters two_metals(const BladeKind kind, const std::string &boxes)
    {
      BladeParameters p              = two_sections(kind, boxes);
      p.material.poisson             = "0";
      p.sections[1].material         = p.material;
      p.sections[1].material.young   = "50e9";
      p.sections[1].material.density = "9000";
      return p;
    }

    void advance_to(Blade &blade, const double time)
    {
      const auto n = static_cast<unsigned int>(std::ceil(time / (0.9 * blade.largest_stable_step())));
      test::advance(blade, time / n, n);
    }

    std::vector<double> velocities(Blade &blade, const double dt, const unsigned int n_steps)
    {
      test::advance(blade, dt, n_steps);
      for (const Field &field : blade.snapshot().fields)
        if (field.name == "velocity")
          return field.values;
      return {};
    }

    /// Every lane of a batch does what it would in another, and forces add up in the order of the mesh: to the last
    /// bit. Energies are sums over chunks, which are others: round-off.
    template <class AnyBlade>
    void expect_as_one_section(const BladeKind kind)
    {
      BladeParameters one     = two_sections(kind);
      one.mesh.material_boxes = one.sections[1].material_ids = "";
      const auto                a = test::shake<AnyBlade>(one, 1), b = test::shake<AnyBlade>(two_sections(kind), 2);
      constexpr std::ptrdiff_t  n_energies = 9;
      const std::vector<double> v(a.begin(), a.end() - n_energies), w(b.begin(), b.end() - n_energies);
      EXPECT_TRUE(test::is_bitwise_equal(v, w));
      for (std::size_t k = v.size(); k < a.size(); ++k)
        EXPECT_NEAR(b[k], a[k], 1e-12 * (std::abs(a[k]) + 1e-3));
    }

    TEST(Sections, AThicknessOfNoCellIsRefused)
    {
      BladeParameters p       = test::elastic_plate(6, 2);
      p.mesh.material_boxes   = "0 -1 -1 0.15 1 1: 1";
      p.thickness.by_material = "1: 8e-3";
      ThreadPool   pool;
      const double mass = make_blade(p, pool)->mass();
      EXPECT_NEAR(mass, 4430. * 0.3112 * 0.0889 * (0.5 * 8e-3 + 0.5 * 0.00427), 1e-9 * mass);
      p.thickness.by_material = "7: 8e-3";
      EXPECT_THROW(make_blade(p, pool), InputError);
    }

    TEST(Sections, TwoOfOneMetalAreAsOne)
    {
      expect_as_one_section<ShellBlade>(BladeKind::shell);
      expect_as_one_section<SolidBlade>(BladeKind::solid);
    }

    // An element that is elastic takes the path of points where one of its batch has yielded, and batches are others:
    // round-off, which 200 steps keep below 1e-9 of the largest velocity.
    TEST(Sections, TwoOfOneMetalFlowAsOne)
    {
      for (const BladeKind kind : both_kinds)
        {
          BladeParameters two          = two_sections(kind);
          two.material.hardening       = "perfect";
          two.material.yield           = "20e6";
          two.loads.initial_velocity   = "0; 0; 60*(x/0.3112)^2 + 30*x*y";
          BladeParameters one          = two;
          one.sections[1].material_ids = "";
          ThreadPool   pool;
          const auto   a = make_blade(one, pool), b = make_blade(two, pool);
          const double dt = 0.8 * a->step_limit().value;
          EXPECT_EQ(b->step_limit().value, a->step_limit().value);
          const auto v = velocities(*a, dt, 200), w = velocities(*b, dt, 200);
          ASSERT_EQ(v.size(), w.size());
          for (std::size_t k = 0; k < v.size(); ++k)
            EXPECT_NEAR(w[k], v[k], 1e-9 * 60.);
          EXPECT_GT(a->energies().plastic, 0.01);
          const auto sections = b->census().sections;
          ASSERT_EQ(sections.size(), 2u);
          EXPECT_EQ(sections[0].number, 0u);
          EXPECT_EQ(sections[1].number, 2u);
          EXPECT_EQ(sections[0].n_elements + sections[1].n_elements, 84u);
          EXPECT_NEAR((sections[0].plastic_work + sections[1].plastic_work) / a->energies().plastic, 1., 1e-9);
          EXPECT_TRUE(a->census().sections.empty());
        }
    }

    // A bar of two metals in a row under a force F at its end: mass A (rho_1 L_1 + rho_2 L_2), extension F/A (L_1/E_1 +
    // L_2/E_2). Elements hold both exactly; the damping leaves e^-80 of the motion, strains are 2e-6.
    TEST(Sections, TwoMetalsInARowStretchAsSprings)
    {
      for (const BladeKind kind : both_kinds)
        {
          BladeParameters p   = two_metals(kind, near_root);
          p.loads.damping     = 2e4; // 1/s
          const bool is_solid = kind == BladeKind::solid;
          for (int k = 0; k <= 6; ++k)
            for (const char *z :
                 is_solid ? std::vector<const char *>{"-0.002135", "0.002135"} : std::vector<const char *>{"0"})
              p.loads.point_loads += (p.loads.point_loads.empty() ? "0.3112 " : " | 0.3112 ") +
                                     std::to_string(chord * (k / 6. - 0.5)) + " " + z + ": " +
                                     std::to_string((k % 6 == 0 ? 2. : 4.) / (is_solid ? 2. : 1.)) + "; 0; 0";
          p.probes = "tip: 0.3112 0 0";
          ThreadPool   pool;
          const auto   blade = make_blade(p, pool);
          const double area = chord * thickness, half = 0.5 * length;
          EXPECT_NEAR(blade->mass() / (area * half * (9000. + 4430.)), 1., 1e-12);
          advance_to(*blade, 8e-3);
          const double expected = 24. / area * half * (1. / 50e9 + 1. / 113.8e9);
          EXPECT_NEAR(blade->probes()[0].displacement[0] / expected, 1., 3e-6);
          EXPECT_LT(std::abs(test::balance(*blade)), 3e-6 * blade->energies().external_work);
        }
    }

    // Side by side and stretched by the same strain e, they carry the rule of mixtures, (E_1 A_1 + E_2 A_2) e, and
    // store half of it times the extension; with nu = 0 nothing else strains.
    TEST(Sections, TwoMetalsSideBySideStretchByTheRuleOfMixtures)
    {
      for (const BladeKind kind : both_kinds)
        {
          BladeParameters p = two_metals(kind, one_edge);
          p.supports.driven = "1: ux = 1e-7*if(t<4e-4, (1-cos(pi*t/4e-4))/2, 1)";
          p.loads.damping   = 2e4;
          ThreadPool pool;
          const auto blade = make_blade(p, pool);
          advance_to(*blade, 8e-3);
          const double stiffness = 0.5 * chord * thickness * (50e9 + 113.8e9) / length;
          EXPECT_NEAR(blade->root_section().normal_force / (1e-7 * stiffness), 1., 1e-6);
          EXPECT_NEAR(blade->energies().elastic / (0.5e-14 * stiffness), 1., 1e-6);
        }
    }

    // The first bending frequency of a narrow cantilever of strips along its span, edges of one metal and the middle
    // of another, is Euler and Bernoulli's of the composite section, 1.8751^2/(2 pi L^2) sqrt(sum E I / sum rho A): its
    // chord stays straight, although alone the strips would differ by 2.2. 14 x 6 elements: 0.4 % as a plate of one
    // metal, shear (t/L)^2 = 2e-4.
    template <class AnyBlade>
    double first_frequency(const BladeKind kind)
    {
      BladeParameters p          = two_metals(kind, "0 -1 -1 1 -0.005 1: 7; 0 0.005 -1 1 1 1: 7");
      p.mesh.chord               = 0.03;
      p.element.linear_viscosity = p.element.quadratic_viscosity = 0.;
      ThreadPool pool;
      AnyBlade   blade(p, pool);
      return test::natural_frequencies(blade, 1)[0];
    }

    TEST(Sections, StripsOfTwoMetalsBendAsACompositeBeam)
    {
      const double inertia = thickness * thickness * thickness / 12.;
      const double expected =
        1.8751 * 1.8751 / (2. * M_PI * length * length) *
        std::sqrt(inertia * (0.02 * 50e9 + 0.01 * 113.8e9) / (thickness * (0.02 * 9000. + 0.01 * 4430.)));
      EXPECT_NEAR(first_frequency<ShellBlade>(BladeKind::shell) / expected, 1., 5e-3);
      EXPECT_NEAR(first_frequency<SolidBlade>(BladeKind::solid) / expected, 1., 5e-3);
    }

    // d'Alembert at the interface of two bars: of a wave of velocity v, 2 z_1/(z_1 + z_2) v goes through and stress z_1
    // v becomes 2 z_2/(z_1 + z_2) of itself, z = rho c the impedances. The rise is 18 elements long: dispersion of 2 %.
    TEST(Sections, AWaveGoesThroughTheInterfaceOfTwoMetals)
    {
      for (const BladeKind kind : both_kinds)
        {
          BladeParameters p  = two_metals(kind, "0.15 -1 -1 1 1 1: 7");
          p.mesh.n_span      = 120;
          p.mesh.n_chord     = 1;
          p.supports.clamped = "";
          p.supports.driven  = "0: ux = 10*if(t<2e-5, t/2 - 2e-5/(2*pi)*sin(pi*t/2e-5), t - 1e-5)";
          p.probes           = "before: 0.1 0 0; behind: 0.18 0 0";
          ThreadPool   pool;
          const auto   blade = make_blade(p, pool);
          const double z = std::sqrt(113.8e9 * 4430.), z_behind = std::sqrt(50e9 * 9000.);
          // the end of the rise is behind both probes at 62 us, what the root reflects comes back at 80 us
          advance_to(*blade, 70e-6);
          EXPECT_NEAR(blade->probes()[1].velocity[0] / (10. * 2. * z / (z + z_behind)), 1., 2e-2);
          EXPECT_NEAR(blade->probes()[0].velocity[0] / (10. * 2. * z / (z + z_behind)), 1., 2e-2);
        }
    }
  } // namespace
} // namespace birdstrike::sections_test
