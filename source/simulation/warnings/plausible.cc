#include "simulation/warnings/plausible.h"

#include <fmt/format.h>

namespace birdstrike
{
  void check(const Plausible &p, Warnings &warnings)
  {
    if (p.value >= p.lowest && p.value <= p.highest)
      return;
    std::string text = fmt::format("{} = {:.6g} {}: such values are between {:.3g} and {:.3g}.", p.entry, p.value,
                                   p.unit, p.lowest, p.highest);
    for (const Plausible::Unit &other : p.others)
      if (const double meant = p.value * other.factor; meant >= p.lowest && meant <= p.highest)
        {
          text += fmt::format(" Was it meant in {}? That would be {:.6g} {}.", other.name, meant, p.unit);
          break;
        }
    warnings.push_back({"unit/" + p.code, text});
  }
} // namespace birdstrike
