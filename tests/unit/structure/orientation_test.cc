#include "oriented_strike.h"
#include "structure/elements/thickness_points.h"

#include <birdstrike/mesh/orientation.h>
#include <birdstrike/structure/make_blade.h>

#include <gtest/gtest.h>

namespace orientation_test
{
  using namespace birdstrike;
  using test::always;
  using test::expect_same;
  using test::Listing;
  using test::mixed;
  using test::mixed_shell;
  using test::PlateFile;
  using test::quadrilateral;
  using test::Reports;
  using test::strike;

  namespace
  {
    constexpr unsigned int                n_span = 14, n_chord = 4;
    constexpr std::array<unsigned int, 3> quadrilaterals{{n_span, n_chord, 0}}, hexahedra{{n_span, n_chord, 2}};

    BladeParameters built_in(const char *kind)
    {
      BladeParameters p = test::elastic_plate(n_span, n_chord);
      p.kind            = blade_kinds().at(kind);
      p.mesh.n_layers   = 2;
      return p;
    }
  } // namespace

  TEST(Orientation, SignsComeFromTheFirstAxisThatCounts)
  {
    EXPECT_EQ(sign_by_axes(Point3(1., 1., -0.5), {{2, 1, 0}}), -1.);
    EXPECT_EQ(sign_by_axes(Point3(-1., 1., -1e-15), {{2, 1, 0}}), 1.) << "round-off is no component";
    EXPECT_EQ(sign_by_axes(Point3(-1., 0., 0.), {{2, 1, 0}}), -1.);
    EXPECT_TRUE(looks_at_strike(Point3(0., 0., 1.), Point3(100., 0., -5.)));
    EXPECT_FALSE(looks_at_strike(Point3(0., 0., -1.), Point3(100., 0., -5.)));
    EXPECT_TRUE(looks_at_strike(Point3(0., 0., -1.), Point3(100., 0., 0.))) << "along the surface: upwards";
    EXPECT_TRUE(looks_at_strike(Point3(0., 0., -1.), Point3::Zero())) << "no bird: upwards";
  }

  // The blade goes where the bird goes: tip and moment are positive, the trailing corner (+y, the faster) is ahead.
  TEST(Orientation, ReportsDoNotDependOnTheSideThatIsStruck)
  {
    const PlateFile shell_file(quadrilaterals, mixed_shell(1)),
      solid_file(hexahedra, mixed(test::rotations_of_a_cube(), 1));
    for (const auto &[name, p] : {std::pair{"shell", built_in("shell")},
                                  {"solid", built_in("solid")},
                                  {"file of a shell", shell_file.parameters()},
                                  {"file of a solid", solid_file.parameters()}})
      {
        const Reports below = strike(p, 1), above = strike(p, -1);
        expect_same(below, above, 1e-6, name);
        EXPECT_GT(below.tip.mid_chord, 1e-3) << name;
        EXPECT_GT(below.tip.trailing, 1.05 * below.tip.leading) << name;
        EXPECT_GT(below.root.bending_moment, 1.) << name;
        EXPECT_GT(below.root.stress_struck[1], 10e6) << name << ": the struck face is stretched";
        EXPECT_LT(below.root.stress_rear[1], -10e6) << name;
        EXPECT_FALSE(below.line.empty()) << name;
        EXPECT_NEAR(below.line.back(), below.tip.mid_chord, 1e-9) << name;
      }
  }

  TEST(Orientation, ReportsDoNotDependOnTheOrderInWhichAFileListsQuadrilaterals)
  {
    const Reports built = strike(built_in("shell"), 1);
    for (const bool is_reversed : {false, true})
      for (const unsigned int first : {0u, 1u, 2u, 3u})
        {
          const PlateFile file(quadrilaterals, always(quadrilateral(is_reversed, first)));
          expect_same(built, strike(file.parameters(), 1), 1e-6,
                      (is_reversed ? "reversed, from corner " : "from corner ") + std::to_string(first));
        }
    for (const unsigned int seed : {1u, 2u, 3u})
      {
        const PlateFile file(quadrilaterals, mixed_shell(seed));
        expect_same(built, strike(file.parameters(), 1), 1e-6, "mixed by seed " + std::to_string(seed));
      }
  }

  // The axes of the one-point brick's stabilisation are its cell's, whose order changes nothing but round-off.
  TEST(Orientation, ReportsDoNotDependOnTheOrderInWhichAFileListsHexahedra)
  {
    const auto rotations = test::rotations_of_a_cube();
    ASSERT_EQ(rotations.size(), 24u);
    BladeParameters p     = built_in("solid");
    p.element.formulation = SolidFormulation::one_point; // what "automatic" is for a file
    const Reports built   = strike(p, 1);
    for (std::size_t k = 0; k < rotations.size(); ++k)
      {
        const PlateFile file(hexahedra, always(rotations[k]));
        expect_same(built, strike(file.parameters(), 1), 1e-6, "rotation " + std::to_string(k));
      }
    for (const unsigned int seed : {1u, 2u, 3u})
      {
        const PlateFile file(hexahedra, mixed(rotations, seed));
        expect_same(built, strike(file.parameters(), 1), 1e-6, "mixed by seed " + std::to_string(seed));
      }
  }

  // Turned in space a blade reports the same, as long as its chord runs towards +y; turned over about its span, the
  // edge that was trailing leads.
  TEST(Orientation, ReportsTurnWithTheBlade)
  {
    using Turn                     = Eigen::AngleAxisd;
    const Matrix3<double> askew    = Turn(0.7, Point3(1., 2., -3.).normalized()).matrix();
    const Matrix3<double> on_edge  = Turn(0.5 * M_PI, Point3::UnitX()).matrix(); // chord towards +z
    const Matrix3<double> upright  = Turn(0.5 * M_PI, Point3::UnitY()).matrix(); // span towards -z
    const Matrix3<double> reversed = Turn(M_PI, Point3::UnitX()).matrix();
    for (const auto &[kind, cells] : {std::pair{"shell", quadrilaterals}, {"solid", hexahedra}})
      for (const int side : {1, -1})
        {
          const auto listing = [&](const unsigned int seed) {
            return cells[2] > 0 ? mixed(test::rotations_of_a_cube(), seed) : mixed_shell(seed);
          };
          const Reports flat = strike(PlateFile(cells, listing(4)).parameters(), side);
          for (const Matrix3<double> &turned : {askew, on_edge, upright, reversed})
            {
              Listing other  = listing(5);
              other.turned   = turned;
              Reports report = strike(PlateFile(cells, other).parameters(), side, turned);
              if (turned == reversed)
                report.swap_edges();
              expect_same(flat, report, 1e-6, std::string(kind) + " turned");
            }
        }
  }

  // One rule for both kinds: the same signs and, within what two meshes differ by, the same figures.
  TEST(Orientation, ShellAndSolidReportTheSame)
  {
    const PlateFile shell_file(quadrilaterals, mixed_shell(6)),
      solid_file(hexahedra, mixed(test::rotations_of_a_cube(), 6));
    const auto   element   = shell_file.parameters().element;
    const double outermost = make_thickness_points(element.rule, element.n_points).position[element.n_points - 1];
    for (const int side : {1, -1})
      {
        const Reports shell = strike(shell_file.parameters(), side);
        for (const BladeParameters &p : {built_in("solid"), solid_file.parameters()})
          {
            const Reports solid = strike(p, side);
            EXPECT_NEAR(solid.tip.mid_chord / shell.tip.mid_chord, 1., 0.02);
            EXPECT_NEAR(solid.tip.leading / shell.tip.leading, 1., 0.02);
            EXPECT_NEAR(solid.tip.trailing / shell.tip.trailing, 1., 0.02);
            EXPECT_NEAR(solid.root.bending_moment / shell.root.bending_moment, 1., 0.02);
            EXPECT_NEAR(solid.root.transverse_force / shell.root.transverse_force, 1., 0.15) << "waves disperse";
            // of shells at the outermost point through the thickness, of solids at the face
            EXPECT_NEAR(outermost * solid.root.peak_stress() / shell.root.peak_stress(), 1., 0.02);
          }
      }
  }

  // Pressure acts on the upper face whatever the order of the file: upwards is +z.
  TEST(Orientation, PressurePushesAFileOfAnyOrderTheSameWay)
  {
    std::vector<double> tip;
    for (const Listing &listing : {always(quadrilateral(false, 0)), always(quadrilateral(true, 0)), mixed_shell(7)})
      {
        const PlateFile file(quadrilaterals, listing);
        BladeParameters p = file.parameters();
        p.loads.pressure  = "1e4";
        ThreadPool pool(1);
        const auto blade = make_blade(p, pool);
        test::advance(*blade, 0.8 * blade->step_limit().value, 50);
        tip.push_back(blade->tip_deflection().mid_chord);
      }
    EXPECT_GT(tip[0], 0.);
    EXPECT_NEAR(tip[1] / tip[0], 1., 1e-9);
    EXPECT_NEAR(tip[2] / tip[0], 1., 1e-9);
  }
} // namespace orientation_test
