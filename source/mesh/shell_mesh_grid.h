#pragma once

#include <birdstrike/mesh/shell_mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// deal.II's side of a ShellMesh. Members in the order in which they depend on each other.
  struct ShellMesh::Grid
  {
    dealii::Triangulation<2, 3>               triangulation;
    std::unique_ptr<dealii::FESystem<2, 3>>   element;
    std::unique_ptr<dealii::DoFHandler<2, 3>> dofs;

    /// Plain arrays with vertex v called node_of_vertex[v].
    SurfaceMesh extract(const std::vector<std::uint32_t> &node_of_vertex) const;
  };
} // namespace birdstrike
