#include "oriented_strike.h"

#include <gtest/gtest.h>

// One blade, tapered, cambered and twisted, as three programs write it, in six orientations: what it reports is the
// same.
namespace birdstrike::test::mesh_formats_test
{
  namespace
  {
    /// Chord of the tip 0.7 of the root's, camber 6 %, twist 0.3 rad.
    Point3 bend(const Point3 &x)
    {
      const double s = x[0] / 0.3112, chord = 1. - 0.3 * s, station = 2. * x[1] / 0.0889;
      const Point3 section(x[0], chord * x[1], x[2] + 0.06 * 0.0889 * chord * (1. - station * station));
      return Eigen::AngleAxisd(0.3 * s, Point3::UnitX()) * section;
    }

    struct Orientation
    {
      const char     *name;
      Listing         listing;
      Matrix3<double> turned          = Matrix3<double>::Identity();
      bool            has_turned_over = false; ///< what was the trailing edge leads
    };

    std::vector<Orientation> orientations(const bool is_solid)
    {
      using Turn           = Eigen::AngleAxisd;
      const auto cube      = rotations_of_a_cube();
      const auto reordered = [&](const unsigned int seed) { return is_solid ? mixed(cube, seed) : mixed_shell(seed); };
      return {{"as built", always(is_solid ? cube[0] : quadrilateral(false, 0))},
              {"corners cycled", always(is_solid ? cube[7] : quadrilateral(false, 1))},
              {"normals flipped", always(is_solid ? cube[14] : quadrilateral(true, 2))},
              {"shuffled", reordered(1)},
              {"shuffled, askew", reordered(2), Turn(0.7, Point3(1., 2., -3.).normalized()).matrix()},
              {"shuffled, turned over", reordered(3), Turn(M_PI, Point3::UnitX()).matrix(), true}};
    }

    Reports report(const Orientation &o, const std::array<unsigned int, 3> &n, const MeshFormat format)
    {
      Listing listing = o.listing;
      listing.turned  = o.turned;
      listing.format  = format;
      listing.shape   = bend;
      Reports reports = strike(PlateFile(n, listing).parameters(), 1, o.turned);
      if (o.has_turned_over)
        reports.swap_edges();
      return reports;
    }

    void expect_the_same_of_all(const std::array<unsigned int, 3> &n)
    {
      const auto    all  = orientations(n[2] > 0);
      const Reports once = report(all[0], n, MeshFormat::gmsh);
      EXPECT_GT(once.tip.mid_chord, 1e-3);
      EXPECT_GT(once.tip.trailing, 1.05 * once.tip.leading) << "the velocity grows towards the trailing edge";
      EXPECT_GT(once.root.bending_moment, 1.);
      for (const auto &[format, name] :
           {std::pair{MeshFormat::gmsh, "Gmsh"}, {MeshFormat::abaqus, "Abaqus"}, {MeshFormat::ls_dyna, "LS-DYNA"}})
        for (const Orientation &orientation : all)
          expect_same(once, report(orientation, n, format), 1e-9, std::string(name) + ", " + orientation.name);
    }
  } // namespace

  // The elements are the same, sums run in another order: 1e-9 is round-off of the steps.
  TEST(MeshFormats, AShellReportsTheSameFromEveryFile)
  {
    expect_the_same_of_all({{10, 4, 0}});
  }

  TEST(MeshFormats, ASolidReportsTheSameFromEveryFile)
  {
    expect_the_same_of_all({{8, 4, 1}});
  }
} // namespace birdstrike::test::mesh_formats_test
