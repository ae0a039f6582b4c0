#include "mesh/seams/rim.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    /// Corners of a side in a ring, from deal.II's order; of an edge the second again.
    template <int dim>
    constexpr std::array<unsigned int, 4> ring = dim == 2 ? std::array{0u, 1u, 1u, 1u} : std::array{0u, 1u, 3u, 2u};

    Point3 at(const dealii::Point<3> &p)
    {
      return {p[0], p[1], p[2]};
    }

    template <class Cell>
    Point3 mean_edge(const Cell &cell, const unsigned int axis)
    {
      Point3 sum = Point3::Zero();
      for (const unsigned int v : cell->vertex_indices())
        sum += (v >> axis & 1u ? 1. : -1.) * at(cell->vertex(v));
      return 2. / static_cast<double>(cell->n_vertices()) * sum;
    }

    template <class Cell>
    double shortest_edge(const Cell &cell)
    {
      double shortest = INFINITY;
      for (const unsigned int line : cell->line_indices())
        shortest = std::min(shortest, (at(cell->line(line)->vertex(1)) - at(cell->line(line)->vertex(0))).norm());
      return shortest;
    }

    template <class Cell>
    Point3 normal_of_shell(const Cell &cell)
    {
      return 0.5 * (at(cell->vertex(3)) - at(cell->vertex(0))).cross(at(cell->vertex(2)) - at(cell->vertex(1)));
    }

    template <class Cell>
    double size_of(const Cell &cell)
    {
      const Point3 a = mean_edge(cell, 0), b = mean_edge(cell, 1);
      const double area = a.cross(b).norm();
      if constexpr (Cell::AccessorType::structure_dimension == 2)
        return std::min(shortest_edge(cell), area / std::max(a.norm(), b.norm()));
      const Point3 c = mean_edge(cell, 2);
      return std::min(shortest_edge(cell),
                      std::abs(a.cross(b).dot(c)) / std::max({area, b.cross(c).norm(), c.cross(a).norm()}));
    }

    /// From a side to the middle of its cell, square to the side.
    Point3 inward_of(const std::array<Point3, 4> &x, const bool is_edge, const Point3 &centre)
    {
      if (is_edge)
        {
          const Point3 along = (x[1] - x[0]).normalized(), off = centre - 0.5 * (x[0] + x[1]);
          return (off - off.dot(along) * along).normalized();
        }
      const Point3 normal = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
      return normal.dot(centre - x[0]) > 0. ? normal : Point3(-normal);
    }
  } // namespace

  template <int dim>
  Rim::Rim(const dealii::Triangulation<dim, 3> &triangulation) : n_corners(dim == 2 ? 2 : 4)
  {
    for (const auto &vertex : triangulation.get_vertices())
      x.push_back(at(vertex));
    normal.assign(x.size(), Point3::Zero());
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        if constexpr (dim == 2)
          for (const unsigned int v : cell->vertex_indices())
            {
              Point3      &sum = normal[cell->vertex_index(v)];
              const Point3 own = normal_of_shell(cell);
              sum += sum.dot(own) < 0. ? Point3(-own) : own;
            }
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            {
              Side                  side{};
              std::array<Point3, 4> corners;
              for (unsigned int k = 0; k < 4; ++k)
                {
                  side.nodes[k] = cell->face(f)->vertex_index(ring<dim>[k]);
                  corners[k]    = x[side.nodes[k]];
                }
              for (unsigned int k = 0; k < 8; ++k)
                side.of_cell[k] = cell->vertex_index(k % cell->n_vertices());
              side.cell   = cell->active_cell_index();
              side.size   = size_of(cell);
              side.inward = inward_of(corners, dim == 2, at(cell->center()));
              sides.push_back(side);
            }
      }
    for (Point3 &n : normal)
      n.normalize(); // zero stays zero
    sort_sides();
  }

  void Rim::sort_sides()
  {
    begin.assign(x.size() + 1, 0);
    for (const Side &side : sides)
      for (unsigned int k = 0; k < n_corners; ++k)
        ++begin[side.nodes[k] + 1];
    for (std::size_t n = 0; n < x.size(); ++n)
      begin[n + 1] += begin[n];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    side_of.resize(begin.back());
    for (std::uint32_t s = 0; s < sides.size(); ++s)
      for (unsigned int k = 0; k < n_corners; ++k)
        side_of[next[sides[s].nodes[k]]++] = s;
  }

  bool Rim::is_of_cell(const std::uint32_t node, const Side &side) const
  {
    return std::ranges::find(side.of_cell, node) != side.of_cell.end();
  }

  double Rim::size_at(const std::uint32_t node) const
  {
    double smallest = INFINITY;
    for (const std::uint32_t s : sides_at(node))
      smallest = std::min(smallest, sides[s].size);
    return smallest;
  }

  double Rim::bow(const Side &side) const
  {
    if (n_corners != 2)
      return 0.;
    const double angle = std::acos(std::min(1., std::abs(normal[side.nodes[0]].dot(normal[side.nodes[1]]))));
    return std::min(0.1, 0.25 * angle) * (x[side.nodes[1]] - x[side.nodes[0]]).norm();
  }

  template Rim::Rim(const dealii::Triangulation<2, 3> &);
  template Rim::Rim(const dealii::Triangulation<3, 3> &);
} // namespace birdstrike
