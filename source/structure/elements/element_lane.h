#pragma once

#include <birdstrike/core/number.h>

namespace birdstrike
{
  /// The number of one element in a register of its batch, to be archived as a scalar. What is assigned to the last
  /// element goes to its copies too, which fill up its batch.
  class ElementLane
  {
  public:
    ElementLane(Lanes &batch, const std::size_t element, const std::size_t n_elements)
      : batch(batch), begin(element % n_lanes), end(element + 1 == n_elements ? n_lanes : begin + 1)
    {
    }
    explicit operator double() const
    {
      return batch[begin];
    }
    ElementLane &operator=(const double value)
    {
      for (std::size_t k = begin; k < end; ++k)
        batch[k] = value;
      return *this;
    }

  private:
    Lanes      &batch;
    std::size_t begin, end;
  };
} // namespace birdstrike
