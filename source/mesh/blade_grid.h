#pragma once

#include "mesh/files/imported_mesh.h"
#include <birdstrike/mesh/blade_mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// deal.II's side of a BladeMesh. Members in the order in which they depend on each other.
  template <int dim>
  struct BladeMesh<dim>::Grid
  {
    using CellIterator = typename dealii::DoFHandler<dim, 3>::active_cell_iterator;

    dealii::Triangulation<dim, 3>             triangulation;
    MeshLabels                                labels;
    std::unique_ptr<dealii::FESystem<dim, 3>> element;
    dealii::DoFHandler<dim, 3>                dofs;
    std::vector<std::uint32_t>                node_of_vertex; ///< global
    bool                                      is_halved = false;
    MeshParameters::Row                       row;
    bool is_turned = false; ///< the normal of a shell looks against the first cell's

    /// Numbers the unknowns; of a body those on the skin first. Returns how many nodes these are.
    std::size_t distribute_dofs();

    static std::uint32_t node(const CellIterator &cell, const unsigned int vertex)
    {
      return static_cast<std::uint32_t>(cell->vertex_dof_index(vertex, 0) / n_unknowns);
    }

    std::uint32_t blade_of(unsigned int cell) const; ///< of the row
    /// Where the place x on a cell lies in the first blade of the row.
    Point3 as_first(unsigned int cell, const Point3 &x) const;

    NodeSpace make_space(std::uint32_t first, std::uint32_t last) const;

    /// Whether all nodes of a cell are.
    static bool is_here(const NodeSpace &space, const CellIterator &cell)
    {
      for (const unsigned int v : cell->vertex_indices())
        if (!space.has(node(cell, v)))
          return false;
      return true;
    }
  };
} // namespace birdstrike
