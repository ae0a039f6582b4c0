#include "structure/elements/solid/group.h"
#include <birdstrike/core/simd/flatten.h>

namespace birdstrike
{
  void SolidGroup::promote(const std::size_t b)
  {
    layers[b].resize(rule.n);
    solid_shell::Layers<Lanes>{law, rule}.promote(layers[b].data());
  }

  // Apart, so that the elastic path has the registers for itself.
  BIRDSTRIKE_FLATTEN solid_shell::LayerWork<Lanes> SolidGroup::update_layers(const std::size_t b, const double dt,
                                                                             const LanesMask         &can_yield,
                                                                             const SolidModes<Lanes> &end)
  {
    const solid_shell::Layers<Lanes> section{law, rule};
    if (layers[b].empty())
      promote(b);
    return section.update(end, one_point_solid::Axes<Lanes>(end), dt, can_yield, points[b], stabilisation[b],
                          layers[b].data());
  }
} // namespace birdstrike
