#pragma once

#include <birdstrike/core/symmetry_plane.h>
#include <birdstrike/report/ledger.h>
#include <birdstrike/structure/reports.h>

namespace birdstrike
{
  inline constexpr const char *symmetry_sentence = "Symmetry plane y = 0: half of the scene is computed; energies, "
                                                   "momenta, forces, masses and counts are those of the "
                                                   "whole.";

  /// From the computed half to the whole scene, the other half being its mirror image at y = 0. Parts speak of what
  /// they hold; the scene and what is observed of it speak of the whole, and nothing else needs to know.
  ///
  /// Scalars that add up double, vectors double in x and z and cancel in y, axial vectors (angular momentum) double in
  /// y and cancel in x and z. Positions, stresses and deflections stay.
  class Symmetry
  {
  public:
    explicit Symmetry(const bool is_mirrored = false) : mirrored(is_mirrored)
    {
    }

    bool is_mirrored() const
    {
      return mirrored;
    }
    /// 2 with a plane, else 1.
    unsigned int factor() const
    {
      return mirrored ? 2 : 1;
    }

    std::array<double, 3> whole(std::array<double, 3> vector) const
    {
      return SymmetryPlane(mirrored).whole(vector);
    }
    RootSectionReport whole(RootSectionReport root) const; ///< forces and moment; stresses as they are
    FailureReport     whole(FailureReport failure) const;
    SystemState       whole(SystemState state) const;

  private:
    bool mirrored;
  };
} // namespace birdstrike
