#include "mesh/check_cells.h"

#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/number_text.h>

#include <deal.II/grid/grid_tools.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    template <class Point>
    std::string at(const Point &p)
    {
      const std::array<double, 3> place{{p[0], p[1], p[2]}};
      return point_text(place.data()) + " m";
    }

    template <class Cell>
    Point3 middle(const Cell &cell)
    {
      const auto p = cell->center();
      return {p[0], p[1], p[2]};
    }

    /// Neighbours agree if they run along their common edge in opposite directions.
    void check_normals(const CellMesh<2> &mesh)
    {
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        for (unsigned int side = 0; side < 4; ++side)
          if (const std::int32_t other = mesh.neighbors[cell][side]; other >= 0)
            for (unsigned int k = 0; k < 4; ++k)
              if (mesh.side_nodes(static_cast<std::size_t>(other), k) == mesh.side_nodes(cell, side))
                throw InputError("Mesh: the surface has only one side (like a Moebius band) near " +
                                 at(mesh.centroid(cell)) + ".\nA shell needs an upper and a lower face.");
    }

    void check_normals(const CellMesh<3> &)
    {
    }

    /// How pieces may be joined.
    std::string advice_of(const OpenSeams &seams)
    {
      if (seams.pairs.n > 0)
        return fmt::format("{} pairs of nodes lie within {:.3g} mm of one another, one at ({:.6g}, {:.6g}, {:.6g}) m: "
                           "merge coincident nodes (Gmsh: Coherence Mesh) with a tolerance above that.",
                           seams.pairs.n, 1e3 * seams.pairs.largest_gap, seams.pairs.at[0], seams.pairs.at[1],
                           seams.pairs.at[2]);
      return "No two nodes of the boundary lie on one another, so that merging nodes cannot join it: mesh the parts "
             "with "
             "common nodes, or remove the loose one.";
    }
  } // namespace

  template <int dim>
  void put_on_symmetry_plane(dealii::Triangulation<dim, 3> &triangulation)
  {
    double size = 0.;
    for (const auto &vertex : triangulation.get_vertices())
      size = std::max({size, std::abs(vertex[0]), std::abs(vertex[1]), std::abs(vertex[2])});
    dealii::GridTools::transform(
      [size](const dealii::Point<3> &p) {
        if (p[1] < -1e-6 * size)
          throw InputError("Mesh: a node at " + at(p) +
                           " lies beyond the symmetry plane y = 0.\nAllowed: the half y >= 0 of the blade.");
        return p[1] <= 1e-6 * size ? dealii::Point<3>(p[0], 0., p[2]) : p;
      },
      triangulation);
  }

  template <int dim>
  void check_cells(const dealii::Triangulation<dim, 3> &triangulation)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        constexpr unsigned int     n_corners = 1u << dim;
        dealii::Point<3>           x[n_corners];
        dealii::Tensor<3 - dim, 3> form[n_corners], mean;
        for (const unsigned int v : cell->vertex_indices())
          x[v] = cell->vertex(v);
        dealii::GeometryInfo<dim>::alternating_form_at_vertices(x, form);
        for (const auto &f : form)
          mean += f / n_corners;
        const double square  = mean * mean;
        bool         is_fine = square > 0.;
        for (const auto &f : form)
          is_fine = is_fine && f * mean > 1e-10 * square;
        if constexpr (dim == 3)
          is_fine = is_fine && mean > 0.;
        if (!is_fine)
          throw InputError("Mesh: cell " + std::to_string(cell->active_cell_index()) + " at " + at(middle(cell)) +
                           (dim == 2
                              ? " has a corner of zero or negative area (folded, crossed or collapsed).\n"
                                "Every quadrilateral must be convex; repair or re-mesh there."
                              : " has a corner without volume (folded, inside out or collapsed).\nThe Jacobian "
                                "of every hexahedron must be positive at its corners; repair or re-mesh there."));
      }
  }

  template <int dim>
  void check_connection(const CellMesh<dim> &mesh)
  {
    check_normals(mesh);
    std::vector<bool>        seen(mesh.cells.size(), false);
    std::vector<std::size_t> reached{0};
    seen[0] = true;
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (const std::int32_t other : mesh.neighbors[reached[k]])
        if (other >= 0 && !seen[static_cast<std::size_t>(other)])
          {
            seen[static_cast<std::size_t>(other)] = true;
            reached.push_back(static_cast<std::size_t>(other));
          }
    if (reached.size() < mesh.cells.size())
      throw InputError(
        std::string("Mesh: the ") + (dim == 2 ? "surface" : "body") + " falls into pieces; only " +
        std::to_string(reached.size()) + " of " + std::to_string(mesh.cells.size()) + " cells hang together by whole " +
        (dim == 2 ? "edges" : "faces") + ", and that at " +
        at(mesh.centroid(static_cast<std::size_t>(std::find(seen.begin(), seen.end(), false) - seen.begin()))) +
        " does not.\n" + advice_of(mesh.open_seams));
  }

  void refuse_edge(const Point3 &place)
  {
    throw InputError("Mesh: cells share an edge only, near " + at(place) +
                     ".\nCells of a body share whole faces or nothing; join them or part them there.");
  }

  template void put_on_symmetry_plane(dealii::Triangulation<2, 3> &);
  template void put_on_symmetry_plane(dealii::Triangulation<3> &);
  template void check_cells(const dealii::Triangulation<2, 3> &);
  template void check_cells(const dealii::Triangulation<3> &);
  template void check_connection(const CellMesh<2> &);
  template void check_connection(const CellMesh<3> &);
} // namespace birdstrike
