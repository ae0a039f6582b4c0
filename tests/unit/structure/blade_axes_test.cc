#include "blade_case.h"
#include "structure/histories/axes.h"

#include <birdstrike/mesh/blade_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Span, chord and normal of a blade at a place.
namespace birdstrike::blade_axes_test
{
  namespace
  {
    /// Sections turn about the span: n = (-r k, -sin a, cos a)/norm at the distance r from it, a = from + k x.
    BladeParameters twisted(const double from, const double to)
    {
      BladeParameters p      = test::elastic_plate(28, 8);
      p.mesh.generator       = MeshGenerator::blade;
      p.mesh.profile.stagger = std::to_string(from) + " + s*(" + std::to_string(to - from) + ")";
      return p;
    }
  } // namespace

  // At the middle of an element its four nodes are equally near: their normals are turned by half the twist of an
  // element, 40/28/2 degrees = 12e-3, to either side. Between them it is that of the helicoid but for the square of
  // this, 2e-4. The order of the mesh changes round-off alone.
  TEST(BladeAxes, AtTheMiddleOfAnElementAreThoseThere)
  {
    const BladeParameters p = twisted(20., 60.);
    const ShellMesh       mesh(p);
    const BladeRoles      roles(mesh, {0}, {1}, {});
    SurfaceMesh           other = mesh;
    std::reverse(other.cells.begin(), other.cells.end());
    for (auto &cell : other.cells)
      std::rotate(cell.begin(), cell.begin() + 1, cell.end());
    const double k = 40. * M_PI / 180. / p.mesh.length;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const Point3 x = mesh.centroid(cell);
        if (std::abs(x[0] - 0.5 * p.mesh.length) > 0.4 * p.mesh.length || x.tail<2>().norm() > 0.4 * p.mesh.chord)
          continue; // at edges nodes have the facets of one side alone
        const double a = 20. * M_PI / 180. + k * x[0], r = x[1] * std::cos(a) + x[2] * std::sin(a);
        const Point3 normal = Point3(-r * k, -std::sin(a), std::cos(a)).normalized();
        const auto   axes   = find_blade_axes(mesh, roles, x, "Axes");
        EXPECT_LT((axes.row(2).transpose() - normal).norm(), 3e-4) << cell;
        EXPECT_LT((axes - find_blade_axes(other, roles, x, "Axes")).norm(), 1e-12) << cell;
      }
  }

  // A blade whose sections turn from 70 to 110 degrees to y: the chord runs from the edge at which it begins at the
  // root to the other everywhere, (0, cos a, sin a) within the twist of an element, 1.4 degrees.
  TEST(BladeAxes, TheChordRunsOnWhereTheStaggerPassesARightAngle)
  {
    const BladeParameters p = twisted(70., 110.);
    const ShellMesh       mesh(p);
    const BladeRoles      roles(mesh, {0}, {1}, {});
    for (const double s : {0.1, 0.4, 0.49, 0.51, 0.6, 0.9})
      {
        const double a     = (70. + 40. * s) * M_PI / 180.;
        const Point3 chord = find_blade_axes(mesh, roles, Point3(s * p.mesh.length, 0., 0.), "Axes").row(1).transpose();
        EXPECT_LT((chord - Point3(0., std::cos(a), std::sin(a))).norm(), 0.025) << s;
      }
  }
} // namespace birdstrike::blade_axes_test
