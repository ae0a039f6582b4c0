#pragma once

#include <birdstrike/bird/parameters.h>
#include <birdstrike/core/number.h>

#include <string>

namespace birdstrike
{
  constexpr double given_tolerance = 1e-3; ///< of speeds, directions and the chord, where an entry is given in two ways

  std::string shown(const Point3 &a); ///< for messages

  /// Throws InputError: `entry` is `found`, and `other` makes it `there`.
  [[noreturn]] void refuse_difference(const BirdParameters &bird, const std::string &entry, const std::string &found,
                                      const std::string &other, const std::string &there);
} // namespace birdstrike
