#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/mesh/blade_shape.h>
#include <birdstrike/structure/parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <cmath>

namespace birdstrike::blade_generator_test
{
  namespace
  {
    /// A fan blade in all its laws.
    BladeParameters fan_blade(const unsigned int n_span, const unsigned int n_chord)
    {
      BladeParameters p;
      p.mesh.generator              = MeshGenerator::blade;
      p.mesh.length                 = 0.45;
      p.mesh.chord                  = 0.16;
      p.mesh.n_span                 = n_span;
      p.mesh.n_chord                = n_chord;
      p.mesh.profile.root_radius    = 0.2;
      p.mesh.profile.chord          = "1 + 0.3*s";
      p.mesh.profile.stagger        = "20 + 40*s";
      p.mesh.profile.camber         = "0.1 - 0.08*s";
      p.mesh.profile.stacking_point = 0.4;
      p.mesh.profile.sweep          = "0.03*s^2";
      p.mesh.profile.lean           = "-0.02*s";
      p.thickness.maximum           = "0.012 - 0.008*s";
      p.thickness.maximum_station   = 0.45;
      return p;
    }

    /// Node (i, j) of the grid, a corner of cell (i, j) or, at the far ends, of the one before.
    Point3 grid_node(const SurfaceMesh &mesh, const BladeParameters &p, const unsigned int i, const unsigned int j)
    {
      const bool is_tip = i == p.mesh.n_span, is_trailing = j == p.mesh.n_chord;
      return mesh.node(mesh.cells[(i - is_tip) * p.mesh.n_chord + j - is_trailing]
                                 [is_tip + is_trailing + 2 * (is_trailing && !is_tip)]);
    }

    Point3 direction(const double degrees)
    {
      return Point3(0., std::cos(degrees * M_PI / 180.), std::sin(degrees * M_PI / 180.));
    }

    double shell_mass(const BladeParameters &p)
    {
      ShellMesh mesh({p.mesh});
      return mesh.compute_mass(4430., make_thickness_law(p)).total;
    }

    double solid_mass(const BladeParameters &p)
    {
      SolidMesh mesh(p);
      return mesh.compute_mass(4430.).total;
    }

    // Coordinates of some 0.1 m: round-off is 1e-17.
    TEST(BladeGenerator, IsTheFlatPlateByDefault)
    {
      BladeParameters p;
      p.mesh.span_grading = 3.;
      const ShellMesh plate({p.mesh});
      p.mesh.generator = MeshGenerator::blade;
      const ShellMesh blade({p.mesh});
      const auto     &a = plate, &b = blade;
      ASSERT_EQ(a.nodes.size(), b.nodes.size());
      for (std::size_t n = 0; n < a.nodes.size(); ++n)
        EXPECT_LT((a.node(n) - b.node(n)).norm(), 1e-15);
      EXPECT_EQ(a.cells, b.cells);
      EXPECT_EQ(a.boundary_ids, b.boundary_ids);
    }

    TEST(BladeGenerator, HasTheChordsAndStaggerAnglesOfTheDescription)
    {
      const BladeParameters p = fan_blade(20, 8);
      const ShellMesh       shell({p.mesh});
      const SurfaceMesh    &mesh = shell;
      for (const unsigned int i : {0u, 10u, 20u})
        {
          const double s       = i / 20.;
          const Point3 leading = grid_node(mesh, p, i, 0), trailing = grid_node(mesh, p, i, 8);
          const double chord = 0.16 * (1. + 0.3 * s);
          const Point3 along = direction(20. + 40. * s);
          EXPECT_NEAR((trailing - leading).norm(), chord, 1e-15);
          EXPECT_NEAR((trailing - leading).dot(along), chord, 1e-15) << "stagger at s = " << s;
          const Point3 stack(0.2 + 0.45 * s, 0.03 * s * s, -0.02 * s);
          EXPECT_LT((leading + 0.4 * chord * along - stack).norm(), 1e-15) << "sections hang on the stacking line";
          const Point3 normal = direction(20. + 40. * s + 90.);
          const Point3 middle = grid_node(mesh, p, i, 4);
          EXPECT_NEAR((middle - leading).dot(normal), (0.1 - 0.08 * s) * chord, 1e-15) << "camber at s = " << s;
          for (unsigned int j = 0; j <= 8; ++j)
            EXPECT_NEAR(grid_node(mesh, p, i, j)[0], stack[0], 1e-15) << "sections are plane";
        }
    }

    // Of an arc: constant radius (l^2/4 + h^2)/(2 h), edges that include 4 atan(2 h/l).
    TEST(BladeGenerator, CamberLinesAreArcAndParabola)
    {
      BladeParameters p;
      p.mesh.generator      = MeshGenerator::blade;
      p.mesh.chord          = 0.2;
      p.mesh.profile.camber = "0.12";
      const BladeShape arc(p.mesh);
      const double     height = 0.12 * 0.2, radius = (0.01 + height * height) / (2. * height);
      for (const double c : {0., 0.1, 0.35, 0.5, 0.8, 1.})
        EXPECT_NEAR((arc.position(0.5, c) - Point3(0.5 * p.mesh.length, 0., height - radius)).norm(), radius, 1e-15);
      EXPECT_NEAR(std::acos(arc.normal(0.5, 0.).dot(arc.normal(0.5, 1.))), 4. * std::atan(0.24), 1e-10);
      p.mesh.profile.camber_line = CamberLine::parabola;
      const BladeShape parabola(p.mesh);
      for (const double c : {0., 0.1, 0.35, 0.5, 0.8, 1.})
        EXPECT_NEAR(parabola.position(0.5, c)[2], 4. * height * c * (1. - c), 1e-16);
      const Point3 edge = parabola.normal(0.5, 0.);
      EXPECT_NEAR(-edge[1] / edge[2], 4. * 0.12, 1e-10) << "slope at the leading edge";
    }

    // A straight twisted blade is a helicoid: normal (-u theta', -sin, cos)/sqrt(1 + (u theta')^2), area element
    // sqrt(1 + (u theta')^2) dr du. Difference quotients of step 1e-4: 1e-8 of the third derivative. Facets between
    // points of the surface: area of second order, so a quarter of the error on half the size.
    TEST(BladeGenerator, AStraightTwistedBladeIsAHelicoid)
    {
      BladeParameters p;
      p.mesh.generator       = MeshGenerator::blade;
      p.mesh.profile.stagger = "90*s";
      const double     rate  = 0.5 * M_PI / p.mesh.length;
      const BladeShape shape(p.mesh);
      for (const double s : {0., 0.00005, 0.3, 0.99995, 1.})
        for (const double c : {0., 0.2, 0.5, 1.})
          {
            const double angle = 0.5 * M_PI * s, u = (c - 0.5) * p.mesh.chord;
            const Point3 exact = Point3(-u * rate, -std::sin(angle), std::cos(angle)).normalized();
            EXPECT_LT((shape.normal(s, c) - exact).norm(), 1e-8) << s << ' ' << c;
            const Point3 point = shape.position(s, c);
            const auto   back  = shape.coordinates(point.data());
            EXPECT_NEAR(back[0], s, 1e-14);
            EXPECT_NEAR(back[1], c, 1e-14);
          }
      p.thickness.value = "0.003";
      // integral of sqrt(1 + w^2) over w from 0 to w1 = chord/2 * rate
      const double w      = 0.5 * p.mesh.chord * rate;
      const double exact  = 4430. * 0.003 * p.mesh.length * (w * std::hypot(1., w) + std::asinh(w)) / rate;
      p.mesh.n_span       = 16;
      const double coarse = shell_mass(p) / exact - 1.;
      p.mesh.n_span       = 32;
      p.mesh.n_chord      = 16;
      const double fine   = shell_mass(p) / exact - 1.;
      EXPECT_LT(std::abs(fine), 1e-3);
      EXPECT_NEAR(coarse / fine, 4., 0.2);
    }

    // int (1 - (1 - e) r^2) = 1 - (1 - e)/3 to either side; squares are integrated exactly by two points in elements
    // that end at the largest thickness.
    TEST(BladeGenerator, ProfileGivesTheMassOfTwoParabolas)
    {
      for (const MeshGenerator generator : {MeshGenerator::flat_plate, MeshGenerator::blade})
        {
          BladeParameters p;
          p.mesh.generator            = generator;
          p.thickness.maximum         = "0.008 - 0.004*s";
          p.thickness.leading_edge    = "0.1";
          p.thickness.trailing_edge   = "0.4";
          p.thickness.maximum_station = 0.25;
          const double mean           = 0.25 * (1. - 0.9 / 3.) + 0.75 * (1. - 0.6 / 3.);
          EXPECT_NEAR(shell_mass(p) / (4430. * p.mesh.length * p.mesh.chord * 0.006 * mean), 1., 1e-13)
            << (generator == MeshGenerator::blade);
        }
    }

    TEST(BladeGenerator, SolidIsTheShellHalfAThicknessToEitherSide)
    {
      BladeParameters p = fan_blade(10, 6);
      p.mesh.n_layers   = 2;
      const SolidMesh    solid(p);
      const ShellMesh    shell({p.mesh});
      const BladeShape   shape(p.mesh);
      const ThicknessLaw law  = make_thickness_law(p);
      const VolumeMesh  &mesh = solid;
      for (std::size_t below = 0; below < mesh.cells.size(); below += 2)
        for (unsigned int k = 0; k < 4; ++k)
          {
            const Point3 low = mesh.node(mesh.cells[below][k]), middle = mesh.node(mesh.cells[below][k + 4]);
            const Point3 high = mesh.node(mesh.cells[below + 1][k + 4]);
            const auto   sc   = shape.coordinates(middle.data());
            const double t    = law({middle.data()});
            EXPECT_LT((high - low - t * shape.normal(sc[0], sc[1])).norm(), 1e-12);
            EXPECT_LT((0.5 * (high + low) - middle).norm(), 1e-16);
            const std::uint32_t n = shell.nearest_node(middle).value();
            EXPECT_LT((shell.node(n) - middle).norm(), 1e-16);
          }
      EXPECT_EQ(mesh.boundary_ids, (std::vector<unsigned int>{0, 1, 2, 3, 5, 6}));
      // The leading edge is a face of a quarter of the largest thickness: 3 mm at the root, 1 mm at the tip.
      double thinnest = 1., thickest = 0.;
      for (const auto &face : mesh.boundary)
        if (face.id == 2)
          for (unsigned int k = 0; k < 4; ++k)
            {
              const double side = (mesh.node(face.nodes[(k + 1) % 4]) - mesh.node(face.nodes[k])).norm();
              if (side < 0.01)
                {
                  thinnest = std::min(thinnest, side);
                  thickest = std::max(thickest, side);
                }
            }
      EXPECT_NEAR(thickest, 0.5 * 0.25 * 0.012, 1e-12) << "half of it: two layers";
      EXPECT_NEAR(thinnest, 0.5 * 0.25 * 0.004, 1e-12);
    }

    // A shell of thickness t holds int t dA; the body has int t (1 + K t^2/12) dA with the Gaussian curvature K, here
    // up to 6/m^2 in size where t is 5 to 12 mm: some 1e-5. Bricks are bounded by chords of the profile, so that the
    // solid lacks t'' h^2/12, 1 % with eight bricks, and a quarter of it with each halving.
    TEST(BladeGenerator, ShellAndSolidHaveTheSameMass)
    {
      const double coarse = solid_mass(fan_blade(20, 8)) / shell_mass(fan_blade(20, 8)) - 1.;
      const double fine   = solid_mass(fan_blade(40, 16)) / shell_mass(fan_blade(40, 16)) - 1.;
      EXPECT_LT(std::abs(fine), 3e-3);
      EXPECT_NEAR(coarse / fine, 4., 0.05);
      EXPECT_LT(std::abs((4. * fine - coarse) / 3.), 2e-5) << "extrapolated";
      EXPECT_GT(shell_mass(fan_blade(20, 8)), 1.) << "a fan blade of titanium weighs kilograms";
    }

    TEST(BladeGenerator, IsDescribedByTheParameterFile)
    {
      BladeParameters          p;
      dealii::ParameterHandler prm;
      p.declare(prm);
      prm.parse_input_from_string("subsection Mesh\n set Generator = blade\n set Layers = 3\n set Layer grading = 2\n"
                                  " subsection Profile\n  set Root radius = 0.2\n  set Chord law = 1 + s\n"
                                  "  set Stagger = 10 + 50*s\n  set Camber line = parabola\n end\nend\n"
                                  "subsection Thickness\n set Maximum = 0.01\n set Leading edge = 0.2\nend\n");
      EXPECT_NO_THROW(p.check());
      EXPECT_EQ(p.mesh.n_layers, 3u);
      EXPECT_EQ(p.mesh.profile.camber_line, CamberLine::parabola);
      const BladeShape shape(p.mesh);
      EXPECT_NEAR(shape.chord(0.5), 1.5 * p.mesh.chord, 1e-16);
      EXPECT_NEAR(shape.stagger(1.), M_PI / 3., 1e-15);
      EXPECT_NEAR(make_thickness_law(p)({shape.position(0.5, 0.).data()}), 0.002, 1e-16);
    }

    TEST(BladeGenerator, RefusesLawsThatMakeNoBlade)
    {
      const auto expect_refused = [](const auto &change, const std::string &name) {
        BladeParameters p = fan_blade(4, 4);
        change(p);
        try
          {
            p.check();
            const SolidMesh mesh(p);
            ADD_FAILURE() << name << " was accepted";
          }
        catch (const InputError &error)
          {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
          }
      };
      using P = BladeParameters;
      expect_refused([](P &p) { p.mesh.profile.chord = "1-s"; }, "Mesh/Profile/Chord law");
      expect_refused([](P &p) { p.mesh.profile.chord = "1-y"; }, "Mesh/Profile/Chord law");
      expect_refused([](P &p) { p.mesh.profile.stagger = "twenty"; }, "Mesh/Profile/Stagger");
      expect_refused([](P &p) { p.mesh.profile.stagger = "20; 30"; }, "Mesh/Profile/Stagger");
      expect_refused([](P &p) { p.mesh.profile.stagger = ""; }, "Mesh/Profile/Stagger");
      expect_refused([](P &p) { p.mesh.profile.camber = "0.5"; }, "Mesh/Profile/Camber");
      expect_refused([](P &p) { p.mesh.profile.sweep = "1/s"; }, "Mesh/Profile/Sweep");
      expect_refused([](P &p) { p.mesh.profile.lean = "sqrt(s-0.5)"; }, "Mesh/Profile/Lean");
      expect_refused([](P &p) { p.thickness.maximum = "0.01-0.01*s"; }, "Thickness/Maximum");
      expect_refused([](P &p) { p.thickness.leading_edge = "0"; }, "Thickness/Leading edge");
      expect_refused([](P &p) { p.thickness.trailing_edge = "1.1"; }, "Thickness/Trailing edge");
      expect_refused([](P &p) { p.thickness.value = "0.01"; }, "Value and Maximum");
      expect_refused([](P &p) { p.is_halved = true; }, "Mesh/Generator");
      expect_refused(
        [](P &p) {
          p.mesh.generator = MeshGenerator::file;
          p.mesh.file      = "blade.msh";
          p.kind           = BladeKind::solid;
        },
        "Thickness/Maximum");
      // Bricks that turn inside out: a section 4 mm long in chord and 12 mm thick, bent to an arc.
      expect_refused(
        [](P &p) {
          p.mesh.profile.chord     = "0.05";
          p.mesh.profile.camber    = "0.3";
          p.thickness.maximum      = "0.03";
          p.thickness.leading_edge = "1";
        },
        "without volume");
    }
  } // namespace
} // namespace birdstrike::blade_generator_test
