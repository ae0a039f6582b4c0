#include <birdstrike/core/energy_report.h>

namespace birdstrike
{
  void archive(Archive &archive, const char *name, EnergyReport &energy)
  {
    const auto group = archive.group(name);
    for (const EnergyKind &kind : energy_kinds)
      archive(kind.name, energy.*kind.value);
  }

  void archive(Archive &archive, const char *name, MomentumReport &momentum)
  {
    const auto group = archive.group(name);
    for (const MomentumKind &kind : momentum_kinds)
      archive(kind.name, momentum.*kind.value);
    archive("scales", momentum.impulse_scale, momentum.moment_scale);
  }
} // namespace birdstrike
