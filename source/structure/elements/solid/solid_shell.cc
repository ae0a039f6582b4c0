#include "structure/elements/solid/group.h"

namespace birdstrike
{
  // Apart, so that the elastic path has the registers for itself.
  [[gnu::flatten]] solid_shell::LayerWork<Lanes> SolidGroup::update_layers(const std::size_t b, const double dt,
                                                                           const SolidModes<Lanes> &end)
  {
    const solid_shell::Layers<Lanes> section{law, rule};
    if (layers[b].empty())
      {
        layers[b].resize(rule.n);
        section.promote(layers[b].data());
      }
    return section.update(end, one_point_solid::Axes<Lanes>(end), dt, points[b], stabilisation[b], layers[b].data());
  }
} // namespace birdstrike
