#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace birdstrike
{
  /// Where the boundary of a mesh from a file nearly meets itself and is not joined: pairs of nodes, and nodes that lie
  /// beside an edge (of bricks: a face) of an element that has none there.
  struct OpenSeams
  {
    static constexpr double near = 0.02; ///< within this share of the smallest height of the elements at both

    struct Found
    {
      std::size_t                 n           = 0;              ///< pairs, or nodes
      double                      largest_gap = 0.;             ///< m
      double                      share       = 0.;             ///< of that height, of the same
      Point3                      at          = Point3::Zero(); ///< m, of the same, as are the next two
      std::array<std::int64_t, 2> labels{};                     ///< nodes; or the node and the element beside it
    };
    Found pairs, beside;
  };
} // namespace birdstrike
