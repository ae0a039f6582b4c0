#pragma once

#include <birdstrike/core/aligned_vector.h>
#include <birdstrike/core/number.h>

#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// What shell elements of a metal that can fail hold besides.
  ///
  /// An element fails within its batch: its stresses become zero, and so its forces of that step. From the next step on
  /// its lane works on the records of a square that rests, and so goes on without stress, force, vote on the step or
  /// anything that is not finite; what it was to the normals of its nodes becomes nothing.
  struct ShellErosion
  {
    struct OfBatch
    {
      Lanes         alive   = 1.;    ///< 0 where failed
      Lanes         energy  = 0.;    ///< J, cumulative, by element
      std::uint32_t dying   = 0;     ///< bits of the lanes that have failed in the present step
      bool          has_new = false; ///< points of a fully integrated batch have failed in the present step
    };
    AlignedVector<OfBatch>            batches;
    std::vector<AlignedVector<Lanes>> damage;        ///< [sections], D of their points; empty while elastic
    std::vector<std::uint32_t>        entering_of;   ///< [n_nodes], where a node is in the list of those that enter
    std::vector<std::uint32_t>        n_left;        ///< [n_nodes], elements that have not failed
    unsigned int                      n_needed = 1;  ///< failed points that make an element fail
    std::size_t                       n_failed = 0;  ///< elements
    double                            mass     = 0.; ///< kg, of those
  };
} // namespace birdstrike
