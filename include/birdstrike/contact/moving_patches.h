#pragma once

#include <birdstrike/contact/parameters.h>
#include <birdstrike/core/contact_views.h>

#include <array>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Pressure patches whose centres go with the surface. A centre c is held by the point of the surface nearest to it
  /// at first, q = sum_k w_k x_k of one facet, and has constant coordinates l from there in the facet's own axes,
  ///   c = c_0 + g(x) - g(x_0),   g = sum_k w_k x_k + R l,   l = R_0^T (c_0 - q_0),
  /// R of a diagonal of the facet and its normal: a surface that moves as a whole takes it along, one at rest leaves
  /// c_0 to the last bit. Without a surface to hold them patches lie still.
  class MovingPatches
  {
  public:
    explicit MovingPatches(std::vector<PressurePatch> patches);

    /// Finds where they are held, and how much of each disc the surface covers, seen along the normal there: pressure
    /// is over that. Throws InputError for one whose disc nothing of the surface lies in.
    void hold(const FacetsView &facets);

    const std::vector<PressurePatch> &move(const FacetsView &facets); ///< to where the surface is

  private:
    struct Anchor
    {
      std::array<std::uint32_t, 4> nodes{};
      std::array<double, 4>        weights{};
      Point3                       own   = Point3::Zero(); ///< l, m
      Point3                       start = Point3::Zero(); ///< g(x_0), m

      Point3 place(const FacetsView &facets) const; ///< g
    };

    std::vector<PressurePatch> first, moved;
    std::vector<Anchor>        anchors; ///< of each patch, once they are held
  };
} // namespace birdstrike
