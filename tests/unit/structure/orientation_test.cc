#include "blade_case.h"

#include <birdstrike/mesh/orientation.h>
#include <birdstrike/structure/make_blade.h>
#include <birdstrike/structure/probes/mid_chord.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

using namespace birdstrike;

namespace
{
  constexpr unsigned int n_span = 14, n_chord = 4;
  constexpr double       length = 0.3112, chord = 0.0889;

  /// The plate of quadrilaterals as a Gmsh file, its cells listed in one of four ways: about +z or -z, and beginning at
  /// any corner. Boundary ids 10 root, 11 tip, 12 and 13 edges.
  class PlateFile
  {
  public:
    PlateFile(const bool is_reversed, const unsigned int first)
    {
      std::string   pattern = (std::filesystem::temp_directory_path() / "birdstrike-XXXXXX.msh").string();
      const int     file    = ::mkstemps(pattern.data(), 4);
      std::ofstream out(path = pattern);
      ::close(file);
      out.precision(17);
      const auto node = [](const unsigned int i, const unsigned int j) { return i * (n_chord + 1) + j + 1; };
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << (n_span + 1) * (n_chord + 1) << "\n";
      for (unsigned int i = 0; i <= n_span; ++i)
        for (unsigned int j = 0; j <= n_chord; ++j)
          out << node(i, j) << ' ' << length * i / n_span << ' ' << chord * (double(j) / n_chord - 0.5) << " 0\n";
      out << "$EndNodes\n$Elements\n" << n_span * n_chord + 2 * (n_span + n_chord) << "\n";
      unsigned int n    = 0;
      const auto   line = [&](const unsigned int id, const unsigned int a, const unsigned int b) {
        out << ++n << " 1 2 " << id << ' ' << id << ' ' << a << ' ' << b << '\n';
      };
      for (unsigned int j = 0; j < n_chord; ++j)
        {
          line(10, node(0, j), node(0, j + 1));
          line(11, node(n_span, j), node(n_span, j + 1));
        }
      for (unsigned int i = 0; i < n_span; ++i)
        {
          line(12, node(i, 0), node(i + 1, 0));
          line(13, node(i, n_chord), node(i + 1, n_chord));
        }
      for (unsigned int i = 0; i < n_span; ++i)
        for (unsigned int j = 0; j < n_chord; ++j)
          {
            std::array<unsigned int, 4> cell{{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}};
            if (is_reversed)
              std::swap(cell[1], cell[3]);
            out << ++n << " 3 2 1 1";
            for (unsigned int k = 0; k < 4; ++k)
              out << ' ' << cell[(k + first) % 4];
            out << '\n';
          }
      out << "$EndElements\n";
    }
    ~PlateFile()
    {
      std::filesystem::remove(path);
    }

    BladeParameters parameters() const
    {
      BladeParameters p  = test::elastic_plate(n_span, n_chord);
      p.mesh.generator   = "file";
      p.mesh.file        = path;
      p.supports.clamped = "10";
      p.supports.tip     = "11";
      return p;
    }

  private:
    std::string path;
  };

  BladeParameters solid_file()
  {
    BladeParameters p  = test::elastic_plate(n_span, n_chord);
    p.kind             = "solid";
    p.mesh.generator   = "file";
    p.mesh.file        = BIRDSTRIKE_SOURCE_DIR "/meshes/plate-14x4x2.msh";
    p.supports.clamped = "1";
    p.supports.tip     = "2";
    return p;
  }

  BladeParameters built_in(const char *kind)
  {
    BladeParameters p = test::elastic_plate(n_span, n_chord);
    p.kind            = kind;
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

  /// What a blade reports that a bird along +z or -z has set moving that way, faster towards +y.
  Reports strike(BladeParameters p, const int side)
  {
    p.bird_velocity          = {{0., 100., side * 150.}};
    p.loads.initial_velocity = "0; 0; " + std::to_string(side) + "*(10*(x/0.3112)^2 + 40*x*y)";
    ThreadPool   pool(1);
    const auto   blade = make_blade(p, pool);
    MidChord     line(blade->facets(), *blade->span_line());
    const double step = 2e-6;
    EXPECT_LT(step, blade->step_limit().value * (p.kind == "shell" ? 1. : 10.));
    const auto n = static_cast<unsigned int>(std::ceil(step / (0.8 * blade->step_limit().value)));
    test::advance(*blade, step / n, 150 * n);
    Reports reports{blade->tip_deflection(), blade->root_section(), {}};
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
  const PlateFile file(true, 0);
  for (const auto &[name, p] : {std::pair{"shell", built_in("shell")},
                                {"solid", built_in("solid")},
                                {"file of a shell", file.parameters()},
                                {"file of a solid", solid_file()}})
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

TEST(Orientation, ReportsDoNotDependOnTheOrderInWhichAFileListsItsCells)
{
  const Reports built = strike(built_in("shell"), 1);
  for (const bool is_reversed : {false, true})
    for (const unsigned int first : {0u, 1u, 2u})
      {
        const PlateFile file(is_reversed, first);
        expect_same(built, strike(file.parameters(), 1), 1e-6, is_reversed ? "reversed" : "as built in");
      }
}

// One rule for both kinds: the same signs and, within what two meshes differ by, the same figures.
TEST(Orientation, ShellAndSolidReportTheSameSigns)
{
  const Reports shell = strike(built_in("shell"), 1);
  for (const BladeParameters &p : {built_in("solid"), solid_file()})
    {
      const Reports solid = strike(p, 1);
      EXPECT_NEAR(solid.tip.mid_chord / shell.tip.mid_chord, 1., 0.1);
      EXPECT_NEAR(solid.tip.trailing / shell.tip.trailing, 1., 0.1);
      EXPECT_NEAR(solid.root.bending_moment / shell.root.bending_moment, 1., 0.2);
      EXPECT_GT(solid.root.transverse_force * shell.root.transverse_force, 0.);
    }
}

// Pressure acts on the upper face whatever the order of the file: upwards is +z.
TEST(Orientation, PressurePushesAFileOfAnyOrderTheSameWay)
{
  double tip[2];
  for (const bool is_reversed : {false, true})
    {
      const PlateFile file(is_reversed, 0);
      BladeParameters p = file.parameters();
      p.loads.pressure  = "1e4";
      ThreadPool pool(1);
      const auto blade = make_blade(p, pool);
      test::advance(*blade, 0.8 * blade->step_limit().value, 50);
      tip[is_reversed] = blade->tip_deflection().mid_chord;
    }
  EXPECT_GT(tip[0], 0.);
  EXPECT_NEAR(tip[1] / tip[0], 1., 1e-9);
}
