#pragma once

#include <birdstrike/core/energy_report.h>

namespace birdstrike
{
  /// From the computed half to the whole, the other half being its mirror image at y = 0. A part computes with what it
  /// holds and speaks of the whole at its face (views and fields excepted: they are what is computed); nothing above
  /// knows.
  ///
  /// Scalars that add up and numbers of entities double, vectors double in x and z and cancel in y, axial vectors
  /// (angular momentum) double in y and cancel in x and z. Positions, stresses and deflections stay. Without a plane
  /// all stays.
  class SymmetryPlane
  {
  public:
    SymmetryPlane() = default;
    explicit SymmetryPlane(const bool exists) : n(exists ? 2 : 1)
    {
    }

    bool exists() const
    {
      return n == 2;
    }

    double whole(const double sum) const
    {
      return n * sum;
    }

    std::size_t whole(const std::size_t count, const std::size_t n_on_plane = 0) const ///< those are their own images
    {
      return n * count - (n - 1) * n_on_plane;
    }

    std::array<double, 3> whole(const std::array<double, 3> &a) const
    {
      return exists() ? std::array<double, 3>{{2. * a[0], 0., 2. * a[2]}} : a;
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
        else if (exists())
          a = {{0., 2. * a[1], 0.}};
      for (const auto scale : momentum_scales)
        momentum.*scale *= n;
      for (const auto norm : largest_momenta)
        momentum.*norm *= n;
      return momentum;
    }

  private:
    unsigned int n = 1; ///< the half and its images
  };
} // namespace birdstrike
