#include "blade_case.h"

#include "structure/nodes/loads.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

// Where forces at places of a blade act.
namespace birdstrike::point_loads_test
{
  namespace
  {
    BladeParameters twisted(const unsigned int n_layers)
    {
      BladeParameters p      = test::elastic_plate(7, 4);
      p.kind                 = BladeKind::solid;
      p.mesh.n_layers        = n_layers;
      p.mesh.generator       = MeshGenerator::blade;
      p.mesh.profile.stagger = "40*s";
      p.mesh.profile.camber  = "0.05";
      return p;
    }

    template <int dim>
    std::vector<double> forces_of(BladeParameters p, const BladeMesh<dim> &mesh, const Point3 &place)
    {
      p.loads.point_loads = fmt::format("{:.17g} {:.17g} {:.17g}: 10; -20; 50", place[0], place[1], place[2]);
      std::vector<double> force(mesh.n_unknowns * mesh.nodes.size(), 0.);
      Loads(p.loads, mesh, {}).add_forces(0., mesh.nodes[0].data(), force.data());
      return force;
    }
  } // namespace

  // Bricks of a twisted cambered blade, of one layer and of three, whose middle has no node: force and moment are those
  // of the place on the mid-surface, in it or on a face, within round-off of weights (1e-9 of the size of a brick).
  TEST(PointLoads, OfASolidHaveForceAndMomentOfTheirPlace)
  {
    for (const unsigned int n_layers : {1u, 2u, 3u})
      {
        const BladeParameters p = twisted(n_layers);
        const SolidMesh       mesh(p);
        for (const std::size_t cell : {std::size_t(0), mesh.cells.size() / 2, mesh.cells.size() - 1})
          for (const auto &[u, v, w] : {std::array{0.5, 0.5, 0.5}, {1., 1., 0.5}, {0.3, 0.8, 0.1}, {0.2, 0., 1.}})
            {
              Point3 place = Point3::Zero();
              for (unsigned int c = 0; c < 8; ++c)
                place += (c & 1u ? u : 1. - u) * (c & 2u ? v : 1. - v) * (c & 4u ? w : 1. - w) *
                         mesh.node(mesh.cells[cell][c]);
              const auto force = forces_of(p, mesh, place);
              Point3     sum = Point3::Zero(), moment = Point3::Zero();
              for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
                {
                  const Point3 f(force.data() + 3 * n);
                  sum += f;
                  moment += (mesh.node(n) - place).cross(f);
                }
              EXPECT_LT((sum - Point3(10., -20., 50.)).norm(), 1e-12);
              EXPECT_LT(moment.norm(), 1e-9 * 50. * mesh.smallest_edge(cell) * 10.) << n_layers << " " << cell;
            }
      }
  }

  // At a node it is the node's alone, and beside the body that of the nearest place.
  TEST(PointLoads, OfASolidAtANodeAreItsOwn)
  {
    const BladeParameters p = twisted(1);
    const SolidMesh       mesh(p);
    const std::uint32_t   node  = mesh.cells[9][5];
    const auto            force = forces_of(p, mesh, mesh.node(node));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      EXPECT_EQ(force[3 * n + 2], n == node ? 50. : 0.);
    BladeParameters plate = test::elastic_plate(7, 4);
    plate.kind            = BladeKind::solid;
    plate.mesh.n_layers   = 1;
    const SolidMesh flat(plate);
    const Point3    corner(plate.mesh.length, 0.5 * plate.mesh.chord, 0.);
    const auto      beside = forces_of(plate, flat, corner + Point3(1e-3, 1e-3, 0.));
    for (std::size_t n = 0; n < flat.nodes.size(); ++n)
      EXPECT_NEAR(beside[3 * n + 2], (flat.node(n) - corner).norm() < 3e-3 ? 25. : 0., 1e-9);
  }

  // Of a shell the nearest node, as the entry says.
  TEST(PointLoads, OfAShellAreOfTheNearestNode)
  {
    const BladeParameters p = test::elastic_plate(7, 4);
    const ShellMesh       mesh(p);
    const std::uint32_t   node  = mesh.cells[9][2];
    const auto            force = forces_of(p, mesh, mesh.node(node) + Point3(1e-3, -1e-3, 0.));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      EXPECT_EQ(force[6 * n + 2], n == node ? 50. : 0.);
  }
} // namespace birdstrike::point_loads_test
