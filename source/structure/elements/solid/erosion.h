#pragma once

#include "structure/elements/erosion.h"
#include "structure/elements/solid/modes.h"

namespace birdstrike
{
  /// Erosion of bricks, with a ledger of each: the work that its forces have taken, trapezoidal as that of the nodes,
  /// less what it has dissipated. That is the energy that it stores in the mean stress and in the stabilisation, and
  /// what is eroded when it fails: elastic energy is that of the others to round-off, whatever the path. A point of a
  /// B-bar brick that fails before its element gives away its own part: with the energy density u of its stress s at
  /// the end of the step, u - s de/2, since its force of the end does no work (see shell/failure.h).
  ///
  /// Of the one-point brick damage knows one point. Its stress is the mean of the element; the stabilisation, which is
  /// its bending and torsion, flows with it (SolidFlow) and counts in the von Mises stress of the triaxiality, not in
  /// the mean stress: in pure bending one layer is at triaxiality 0, between its stretched face (1/3) and its
  /// compressed one (-1/3), and the brick fails as a whole. Bricks of several layers tell the faces apart.
  struct SolidErosion : Erosion
  {
    struct OfElements
    {
      SolidModes<Lanes> force;         ///< N, of the last step, on the modes
      Lanes             held     = 0.; ///< J
      Lanes             inverted = 0.; ///< 1 where turned inside out in the present step
    };
    AlignedVector<OfElements> elements; ///< [batches]

    std::size_t bytes() const
    {
      return Erosion::bytes() + elements.capacity() * sizeof(OfElements);
    }
  };
} // namespace birdstrike
