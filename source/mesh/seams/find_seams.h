#pragma once

#include "mesh/seams/rim.h"
#include <birdstrike/mesh/open_seams.h>

#include <optional>
#include <vector>

namespace birdstrike
{
  /// A node on an edge (of bricks: on a face) of an element that does not have it.
  struct HangingNode
  {
    std::uint32_t node, side; ///< of the rim
  };

  struct Seams
  {
    std::vector<HangingNode> hanging; ///< sorted, each node once
    OpenSeams                open;    ///< its labels are vertices and cells
  };

  /// Where a rim meets itself without being joined. Only nodes and sides of the rim are looked at: what is joined has
  /// none between.
  ///
  /// A node hangs on a side of a cell that does not have it if it lies there between the corners and the mesh goes on
  /// from it on the other side: of shells an edge of the rim at the node runs along the side (30 degrees), and its
  /// cell does not lie over that of the side (30 degrees); of bricks a face at the node looks into the side. Two
  /// distances count as "there":
  ///   - 1e-3 of the smallest height of the cells at both, the tolerance of CAD surfaces (1 to 10 um) on elements of 1
  ///     to 10 mm; along the normal of a shell by twice what an edge of the surface bows out of its chord more;
  ///   - a tenth of an edge where the boundary runs through the node from one of its ends to the other, however curved
  ///     (8 elements on a half circle bow by a twentieth): no sound hole is as thin.
  /// Slits, cracks, folds, thin edges and parts that nearly touch are left alone: their nodes lie on nodes, or farther
  /// off, or look the other way.
  ///
  /// What nearly meets otherwise, within OpenSeams::near, is counted in `open`. O(n log n).
  Seams find_seams(const Rim &rim);
} // namespace birdstrike
