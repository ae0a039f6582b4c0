#pragma once

#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/core/closest_point.h>
#include <birdstrike/core/contact_views.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace birdstrike::test
{
  /// Whether the segment from a to b goes through the triangle (Moeller and Trumbore 1997).
  inline bool crosses(const Point3 &a, const Point3 &b, const Point3 &x0, const Point3 &x1, const Point3 &x2)
  {
    const Point3 d = b - a, e1 = x1 - x0, e2 = x2 - x0, p = d.cross(e2);
    const double det = e1.dot(p);
    if (std::abs(det) < 1e-9 * d.norm() * e1.norm() * e2.norm()) // in its plane
      return false;
    const Point3 s = a - x0, q = s.cross(e1);
    const double u = s.dot(p) / det, v = d.dot(q) / det, t = e2.dot(q) / det;
    return u > 0. && v > 0. && u + v < 1. && t > 0. && t < 1.;
  }

  /// The positions of the nodes, [n_nodes][3], moved inwards along the mean normal of their facets by `depth` (m).
  inline std::vector<double> shrink(const FacetsView &facets, const double depth)
  {
    std::vector<Point3> normal(facets.n_nodes, Point3(0., 0., 0.));
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (const std::uint32_t n : facets.nodes[f])
        normal[n] += compute_area_vector(facet_nodes(facets, f)).normalized();
    std::vector<double> position(facets.position, facets.position + 3 * facets.n_nodes);
    for (std::size_t n = 0; n < facets.n_nodes; ++n)
      for (unsigned int d = 0; d < 3; ++d)
        position[3 * n + d] -= depth * normal[n].normalized()[d];
    return position;
  }

  /// Number of pairs of an edge of the surface and a facet, without a common node, of which one goes through the other
  /// (of a solid: deeper than `depth` on either side). It knows nothing of how contact works.
  inline std::size_t count_crossings(FacetsView facets, const double depth = 0.)
  {
    const std::vector<double> moved = shrink(facets, depth);
    facets.position                 = moved.data();
    FacetGrid grid;
    grid.update(facets, 0.);
    const auto at = [&](const std::uint32_t n) { return Point3(facets.position + 3 * n); };
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        if (const std::uint32_t a = facets.nodes[f][k], b = facets.nodes[f][(k + 1) % 4]; a != b)
          edges.insert(std::minmax(a, b));
    std::size_t n = 0;
    for (const auto &[a, b] : edges)
      {
        Box box;
        box.add(facets.position + 3 * a);
        box.add(facets.position + 3 * b);
        std::set<std::uint32_t> near;
        grid.visit_near(box, [&](const std::uint32_t f) { near.insert(f); });
        for (const std::uint32_t f : near)
          {
            const auto &c = facets.nodes[f];
            if (std::find(c.begin(), c.end(), a) != c.end() || std::find(c.begin(), c.end(), b) != c.end())
              continue;
            n += crosses(at(a), at(b), at(c[0]), at(c[1]), at(c[2])) ||
                 crosses(at(a), at(b), at(c[0]), at(c[2]), at(c[3]));
          }
      }
    return n;
  }
} // namespace birdstrike::test
