#include <birdstrike/contact/facet_grid.h>
#include <birdstrike/contact/mass_in_the_way.h>
#include <birdstrike/contact/surface_topology.h>
#include <birdstrike/core/closest_point.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace birdstrike
{
  namespace
  {
    using Quadrilateral = std::array<Point3, 4>;

    /// Of coordinates in a triangle: a path along the edge of two meets one of them.
    constexpr double slack = 1e-9;

    std::vector<Quadrilateral> make_outline(const FacetsView &facets)
    {
      std::vector<Quadrilateral> outline;
      SurfaceTopology            topology;
      topology.update(facets);
      std::vector<Point3> across(facets.n_nodes, Point3::Zero()); // half the thickness, along the normal
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        for (const std::uint32_t node : facets.nodes[f])
          across[node] += compute_area_vector(facet_nodes(facets, f));
      for (std::uint32_t n = 0; n < facets.n_nodes; ++n)
        if (across[n].squaredNorm() > 0.)
          across[n] *= topology.half_thickness(n) / across[n].norm();
      for (std::size_t f = 0; f < facets.n_facets; ++f)
        {
          const auto   &nodes = facets.nodes[f];
          Quadrilateral x = facet_nodes(facets, f), below = x;
          for (unsigned int k = 0; k < 4; ++k)
            {
              x[k] += across[nodes[k]];
              below[k] -= across[nodes[k]];
            }
          outline.push_back(x);
          if (topology.max_half_thickness() == 0.)
            continue;
          outline.push_back(below);
          for (unsigned int k = 0; k < 4; ++k)
            if (const unsigned int l = (k + 1) % 4; is_edge(nodes, k) && facets.neighbor[f][k] == FacetsView::free_edge)
              outline.push_back({x[k], x[l], below[l], below[k]});
        }
      return outline;
    }

    /// Paths, as points of the plane across them, in a grid of square cells.
    class Paths
    {
    public:
      Paths(const PointsView &points, const Point3 &direction)
        : along(direction), first(direction.unitOrthogonal()), second(direction.cross(first)), is_hit(points.n, 0)
      {
        for (std::size_t i = 0; i < points.n; ++i)
          {
            at.push_back(turned({points.position[0][i], points.position[1][i], points.position[2][i]}));
            low  = i == 0 ? at[0] : Point3(low.cwiseMin(at[i]));
            high = i == 0 ? at[0] : Point3(high.cwiseMax(at[i]));
          }
        n_cells = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(points.n))));
        cell    = std::max({high[0] - low[0], high[1] - low[1], 1e-300}) / static_cast<double>(n_cells) * (1. + 1e-9);
        cells.resize(n_cells * n_cells);
        for (std::size_t i = 0; i < points.n; ++i)
          cells[number(at[i][0], 0) + n_cells * number(at[i][1], 1)].push_back(i);
      }

      void meet(const Quadrilateral &x)
      {
        const Point3 centre = turned(0.25 * (x[0] + x[1] + x[2] + x[3]));
        for (unsigned int k = 0; k < 4; ++k)
          meet_triangle(centre, turned(x[k]), turned(x[(k + 1) % 4]));
      }

      bool has_met(const std::size_t point) const
      {
        return is_hit[point] != 0;
      }

    private:
      Point3 turned(const Point3 &p) const
      {
        return {first.dot(p), second.dot(p), along.dot(p)};
      }

      std::size_t number(const double value, const unsigned int d) const
      {
        return static_cast<std::size_t>(std::clamp((value - low[d]) / cell, 0., static_cast<double>(n_cells) - 1.));
      }

      void meet_triangle(const Point3 &a, const Point3 &b, const Point3 &c)
      {
        const Point3 least = a.cwiseMin(b).cwiseMin(c), most = a.cwiseMax(b).cwiseMax(c);
        const double det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (det == 0. || (least - high).head<2>().maxCoeff() > 0. || (low - most).head<2>().maxCoeff() > 0.)
          return;
        for (std::size_t j = number(least[1], 1); j <= number(most[1], 1); ++j)
          for (std::size_t i = number(least[0], 0); i <= number(most[0], 0); ++i)
            for (const std::size_t point : cells[i + n_cells * j])
              {
                const Point3 p = at[point] - a;
                const double s = (p[0] * (c[1] - a[1]) - p[1] * (c[0] - a[0])) / det,
                             t = ((b[0] - a[0]) * p[1] - (b[1] - a[1]) * p[0]) / det;
                if (s >= -slack && t >= -slack && s + t <= 1. + slack && s * (b[2] - a[2]) + t * (c[2] - a[2]) >= p[2])
                  is_hit[point] = 1;
              }
      }

      Point3                                along, first, second, low{0., 0., 0.}, high{0., 0., 0.};
      std::vector<Point3>                   at; // across, across, along
      std::vector<unsigned char>            is_hit;
      std::size_t                           n_cells = 1;
      double                                cell    = 0.; // m
      std::vector<std::vector<std::size_t>> cells;
    };
  } // namespace

  double compute_share_in_the_way(const PointsView &points, const FacetsView &facets, const Point3 &velocity)
  {
    if (points.n == 0 || facets.n_facets == 0)
      return 0.;
    if (velocity.norm() == 0.)
      return 0.;
    Paths paths(points, velocity.normalized());
    for (const Quadrilateral &quadrilateral : make_outline(facets))
      paths.meet(quadrilateral);
    double met = 0., all = 0.;
    for (std::size_t i = 0; i < points.n; ++i)
      {
        met += paths.has_met(i) ? points.mass[i] : 0.;
        all += points.mass[i];
      }
    return met / all;
  }
} // namespace birdstrike
