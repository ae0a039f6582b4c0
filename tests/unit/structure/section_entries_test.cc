#include "blade_case.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

// What entries of sections do to a blade, and what is refused.
namespace birdstrike::section_entries_test
{
  namespace
  {
    /// Two sections, one for either half of the chord: the first is the plate's own.
    BladeParameters sheathed(const BladeKind kind = BladeKind::shell)
    {
      BladeParameters p          = test::elastic_plate(14, 6);
      p.kind                     = kind;
      p.mesh.material_boxes      = "0 -1 -1 1 -0.001 1: 7";
      p.sections[1].material_ids = "7";
      return p;
    }

    std::vector<double> field(const Blade &blade, const std::string &name)
    {
      for (const Field &each : blade.snapshot().fields)
        if (each.name == name)
          return each.values;
      return {};
    }

    TEST(SectionEntries, ThicknessIsOfItsCellsAndTheFieldSaysWhose)
    {
      BladeParameters p       = sheathed();
      p.thickness.by_material = "7: 0.009"; // the section's own goes before
      p.sections[1].thickness = "0.002 + 0.001*x/0.3112";
      ThreadPool pool;
      const auto blade = make_blade(p, pool);
      EXPECT_NEAR(blade->mass() / (4430. * 0.3112 * 0.5 * 0.0889 * (0.0025 + 0.00427)), 1., 1e-12);
      const auto section = field(*blade, "section"), thickness = field(*blade, "thickness");
      EXPECT_EQ(std::count(section.begin(), section.end(), 2.), 42);
      EXPECT_EQ(std::count(section.begin(), section.end(), 0.), 42);
      for (std::size_t e = 0; e < section.size(); ++e)
        EXPECT_TRUE(section[e] == 2. ? thickness[e] < 0.003 : std::abs(thickness[e] - 0.00427) < 1e-15) << e;
    }

    // All ids have a section: the blade's own has no element, and is none.
    TEST(SectionEntries, MayLeaveNothingToTheBladesOwn)
    {
      BladeParameters p              = sheathed();
      p.sections[0].material_ids     = "0";
      p.sections[0].material         = p.material;
      p.sections[0].material.density = "1000";
      p.material.density             = "1e5";
      p.sections[1].material         = p.sections[0].material;
      p.sections[1].material.density = "2000";
      ThreadPool pool;
      const auto blade = make_blade(p, pool);
      EXPECT_NEAR(blade->mass() / (1500. * 0.3112 * 0.0889 * 0.00427), 1., 1e-12);
      const auto census = blade->census();
      ASSERT_EQ(census.sections.size(), 2u);
      EXPECT_EQ(census.sections[0].number, 1u);
      EXPECT_NEAR(census.sections[1].mass / census.sections[0].mass, 2., 1e-12);
    }

    // Bricks of one point beside solid-shells in one layer; points and formulations of shells. The plate swings without
    // losing energy: 1e-3 of it at 0.8 of the stable step, as with one section.
    TEST(SectionEntries, FormulationsStandSideBySide)
    {
      for (const ElementFormulation &formulation :
           {ElementFormulation(ShellFormulation::fully_integrated),
            ElementFormulation(ShellFormulation::belytschko_tsay), ElementFormulation(SolidFormulation::one_point),
            ElementFormulation(SolidFormulation::b_bar)})
        {
          BladeParameters p =
            sheathed(std::holds_alternative<ShellFormulation>(formulation) ? BladeKind::shell : BladeKind::solid);
          p.sections[1].formulation  = formulation;
          p.element.linear_viscosity = p.element.quadratic_viscosity = 0.;
          p.loads.initial_velocity                                   = "0; 0; 20*(x/0.3112)^2 + 30*x*y";
          ThreadPool   pool;
          const auto   blade  = make_blade(p, pool);
          const double before = test::balance(*blade);
          test::advance(*blade, 0.8 * blade->step_limit().value, 500);
          EXPECT_NEAR(test::balance(*blade) / before, 1., 1e-3) << element_formulations().name(formulation);
        }
    }

    TEST(SectionEntries, TheRootsStressIsLimitedByTheMetalThere)
    {
      for (const BladeKind kind : {BladeKind::shell, BladeKind::solid})
        {
          BladeParameters p            = sheathed(kind);
          p.material.hardening         = "perfect";
          p.material.yield             = "1e9";
          p.sections[1].material       = p.material;
          p.sections[1].material.yield = "20e6";
          p.loads.initial_velocity     = "0; 0; 20*(x/0.3112)^2";
          ThreadPool pool;
          const auto blade = make_blade(p, pool);
          double     soft = 0., hard = 0.;
          for (int k = 0; k < 80; ++k)
            {
              test::advance(*blade, 0.8 * blade->step_limit().value, 10);
              const auto root = blade->root_section();
              for (std::size_t e = 0; e < root.chord_position.size(); ++e)
                (root.chord_position[e] < 0. ? soft : hard) =
                  std::max(root.chord_position[e] < 0. ? soft : hard, std::abs(root.stress_struck[e]));
            }
          EXPECT_GT(soft, 15e6);
          // plane strain carries 2/sqrt(3) of the yield stress; pressure on faces of bricks, which is free, adds 1 %
          EXPECT_LT(soft, 20e6 * 2. / std::sqrt(3.) * 1.02);
          EXPECT_GT(hard, 40e6);
        }
    }

    // Only the metal that can fail does, and what is left keeps the balance.
    TEST(SectionEntries, AMetalThatFailsBesideOneThatCannot)
    {
      for (const BladeKind kind : {BladeKind::shell, BladeKind::solid})
        {
          BladeParameters p  = sheathed(kind);
          p.material.name    = "Al 2024 Johnson-Cook";
          p.material.density = p.material.young = p.material.poisson = p.material.hardening = "table";
          p.sections[1].material                                                            = p.material;
          p.sections[1].material.failure.law            = FailureLaw::plastic_strain;
          p.sections[1].material.failure.plastic_strain = 0.02;
          p.loads.initial_velocity                      = "150 * min(1, max(0, x/0.05 - 2)); 0; 0";
          ThreadPool pool;
          const auto blade = make_blade(p, pool);
          EXPECT_TRUE(blade->failure().can_fail);
          const double before = test::balance(*blade), momentum = blade->momenta().momentum[0];
          for (int k = 0; k < 600; ++k)
            test::advance(*blade, 0.3 * blade->largest_stable_step(), 1);
          const auto n_failed = blade->failure().n_elements;
          EXPECT_GT(n_failed, 0u);
          EXPECT_GT(find_largest(blade->peak_plastic_strains()).value, 0.02);
          const auto section = field(*blade, "section"), damage = field(*blade, "damage");
          EXPECT_EQ(std::count(section.begin(), section.end(), 0.), 42) << "none of the other metal";
          EXPECT_EQ(std::count(section.begin(), section.end(), 2.), 42 - static_cast<std::ptrdiff_t>(n_failed));
          for (std::size_t e = 0; e < section.size(); ++e)
            EXPECT_TRUE(section[e] == 2. || damage[e] == 0.);
          EXPECT_EQ(blade->facets().n_facets > 0, true);
          const auto m = blade->momenta();
          EXPECT_NEAR(m.momentum[0] + m.support_impulse[0], momentum, 1e-12 * momentum);
          EXPECT_NEAR(test::balance(*blade) / before, 1., 2e-3);
        }
    }

    TEST(SectionEntries, AHalfHasTheBoxesOfBothSides)
    {
      for (const BladeKind kind : {BladeKind::shell, BladeKind::solid})
        {
          BladeParameters p              = sheathed(kind);
          p.mesh.material_boxes          = "0 -1 -1 1 -0.03 1: 7; 0 0.03 -1 1 1 1: 7";
          p.sections[1].material         = p.material;
          p.sections[1].material.density = "9000";
          ThreadPool   pool;
          const double whole = make_blade(p, pool)->mass();
          EXPECT_NEAR(whole / (0.3112 * 0.0889 * 0.00427 * (9000. + 2. * 4430.) / 3.), 1., 1e-12);
          p.is_halved = true;
          EXPECT_NEAR(make_blade(p, pool)->mass() / whole, 1., 1e-13);
          p.mesh.material_boxes = "0 0.03 -1 1 1 1: 7";
          EXPECT_THROW(make_blade(p, pool), InputError);
        }
    }

    TEST(SectionEntries, RefuseInWords)
    {
      struct Row
      {
        std::string                            names;
        std::function<void(BladeParameters &)> change;
        BladeKind                              kind = BladeKind::shell;
      };
      const BladeKind        solid   = BladeKind::solid;
      const std::vector<Row> refused = {
        {"Section 1/Material ids: no cell", [](auto &p) { p.sections[0].material_ids = "3"; }},
        {"Section 2/Material ids: the material id 7 has been named", [](auto &p) { p.sections[0].material_ids = "7"; }},
        {"Section 2/Material ids: the mesh has no material 'tip'", [](auto &p) { p.sections[1].material_ids = "tip"; }},
        {"box '5 5 5 6 6 6'", [](auto &p) { p.mesh.material_boxes += "; 5 5 5 6 6 6: 7"; }},
        {"box '0 0 0 1 1 1' has the ids '7, 8'", [](auto &p) { p.mesh.material_boxes = "0 0 0 1 1 1: 7, 8"; }},
        {"Mesh/Material boxes: cannot read '0 0 0 1'", [](auto &p) { p.mesh.material_boxes = "0 0 0 1: 7"; }},
        {"Section 2/Material: entries are set, but no Name", [](auto &p) { p.sections[1].material.young = "70e9"; }},
        {"Section 2/Material/Density: 'heavy'",
         [](auto &p) {
           p.sections[1].material         = p.material;
           p.sections[1].material.density = "heavy";
         }},
        {"Section 2/Formulation: 'B-bar' is no element of a shell",
         [](auto &p) { p.sections[1].formulation = SolidFormulation::b_bar; }},
        {"Section 2/Formulation: 'physical' is no element of a solid",
         [](auto &p) { p.sections[1].formulation = ShellFormulation::one_point_physical; }, solid},
        {"Section 2/Points through thickness: 4", [](auto &p) { p.sections[1].n_points = 4; }},
        {"Section 2/Thickness: bricks", [](auto &p) { p.sections[1].thickness = "0.003"; }, solid},
        {"Section 2/Thickness: the thickness at", [](auto &p) { p.sections[1].thickness = "0"; }},
        {"Section 2/Material/Failure is not there for solid-shells",
         [](auto &p) {
           p.element.formulation              = SolidFormulation::solid_shell;
           p.sections[1].material.name        = "Al 2024 Johnson-Cook";
           p.sections[1].material.failure.law = FailureLaw::plastic_strain;
         },
         solid},
        {"Section 2/Material/Failure to none",
         [](auto &p) {
           p.mass_scaling.method              = MassScalingMethod::selective;
           p.sections[1].material.name        = "Al 2024 Johnson-Cook";
           p.sections[1].material.failure.law = FailureLaw::plastic_strain;
         },
         solid},
        {"a rigid surface has no elements", [](auto &p) { p.kind = BladeKind::rigid; }},
      };
      ThreadPool pool;
      EXPECT_NO_THROW(make_blade(sheathed(), pool));
      EXPECT_NO_THROW(make_blade(sheathed(solid), pool));
      for (const Row &row : refused)
        {
          BladeParameters p = sheathed(row.kind);
          row.change(p);
          try
            {
              make_blade(p, pool);
              ADD_FAILURE() << "not refused: " << row.names;
            }
          catch (const InputError &error)
            {
              EXPECT_NE(std::string(error.what()).find(row.names), std::string::npos) << row.names << "\n"
                                                                                      << error.what();
            }
        }
    }

    TEST(SectionEntries, MeanNothingWhereTheKindHasNoUseForThem)
    {
      BladeParameters p      = sheathed(BladeKind::solid);
      p.element.formulation  = SolidFormulation::one_point;
      p.sections[1].n_points = 7;
      EXPECT_EQ(p.unused_entries(), std::vector<std::string>{"Section 2/Points through thickness"});
      p.sections[1].formulation = SolidFormulation::solid_shell;
      EXPECT_TRUE(p.unused_entries().empty());
    }
  } // namespace
} // namespace birdstrike::section_entries_test
