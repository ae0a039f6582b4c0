#pragma once

#include "structure/elements/shell/laminate/law.h"
#include <birdstrike/core/aligned_vector.h>

#include <memory>
#include <vector>

namespace birdstrike
{
  /// What a group of shells holds where its section is a laminate.
  struct LaminateSections
  {
    LaminateSections(std::shared_ptr<const Laminate> law, const std::size_t n_batches, const std::size_t n_in_plane)
      : law(std::move(law))
      , elements(n_batches)
      , states(n_batches * n_in_plane, LaminateState<Lanes>{})
      , damage(n_batches * n_in_plane)
      , carries(n_batches, Lanes(1.))
    {
    }

    std::size_t bytes() const
    {
      std::size_t sum = elements.capacity() * sizeof(elements[0]) + states.capacity() * sizeof(states[0]) +
                        carries.capacity() * sizeof(Lanes) + damage.capacity() * sizeof(damage[0]);
      for (const auto &of_section : damage)
        sum += of_section.capacity() * sizeof(of_section[0]);
      return sum;
    }

    std::shared_ptr<const Laminate>              law;
    AlignedVector<LaminateElement<Lanes>>        elements; ///< [n_batches]
    AlignedVector<LaminateState<Lanes>>          states;   ///< [n_in_plane n_batches]
    std::vector<AlignedVector<PlyDamage<Lanes>>> damage;   ///< likewise [layers], empty while none has begun
    AlignedVector<Lanes>                         carries;  ///< [n_batches], of the moduli of stabilisation
  };
} // namespace birdstrike
