#pragma once

#include "mesh/files/imported_mesh.h"

namespace birdstrike
{
  /// Leaves of the elements of dimension `dim` and above those of these parts, names of groups or their numbers (of
  /// `Blade/Mesh/Parts`); empty: all. Elements of less dimensions stay, for they only name sides. Groups that are parts
  /// only are dropped, and ids become those of the file.
  ///
  /// Throws InputError for names that are no parts, for parts without such elements, for parts of several lists of
  /// nodes, and for what is not offered and belongs to what stays: the first in the file is named.
  void keep_parts(ImportedMesh &mesh, unsigned int dim, const std::string &parts, const std::string &path);
} // namespace birdstrike
