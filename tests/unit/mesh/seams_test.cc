#include "temporary_mesh.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/mesh/blade_mesh.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

// Where elements of a file meet and share no nodes: hanging nodes are refused, seams counted, sound meshes left alone.
namespace birdstrike::seams_test
{
  namespace
  {
    using Map = std::function<Point3(double, double, double)>;

    /// Cells by their corners; nodes at one place and of one sheet are one.
    struct Build
    {
      test::TemporaryMesh::Places                             places;
      test::TemporaryMesh::Cells                              cells;
      std::map<std::pair<int, std::array<long long, 3>>, int> node_of;
      Map map = [](double x, double y, double z) -> Point3 { return {x, y, z}; };

      int node(const double x, const double y, const double z, const int sheet)
      {
        const auto                     round = [](const double v) { return std::llround(1e9 * v); };
        const std::array<long long, 3> key{round(x), round(y), round(z)};
        const auto [found, is_new] = node_of.try_emplace({sheet, key}, static_cast<int>(places.size()));
        if (is_new)
          {
            const Point3 p = map(x, y, z);
            places.push_back({{p[0], p[1], p[2]}});
          }
        return found->second;
      }
      /// n_x x n_y quadrilaterals in [x0, x1] x [y0, y1].
      void shells(const double x0, const double x1, const int n_x, const double y0, const double y1, const int n_y,
                  const int sheet = 0)
      {
        const auto x = [&](const int i) { return x0 + (x1 - x0) * i / n_x; };
        const auto y = [&](const int j) { return y0 + (y1 - y0) * j / n_y; };
        for (int i = 0; i < n_x; ++i)
          for (int j = 0; j < n_y; ++j)
            cells.push_back({node(x(i), y(j), 0., sheet), node(x(i + 1), y(j), 0., sheet),
                             node(x(i + 1), y(j + 1), 0., sheet), node(x(i), y(j + 1), 0., sheet)});
      }
      void bricks(const double x0, const double x1, const int n_x, const double y0, const double y1, const int n_y,
                  const double z0, const double z1, const int n_z, const int sheet = 0)
      {
        for (int i = 0; i < n_x; ++i)
          for (int j = 0; j < n_y; ++j)
            for (int k = 0; k < n_z; ++k)
              {
                const double x[] = {x0 + (x1 - x0) * i / n_x, x0 + (x1 - x0) * (i + 1) / n_x},
                             y[] = {y0 + (y1 - y0) * j / n_y, y0 + (y1 - y0) * (j + 1) / n_y},
                             z[] = {z0 + (z1 - z0) * k / n_z, z0 + (z1 - z0) * (k + 1) / n_z};
                cells.push_back({node(x[0], y[0], z[0], sheet), node(x[1], y[0], z[0], sheet),
                                 node(x[1], y[1], z[0], sheet), node(x[0], y[1], z[0], sheet),
                                 node(x[0], y[0], z[1], sheet), node(x[1], y[0], z[1], sheet),
                                 node(x[1], y[1], z[1], sheet), node(x[0], y[1], z[1], sheet)});
              }
      }
      int dim() const
      {
        return cells[0].size() == 4 ? 2 : 3;
      }

      /// What the user is told, empty if nothing; and what is left open.
      std::string complaint(OpenSeams *open = nullptr) const
      {
        const test::TemporaryMesh file(places, cells, dim());
        try
          {
            OpenSeams found;
            if (dim() == 2)
              found = ShellMesh({file.parameters()}).open_seams;
            else
              found = SolidMesh({file.parameters()}).open_seams;
            if (open != nullptr)
              *open = found;
          }
        catch (const InputError &error)
          {
            return error.what();
          }
        return "";
      }
      bool hangs() const
      {
        return complaint().find(" hangs on ") != std::string::npos;
      }
    };

    Map turned(const Map &map)
    {
      const Matrix3<double> R = Eigen::AngleAxisd(1.1, Point3(1., 2., -0.5).normalized()).toRotationMatrix();
      return [=](const double x, const double y, const double z) -> Point3 {
        return R * map(x, y, z) + Point3(3., -2., 5.);
      };
    }

    const double pi = std::numbers::pi;

    TEST(Seams, AHangingNodeOfShellsIsNamedWithItsElementAndEdge)
    {
      Build mesh;
      mesh.shells(0., 1., 1, 0., 2., 2); // nodes 1 to 6, elements 1 and 2
      mesh.shells(1., 2., 1, 0., 1., 1); // 3
      mesh.shells(1., 2., 1, 1., 2., 2); // 4 and 5: their common node at (1, 1.5) hangs on 2
      const std::string text = mesh.complaint();
      for (const char *part : {"node 10 at (1, 1.5, 0) m hangs on the edge of element 2 between its nodes 3 and 5",
                               "nodes that hang in this mesh: 1", "Merging nodes does not help"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
    }

    // Coarse and fine share nodes 1 : n, or none inside (3 : 2, 5 : 4), in any place and direction.
    TEST(Seams, NodesHangAtAnyRatio)
    {
      for (const auto &[coarse, fine] : {std::array{1, 2}, {1, 3}, {1, 7}, {2, 4}, {2, 3}, {3, 2}, {4, 5}, {3, 30}})
        for (const bool is_turned : {false, true})
          {
            Build shells, bricks;
            if (is_turned)
              shells.map = bricks.map = turned(shells.map);
            shells.shells(0., 1., 2, 0., 1., coarse);
            shells.shells(1., 2., 2, 0., 1., fine);
            EXPECT_TRUE(shells.hangs()) << coarse << " : " << fine << " " << shells.complaint();
            bricks.bricks(0., 1., 2, 0., 1., coarse, 0., 0.1, 1);
            bricks.bricks(1., 2., 2, 0., 1., fine, 0., 0.1, 1);
            EXPECT_TRUE(bricks.hangs()) << coarse << " : " << fine << " " << bricks.complaint();
          }
    }

    // Joined along one whole edge (face) besides, so that the mesh is in one piece.
    TEST(Seams, OneHangingNodeOfManyEdgesIsFound)
    {
      Build shells, bricks;
      shells.shells(0., 1., 2, 0., 4., 4);
      shells.shells(1., 2., 2, 0., 3., 3);
      shells.shells(1., 2., 2, 3., 4., 2);
      EXPECT_TRUE(shells.hangs());
      bricks.bricks(0., 1., 1, 0., 2., 2, 0., 1., 1);
      bricks.bricks(1., 2., 1, 0., 1., 1, 0., 1., 1);
      bricks.bricks(1., 2., 1, 1., 2., 2, 0., 1., 2); // 2 x 2 on one face, a node in its middle
      EXPECT_TRUE(bricks.hangs());
      EXPECT_NE(bricks.complaint().find("hangs on the face of element 2"), std::string::npos) << bricks.complaint();
    }

    // The fine side bows by 1 - cos(angle / 2) of the radius from the edges of the coarse one: at 8 elements on a half
    // circle 2 % of it, a twentieth of an edge.
    TEST(Seams, NodesHangOnCurvedSurfacesToo)
    {
      for (const int n : {8, 16, 64})
        for (const int ratio : {2, 3})
          for (const bool across : {false, true}) // the surface is curved, or the line in the surface
            {
              Build shells, bricks;
              shells.map = bricks.map = [&](const double x, const double y, const double z) -> Point3 {
                const double a = pi * y, r = across ? 3. + x : 3. + z;
                return across ? Point3(r * std::cos(a), r * std::sin(a), z)
                              : Point3(x, r * std::cos(a), r * std::sin(a));
              };
              shells.shells(0., 0.3, 1, 0., 1., n);
              shells.shells(0.3, 0.6, 1, 0., 1., ratio * n);
              EXPECT_TRUE(shells.hangs()) << n << " " << ratio << " " << across;
              bricks.bricks(0., 0.3, 1, 0., 1., n, 0., 0.1, 1);
              bricks.bricks(0.3, 0.6, 1, 0., 1., ratio * n, 0., 0.1, 1);
              EXPECT_TRUE(bricks.hangs()) << n << " " << ratio << " " << across;
            }
    }

    // A blade meshed with a corner: two panels at right angles whose common line is divided 2 : 3.
    TEST(Seams, NodesHangWhereTwoPanelsMeetAtAnAngle)
    {
      for (const double angle : {20., 60., 90., 150.})
        {
          Build mesh;
          mesh.map = [&](const double x, const double y, double) -> Point3 {
            const double a = angle * pi / 180.;
            return x <= 0. ? Point3(x, y, 0.) : Point3(-x * std::cos(a), y, x * std::sin(a));
          };
          mesh.shells(-1., 0., 2, 0., 1., 2);
          mesh.shells(0., 1., 2, 0., 1., 3);
          EXPECT_EQ(mesh.hangs(), angle > 30.) << angle;
        }
    }

    /// A plate with a cut from (1, 1) to its right edge; the lips are `gap` apart there, at the tip they share a node.
    Build cut_plate(const double gap, const int n_lower, const int n_upper)
    {
      Build mesh;
      mesh.map = [=](const double x, const double y, const double z) -> Point3 {
        return {x, y + (x > 1. && y >= 1. ? 0.5 * gap * (x - 1.) * (2. - y) : 0.), z};
      };
      mesh.shells(0., 1., 2, 0., 2., 4);
      // the lower lip keeps its place; sheets share the nodes of the line x = 1
      const auto half = [&](const double y0, const double y1, const int n, const int sheet) {
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < 2; ++j)
            {
              const double x0 = 1. + 2. * i / n, x1 = 1. + 2. * (i + 1) / n, a = y0 + 0.5 * j * (y1 - y0),
                           b = y0 + 0.5 * (j + 1) * (y1 - y0);
              const auto at  = [&](const double x, const double y) { return mesh.node(x, y, 0., x == 1. ? 0 : sheet); };
              const std::vector<int> cell{at(x0, a), at(x1, a), at(x1, b), at(x0, b)};
              mesh.cells.push_back(cell);
            }
      };
      const Map open = mesh.map, shut = [](const double x, const double y, const double z) -> Point3 {
        return {x, y, z};
      };
      mesh.map = shut;
      half(0., 1., n_lower, 1);
      mesh.map = open;
      half(1., 2., n_upper, 2);
      return mesh;
    }

    TEST(Seams, CracksNotchesAndSlitsAreLeftAlone)
    {
      OpenSeams open;
      EXPECT_EQ(cut_plate(0., 4, 4).complaint(&open), "") << "a crack whose nodes coincide";
      EXPECT_EQ(open.pairs.n, 4U);
      EXPECT_EQ(open.pairs.largest_gap, 0.);
      EXPECT_EQ(cut_plate(0.1, 4, 4).complaint(&open), "") << "an open notch";
      EXPECT_EQ(open.pairs.n + open.beside.n, 0U);
      EXPECT_EQ(cut_plate(0.1, 4, 3).complaint(&open), "") << "the same, its lips divided otherwise";
      EXPECT_EQ(open.pairs.n + open.beside.n, 0U);
      EXPECT_TRUE(cut_plate(0., 4, 3).hangs()) << "lips that touch";
      EXPECT_EQ(cut_plate(0.01, 4, 3).complaint(&open), "");
      EXPECT_GT(open.beside.n, 0U) << "a hundredth of an element open";
    }

    /// A strip that is bent back over itself: the rims of both layers lie over one another, `gap` apart.
    TEST(Seams, FoldsAndRingsAreLeftAlone)
    {
      for (const double gap : {1e-4, 1e-2, 0.5})
        for (const int n : {4, 5})
          {
            Build mesh;
            mesh.map = [=](const double x, const double y, double) -> Point3 {
              return x <= 0. ? Point3(x, y, 0.) : Point3(-x * (1. - 1e-3 * gap), y, std::min(gap, gap * 8. * x));
            };
            mesh.shells(-1., 0., n, 0., 1., 3);
            mesh.shells(0., 1., 7, 0., 1., 3);
            EXPECT_EQ(mesh.complaint(), "") << gap << " " << n;
          }
      for (const double gap : {3e-3, 0.03, 0.3}) // a ring nearly closed; of other divisions at both ends it is askew
        {
          Build mesh;
          mesh.map = [=](const double x, const double y, double) -> Point3 {
            const double a = (2. * pi - gap) * x;
            return {std::cos(a), std::sin(a), y + 0.013 * x};
          };
          mesh.shells(0., 1., 24, 0., 1., 4);
          EXPECT_EQ(mesh.complaint(), "") << gap;
        }
    }

    // A trailing edge whose elements are hundreds of times as long as wide (thick), and lean.
    TEST(Seams, ThinEdgesAreLeftAlone)
    {
      for (const double width : {0.03, 3e-3, 3e-4})
        {
          Build shells, bricks;
          shells.map = bricks.map = [=](const double x, const double y, const double z) -> Point3 {
            return {x + 0.4 * y, width * y, width * z};
          };
          shells.shells(0., 5., 5, 0., 1., 1);
          OpenSeams open;
          EXPECT_EQ(shells.complaint(&open), "") << width;
          EXPECT_EQ(open.pairs.n + open.beside.n, 0U) << width;
          bricks.bricks(0., 5., 5, 0., 1., 1, 0., 1., 1);
          EXPECT_EQ(bricks.complaint(&open), "") << width;
          EXPECT_EQ(open.pairs.n + open.beside.n, 0U) << width;
        }
    }

    /// As the report on seams has it: elements of 25 mm, three of four edges of a line cut, some um apart.
    Build seam(const double gap)
    {
      Build mesh;
      mesh.shells(0., 0.1, 4, -0.05, 0.05, 4);
      const auto at = [&](const double x, const double y) {
        const bool is_cut = std::abs(x - 0.1) < 1e-9 && y > -0.01 && y < 0.03;
        mesh.map          = [=](const double u, const double v, const double w) -> Point3 {
          return {is_cut ? u + gap : u, v, w};
        };
        return mesh.node(x, y, 0., is_cut ? 1 : 0);
      };
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          {
            const double           x = 0.1 + 0.025 * i, y = -0.05 + 0.025 * j, h = 0.025;
            const std::vector<int> cell{at(x, y), at(x + h, y), at(x + h, y + h), at(x, y + h)};
            mesh.cells.push_back(cell);
          }
      return mesh;
    }

    TEST(Seams, NodesThatNearlyCoincideAreCountedByTheSizeOfElements)
    {
      for (const double gap : {0., 1e-9, 1e-6, 1e-5, 1e-4, 4e-4})
        {
          OpenSeams open;
          EXPECT_EQ(seam(gap).complaint(&open), "") << gap;
          EXPECT_EQ(open.pairs.n, 2U) << gap;
          EXPECT_NEAR(open.pairs.largest_gap, gap, 1e-12);
          EXPECT_NEAR(open.pairs.share, gap / 0.025, 0.02 * gap / 0.025 + 1e-12);
          EXPECT_NEAR(open.pairs.at[0], 0.1, 1e-3);
          EXPECT_EQ(open.beside.n, 0U);
        }
      OpenSeams open;
      EXPECT_EQ(seam(1e-3).complaint(&open), "");
      EXPECT_EQ(open.pairs.n, 0U) << "a slit of a 25th of an element";
    }

    TEST(Seams, PiecesSayHowTheyMayBeJoined)
    {
      Build near, apart;
      near.shells(0., 1., 2, 0., 1., 2);
      near.map = [](const double x, const double y, const double z) -> Point3 { return {x + 1e-4, y, z}; };
      near.shells(1., 2., 2, 0., 1., 2, 1);
      EXPECT_NE(near.complaint().find("3 pairs of nodes lie within 0.1 mm"), std::string::npos) << near.complaint();
      apart.shells(0., 1., 2, 0., 1., 2);
      apart.shells(2., 3., 2, 0., 1., 2);
      EXPECT_NE(apart.complaint().find("merging nodes cannot join it"), std::string::npos) << apart.complaint();
    }
  } // namespace
} // namespace birdstrike::seams_test
