#include "contact/touch/edge_frame.h"
#include <birdstrike/contact/plane_folds.h>
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace birdstrike
{
  namespace
  {
    constexpr double round_off = 1e-6; // of an angle

    double degrees(const double angle)
    {
      return 180. / std::numbers::pi * angle;
    }
  } // namespace

  void refuse_folds_on_plane(const FacetsView &facets)
  {
    if (!facets.plane.exists())
      return;
    for (std::size_t f = 0; f < facets.n_facets; ++f)
      for (unsigned int k = 0; k < 4; ++k)
        {
          if (facets.neighbor[f][k] != FacetsView::symmetry_edge)
            continue;
          const Point3    a = node_at(facets, facets.nodes[f][k]), b = node_at(facets, facets.nodes[f][(k + 1) % 4]);
          const EdgeFrame face     = edge_frame(facets, static_cast<std::int32_t>(f), a, b);
          const double    angle    = 2. * std::asin(std::min(std::abs(face.normal[1]), 1.)); // to its mirror image
          const bool      is_ridge = !facets.two_sided && face.normal[1] > 0.;
          if (const double allowed = is_ridge ? blunt_ridge : std::acos(share_starts_at); angle > allowed + round_off)
            throw InputError(fmt::format(
              "Case/Symmetry plane: at ({:.4g}, 0, {:.4g}) m the blade's surface meets its mirror image in a {} of "
              "{:.0f} degrees. Half a scene cannot represent contact there.\n  Allowed: {:.0f} degrees between the "
              "normals.\n  Action: compute the whole blade, with Case/Symmetry plane = none.",
              0.5 * (a[0] + b[0]), 0.5 * (a[2] + b[2]), is_ridge ? "feature edge" : "fold", degrees(angle),
              degrees(allowed)));
        }
  }
} // namespace birdstrike
