#include "oriented_file.h"

#include <birdstrike/mesh/orientation.h>
#include <birdstrike/structure/make_blade.h>
#include <birdstrike/structure/probes/mid_chord.h>

#include <gtest/gtest.h>

using namespace birdstrike;
using test::Listing;
using test::PlateFile;

namespace
{
  constexpr unsigned int                n_span = 14, n_chord = 4;
  constexpr std::array<unsigned int, 3> quadrilaterals{{n_span, n_chord, 0}}, hexahedra{{n_span, n_chord, 2}};

  /// Quadrilaterals about +z or -z, beginning at any corner.
  std::vector<unsigned int> quadrilateral(const bool is_reversed, const unsigned int first)
  {
    std::vector<unsigned int> order;
    for (unsigned int k = 0; k < 4; ++k)
      order.push_back((is_reversed ? 8 - k - first : k + first) % 4);
    return order;
  }

  Listing always(const std::vector<unsigned int> &order)
  {
    return {[order] { return order; }};
  }

  /// Every cell another way, cells and nodes shuffled.
  Listing mixed(const std::vector<std::vector<unsigned int>> &orders, const unsigned int seed)
  {
    return {[orders, random = std::make_shared<std::mt19937>(seed)] { return orders[(*random)() % orders.size()]; },
            seed};
  }

  Listing mixed_shell(const unsigned int seed)
  {
    std::vector<std::vector<unsigned int>> orders;
    for (const bool is_reversed : {false, true})
      for (const unsigned int first : {0u, 1u, 2u, 3u})
        orders.push_back(quadrilateral(is_reversed, first));
    return mixed(orders, seed);
  }

  BladeParameters built_in(const char *kind)
  {
    BladeParameters p = test::elastic_plate(n_span, n_chord);
    p.kind            = blade_kinds().at(kind);
    p.mesh.n_layers   = 2;
    return p;
  }

  struct Reports
  {
    TipDeflection       tip;
    RootSectionReport   root;
    std::vector<double> line; ///< m, deflection of the mid-chord line

    std::vector<double> figures() const
    {
      std::vector<double> all{tip.mid_chord,     tip.leading,         tip.trailing,
                              root.normal_force, root.bending_moment, root.transverse_force};
      for (const auto *list : {&root.chord_position, &root.stress_struck, &root.stress_rear, &line})
        all.insert(all.end(), list->begin(), list->end());
      return all;
    }
  };

  /// What a blade reports that a bird along its normal, or against it, has set moving that way, faster towards the edge
  /// 13. `turned`: how the blade stands in space. Forces of the root are means over the time: waves differ.
  Reports strike(BladeParameters p, const int side, const Matrix3<double> &turned = Matrix3<double>::Identity())
  {
    const Point3 bird = turned * Point3(0., 100., side * 150.);
    p.bird_velocity   = {{bird[0], bird[1], bird[2]}};
    std::ostringstream speed;
    speed.precision(17);
    for (int d = 0; d < 3; ++d)
      speed << (d > 0 ? "; " : "") << side * turned(d, 2) << "*(10*(x_/0.3112)^2 + 40*x_*y_)";
    p.loads.initial_velocity = speed.str();
    for (const auto &[name, axis] : {std::pair{"x_", 0}, {"y_", 1}}) // along the axes of the plate
      {
        std::ostringstream along;
        along.precision(17);
        along << '(' << turned(0, axis) << "*x+" << turned(1, axis) << "*y+" << turned(2, axis) << "*z)";
        for (std::size_t at; (at = p.loads.initial_velocity.find(name)) != std::string::npos;)
          p.loads.initial_velocity.replace(at, 2, along.str());
      }
    ThreadPool   pool(1);
    const auto   blade = make_blade(p, pool);
    MidChord     line(blade->facets(), *blade->span_line());
    const double step = 2e-6;
    EXPECT_LT(step, blade->step_limit().value * (p.kind == BladeKind::shell ? 1. : 10.));
    const auto        n = static_cast<unsigned int>(std::ceil(step / (0.8 * blade->step_limit().value)));
    RootSectionReport mean{};
    for (unsigned int k = 0; k < 150; ++k)
      {
        test::advance(*blade, step / n, n);
        const RootSectionReport now = blade->root_section();
        mean.normal_force += now.normal_force / 150.;
        mean.bending_moment += now.bending_moment / 150.;
        mean.transverse_force += now.transverse_force / 150.;
      }
    Reports reports{blade->tip_deflection(), blade->root_section(), {}};
    reports.root.normal_force     = mean.normal_force;
    reports.root.bending_moment   = mean.bending_moment;
    reports.root.transverse_force = mean.transverse_force;
    line.compute_deflection(reports.line);
    return reports;
  }

  /// Sums in another order of nodes and cells: round-off of 150 steps, relative to the largest of its kind.
  void expect_same(const Reports &a, const Reports &b, const double tolerance, const std::string &what)
  {
    const auto x = a.figures(), y = b.figures();
    ASSERT_EQ(x.size(), y.size()) << what;
    for (std::size_t k = 0; k < x.size(); ++k)
      {
        const double scale = k < 3                  ? std::abs(a.tip.mid_chord)
                             : k == 4               ? std::abs(a.root.bending_moment)
                             : k < 6                ? std::abs(a.root.transverse_force)
                             : std::abs(x[k]) > 1e3 ? a.root.peak_stress()
                                                    : 1e-2;
        EXPECT_NEAR(x[k], y[k], tolerance * scale) << what << ", figure " << k;
      }
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

// Turned in space a blade reports the same, as long as its chord runs towards +y; turned over about its span, the edge
// that was trailing leads.
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
              {
                std::swap(report.tip.leading, report.tip.trailing);
                for (double &position : report.root.chord_position)
                  position = -position;
                for (auto *list : {&report.root.chord_position, &report.root.stress_struck, &report.root.stress_rear})
                  std::reverse(list->begin(), list->end());
              }
            expect_same(flat, report, 1e-6, std::string(kind) + " turned");
          }
      }
}

// One rule for both kinds: the same signs and, within what two meshes differ by, the same figures.
TEST(Orientation, ShellAndSolidReportTheSame)
{
  const PlateFile shell_file(quadrilaterals, mixed_shell(6)),
    solid_file(hexahedra, mixed(test::rotations_of_a_cube(), 6));
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
          EXPECT_NEAR(solid.root.peak_stress() / shell.root.peak_stress(), 1., 0.02);
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
