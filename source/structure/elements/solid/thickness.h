#pragma once

#include <birdstrike/core/number.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  namespace solid_shell
  {
    /// Which axis of each cell is its thickness: the one along which the way through the mesh, from skin to skin, is
    /// shortest, whatever the edges of the cells are; the third (of a built-in mesh the direction of the layers) where
    /// no other is shorter by a hundredth, as in a cube. And how many cells this way has.
    struct Thickness
    {
      std::vector<std::uint8_t>  axis;
      std::vector<std::uint32_t> n_layers;
    };
    Thickness find_thickness(const std::vector<Point3> &nodes, const std::vector<std::array<std::uint32_t, 8>> &cells);

    /// Turns the axes of the cells so that the given ones become the third, orientation kept; none given: as they are.
    std::vector<std::array<std::uint32_t, 8>> with_third(const std::vector<std::uint8_t>          &axes,
                                                         std::vector<std::array<std::uint32_t, 8>> cells);
  } // namespace solid_shell
} // namespace birdstrike
