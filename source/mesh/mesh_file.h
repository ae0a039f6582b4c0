#pragma once

#include "mesh/files/imported_mesh.h"
#include <birdstrike/mesh/parameters.h>

#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// Reads `Mesh/File` and scales it: quadrilaterals (dim = 2) or hexahedra (dim = 3) in space, with boundary and
  /// material ids and their names. .msh (Gmsh), .inp (Abaqus if it begins with a '*' line, else UCD), .k .key .dyn
  /// (LS-DYNA), .vtk. Folded hexahedra pass, so that `check_cells` can name them.
  ///
  /// Throws InputError for a file that cannot be opened or read, that holds cells of another kind, or cells of the
  /// other dimension: then it says what was found and what is needed.
  template <int dim>
  MeshLabels read_mesh_file(const MeshParameters &parameters, dealii::Triangulation<dim, 3> &triangulation);
} // namespace birdstrike
