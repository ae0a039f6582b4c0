#pragma once

#include <birdstrike/mesh/parameters.h>

#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// Reads `Mesh/File` by deal.II's reader and scales it: quadrilaterals (dim = 2) or hexahedra (dim = 3) in space,
  /// with boundary and material ids; .msh (Gmsh 2 and 4), .inp (UCD, or Abaqus if it begins with a '*' line) and .vtk.
  /// Folded hexahedra pass, so that `check_shape` can name them.
  ///
  /// Throws InputError for a file that cannot be opened or read, that holds cells of another kind, or cells of the
  /// other dimension: then it says what was found and what is needed.
  template <int dim>
  void read_mesh_file(const MeshParameters &parameters, dealii::Triangulation<dim, 3> &triangulation);
} // namespace birdstrike
