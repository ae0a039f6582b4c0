#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace birdstrike
{
  /// Numbers 0, 1, 2, ... for keys in the order in which they are first seen (open addressing, linear probing). Few
  /// keys out of many, with storage that grows with the few and is kept: 2 ns a look-up where sort and binary search
  /// take 40.
  class LocalNumbers
  {
  public:
    /// Forgets all keys; there will be no more than n_keys.
    void restart(const std::size_t n_keys)
    {
      seen.clear();
      const std::size_t n_slots = std::bit_ceil(2 * n_keys + 2);
      shift                     = 32 - std::countr_zero(n_slots);
      slots.assign(n_slots, 0);
    }

    std::uint32_t number(const std::uint32_t key)
    {
      const std::size_t mask = slots.size() - 1;
      for (std::size_t s = (key * 2654435769u) >> shift;; s = (s + 1) & mask) // Fibonacci hashing (Knuth, 6.4)
        {
          if (slots[s] == 0)
            {
              seen.push_back(key);
              slots[s] = static_cast<std::uint32_t>(seen.size());
            }
          if (seen[slots[s] - 1] == key)
            return slots[s] - 1;
        }
    }

    static constexpr std::uint32_t none = 0xffffffffu;

    /// The number of a key, or none.
    std::uint32_t find(const std::uint32_t key) const
    {
      const std::size_t mask = slots.size() - 1;
      for (std::size_t s = (key * 2654435769u) >> shift;; s = (s + 1) & mask)
        if (slots[s] == 0)
          return none;
        else if (seen[slots[s] - 1] == key)
          return slots[s] - 1;
    }

    /// The key of each number.
    const std::vector<std::uint32_t> &keys() const
    {
      return seen;
    }

  private:
    std::vector<std::uint32_t> seen, slots; // a slot holds number + 1, or 0
    int                        shift = 0;
  };
} // namespace birdstrike
