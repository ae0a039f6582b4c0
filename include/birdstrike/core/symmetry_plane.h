#pragma once

#include <birdstrike/core/energy_report.h>

namespace birdstrike
{
  /// From the computed half to the whole, the other half being its mirror image at y = 0. A part computes with what it
  /// holds and speaks of the whole at its face; nothing above knows.
  ///
  /// Scalars that add up double, vectors double in x and z and cancel in y, axial vectors (angular momentum) double in
  /// y and cancel in x and z. Positions, stresses and deflections stay. Without a plane all stays.
  class SymmetryPlane
  {
  public:
    explicit SymmetryPlane(const bool exists) : n(exists ? 2 : 1)
    {
    }

    unsigned int n_images() const ///< 2 with a plane, else 1
    {
      return n;
    }

    std::array<double, 3> whole(const std::array<double, 3> &a) const
    {
      return n == 2 ? std::array<double, 3>{{2. * a[0], 0., 2. * a[2]}} : a;
    }

    EnergyReport whole(EnergyReport energy) const
    {
      for (const EnergyKind &kind : energy_kinds)
        energy.*kind.value *= n;
      return energy;
    }

    MomentumReport whole(MomentumReport momentum) const
    {
      for (const MomentumKind &kind : momentum_kinds)
        if (auto &a = momentum.*kind.value; !kind.is_axial)
          a = whole(a);
        else if (n == 2)
          a = {{0., 2. * a[1], 0.}};
      for (const auto scale : momentum_scales)
        momentum.*scale *= n;
      return momentum;
    }

  private:
    unsigned int n;
  };
} // namespace birdstrike
