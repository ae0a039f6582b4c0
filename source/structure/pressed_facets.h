#pragma once

#include "structure/nodes/loads.h"

namespace birdstrike
{
  /// The quadrilaterals that the loads' pressure acts on, and the elements behind them; none without a pressure.
  struct PressedFacets
  {
    std::vector<Loads::Quadrilateral> facets;
    std::vector<std::uint32_t>        elements;
  };
} // namespace birdstrike
