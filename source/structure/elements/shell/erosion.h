#pragma once

#include "structure/elements/erosion.h"

namespace birdstrike
{
  /// Erosion of shells: what a failed element was to the normals of its nodes becomes nothing.
  struct ShellErosion : Erosion
  {
    std::vector<std::uint32_t> entering_of; ///< [n_nodes], where a node is in the list of those that enter
    std::vector<unsigned char> has_new;     ///< [batches], points of a fully integrated one have failed in this step
  };
} // namespace birdstrike
