#pragma once

#include <birdstrike/mesh/solid_mesh.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// deal.II's side of a SolidMesh. Members in the order in which they depend on each other.
  struct SolidMesh::Grid
  {
    dealii::Triangulation<3>               triangulation;
    std::unique_ptr<dealii::FESystem<3>>   element;
    std::unique_ptr<dealii::DoFHandler<3>> dofs;

    /// Cells with all faces of the boundary, nodes named as deal.II's vertices; no skin yet.
    VolumeMesh extract() const;
  };
} // namespace birdstrike
