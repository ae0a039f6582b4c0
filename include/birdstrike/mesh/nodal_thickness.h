#pragma once

#include <birdstrike/mesh/blade_mesh.h>

#include <vector>

namespace birdstrike
{
  /// What section "Thickness" asks of a shell's mesh beyond the place: the thickness at nodes by `Table`, and, for
  /// `Maximum` on a mesh from a file, where the nodes lie between root and tip (s), leading and trailing edge (c).
  ///
  /// A table has a row a node, numbers between blanks or commas, '#' begins a comment: 'x y z thickness' in m, of the
  /// nearest node within a hundredth of the smallest edge, or 'node thickness' with the node's id in the mesh file
  /// (Abaqus, LS-DYNA, VTK). Rows of no node are passed over.
  ///
  ///   s = d_root / (d_root + d_tip)                           distances to the edges of root and tip,
  ///   c = (x - a).(b - a) / |b - a|^2, in [0, 1]              a, b: leading and trailing edge at this s.
  /// On the built-in plate both are its own; of a blade c is that of BladeShape where s is. Leading is the edge where
  /// the chord begins (orientation.h).
  ///
  /// Throws InputError for a table that cannot be read, is not positive or leaves out a node; for a blade without root
  /// or tip, or whose other edges are not two lines from one to the other.
  NodalThickness find_nodal_thickness(const GeometryParameters &parameters, const ShellMesh &mesh,
                                      const std::vector<unsigned int> &root_ids,
                                      const std::vector<unsigned int> &tip_ids);
} // namespace birdstrike
