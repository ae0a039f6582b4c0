#include <birdstrike/core/energy_report.h>
#include <birdstrike/core/simd/larger.h>

#include <algorithm>

namespace birdstrike
{
  void add(EnergyReport &sum, const EnergyReport &one)
  {
    for (const EnergyKind &kind : energy_kinds)
      sum.*kind.value += one.*kind.value;
  }

  void add(MomentumReport &sum, const MomentumReport &one)
  {
    for (const MomentumKind &kind : momentum_kinds)
      for (unsigned int d = 0; d < 3; ++d)
        (sum.*kind.value)[d] += (one.*kind.value)[d];
    for (const auto scale : momentum_scales)
      sum.*scale += one.*scale;
    for (const auto norm : largest_momenta)
      sum.*norm = larger(sum.*norm, one.*norm);
  }

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
    archive("largest", momentum.largest_momentum, momentum.largest_angular_momentum);
  }
} // namespace birdstrike
