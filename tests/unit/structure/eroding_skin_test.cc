#include "structure/surface/eroding_skin.h"
#include <birdstrike/mesh/blade_mesh.h>
#include <birdstrike/structure/parameters.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace birdstrike::eroding_skin_test
{
  namespace
  {
    BladeParameters box(const unsigned int n_span, const unsigned int n_chord, const unsigned int n_layers)
    {
      BladeParameters p;
      p.kind            = BladeKind::solid;
      p.mesh.length     = 0.05;
      p.mesh.chord      = 0.01;
      p.mesh.n_span     = n_span;
      p.mesh.n_chord    = n_chord;
      p.mesh.n_layers   = n_layers;
      p.thickness.value = "0.002";
      return p;
    }

    /// Area vectors of a closed surface sum to zero; neighbours name each other and run along their edge in opposite
    /// directions. Returns the number of facets that hang together with facet 0.
    std::size_t expect_closed(const VolumeMesh &mesh, const FacetsView &view)
    {
      Point3 sum = Point3::Zero();
      for (std::size_t f = 0; f < view.n_facets; ++f)
        {
          const auto &n = view.nodes[f];
          sum += 0.5 * (mesh.node(n[2]) - mesh.node(n[0])).cross(mesh.node(n[3]) - mesh.node(n[1]));
          for (unsigned int k = 0; k < 4; ++k)
            {
              const std::int32_t g = view.neighbor[f][k];
              EXPECT_GE(g, 0) << "facet " << f << " side " << k;
              if (g < 0)
                continue;
              bool is_mutual = false;
              for (unsigned int j = 0; j < 4; ++j)
                is_mutual = is_mutual || (view.neighbor[g][j] == static_cast<std::int32_t>(f) &&
                                          view.nodes[g][j] == n[(k + 1) % 4] && view.nodes[g][(j + 1) % 4] == n[k]);
              EXPECT_TRUE(is_mutual) << "facet " << f << " side " << k;
            }
        }
      EXPECT_LT(sum.norm(), 1e-15);
      std::set<std::int32_t>    seen{0};
      std::vector<std::int32_t> front{0};
      while (!front.empty())
        {
          const std::int32_t f = front.back();
          front.pop_back();
          for (const std::int32_t g : view.neighbor[f])
            if (seen.insert(g).second)
              front.push_back(g);
        }
      return seen.size();
    }

    TEST(ErodingSkin, IsTheMeshsOwnUntilSomethingGoes)
    {
      const SolidMesh mesh(box(3, 2, 2));
      ErodingSkin     skin(mesh);
      FacetsView      view;
      skin.offer(view);
      EXPECT_EQ(view.nodes, mesh.skin.cells.data());
      EXPECT_FALSE(view.two_sided);
      skin.remove([](const std::size_t) { return false; }); // made anew it is the same surface
      FacetsView again;
      skin.offer(again);
      ASSERT_EQ(again.n_facets, view.n_facets);
      EXPECT_EQ(expect_closed(mesh, again), again.n_facets);
      std::map<std::set<std::uint32_t>, int> facets;
      for (std::size_t f = 0; f < view.n_facets; ++f)
        {
          ++facets[{view.nodes[f].begin(), view.nodes[f].end()}];
          ++facets[{again.nodes[f].begin(), again.nodes[f].end()}];
        }
      for (const auto &[nodes, count] : facets)
        EXPECT_EQ(count, 2);
      EXPECT_GT(again.revision, view.revision);
    }

    TEST(ErodingSkin, IsClosedAroundWhatIsLeft)
    {
      // 3 x 1 x 1: the middle goes, two boxes are left
      const SolidMesh row(box(3, 1, 1));
      ErodingSkin     skin(row);
      FacetsView      view;
      skin.remove([&](const std::size_t c) { return std::abs(row.centroid(c)[0] - 0.025) < 1e-6; });
      skin.offer(view);
      EXPECT_EQ(view.n_facets, 12u);
      EXPECT_EQ(expect_closed(row, view), 6u);

      // 3 x 3 x 3: the middle goes, a hollow is left whose six facets see only one another
      const SolidMesh cube(box(3, 3, 3));
      ErodingSkin     hollow(cube);
      const auto      is_middle = [&](const std::size_t c) {
        return (cube.centroid(c) - Point3(0.025, 0., 0.)).norm() < 1e-6;
      };
      hollow.remove(is_middle);
      hollow.offer(view);
      EXPECT_EQ(view.n_facets, 54u + 6u);
      EXPECT_EQ(expect_closed(cube, view) % 48, 6u) << "outer skin or hollow, not both";

      // 2 x 2 x 1, two diagonal ones go: those left touch at an edge only and stay apart
      const SolidMesh four(box(2, 2, 1));
      ErodingSkin     diagonal(four);
      diagonal.remove([&](const std::size_t c) {
        const Point3 x = four.centroid(c);
        return (x[0] < 0.025) == (x[1] < 0.);
      });
      diagonal.offer(view);
      EXPECT_EQ(view.n_facets, 12u);
      EXPECT_EQ(expect_closed(four, view), 6u);
    }

    TEST(ErodingSkin, FacesInThePlaneOfSymmetryAreNoFacets)
    {
      auto p      = box(3, 4, 1);
      p.is_halved = true;
      const SolidMesh half(p);
      ErodingSkin     skin(half);
      FacetsView      view;
      skin.remove([&](const std::size_t c) { return std::abs(half.centroid(c)[0] - 0.025) < 1e-6; });
      skin.offer(view);
      std::size_t n_symmetry = 0;
      for (std::size_t f = 0; f < view.n_facets; ++f)
        for (unsigned int k = 0; k < 4; ++k)
          {
            const bool is_on_plane =
              half.node(view.nodes[f][k])[1] == 0. && half.node(view.nodes[f][(k + 1) % 4])[1] == 0.;
            EXPECT_EQ(view.neighbor[f][k] == FacetsView::symmetry_edge, is_on_plane);
            n_symmetry += is_on_plane;
          }
      EXPECT_EQ(view.n_facets, 2u * 9u); // of each piece: two ends and two faces of 2, one edge
      EXPECT_EQ(n_symmetry, 2u * 4u);
    }
  } // namespace
} // namespace birdstrike::eroding_skin_test
