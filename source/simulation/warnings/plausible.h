#pragma once

#include <birdstrike/core/warning.h>

#include <string>
#include <vector>

namespace birdstrike
{
  /// A quantity, the range in which those of bird strike lie (an order of magnitude and more to spare), and other
  /// units that a number out of range may have been meant in.
  struct Plausible
  {
    struct Unit
    {
      const char *name;
      double      factor; ///< SI over this unit
    };

    std::string       code, entry;
    double            value;
    const char       *unit;
    double            lowest, highest;
    std::vector<Unit> others;
  };

  /// Warns (unit/CODE) of a value out of its range, and asks for the unit that would bring it there.
  void check(const Plausible &p, Warnings &warnings);
} // namespace birdstrike
