#pragma once

#include "mesh/files/imported_mesh.h"
#include <birdstrike/mesh/open_seams.h>

#include <deal.II/grid/tria.h>

namespace birdstrike
{
  /// Throws InputError for nodes that hang on edges (of bricks: faces) of elements without them, see find_seams, with
  /// ids of the file. Returns what is nearly joined, labelled likewise.
  template <int dim>
  OpenSeams check_seams(const dealii::Triangulation<dim, 3> &triangulation, const MeshLabels &labels,
                        const std::string &path);
} // namespace birdstrike
