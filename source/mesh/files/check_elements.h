#pragma once

#include "mesh/files/imported_mesh.h"

namespace birdstrike
{
  /// Throws InputError, with ids, for elements (shells: dim 2, bricks: 3) that have a node more than once (collapsed to
  /// triangles or wedges) or the same nodes as another, and for an edge of shells, a face of bricks, that more than two
  /// of them share. deal.II (9.4, release) takes them all as they are, but for shells that branch: its ordering of
  /// quadrilaterals knows two cells of an edge, and may never end where there are three.
  template <int dim>
  void check_elements(const std::vector<ImportedMesh::Element> &elements, const std::string &path);
} // namespace birdstrike
