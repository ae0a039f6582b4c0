#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// An entry of the parameter file and the values that a study gives it.
  struct VariedEntry
  {
    std::string              entry;   ///< "Bird/Particle spacing"
    std::string              unit;    ///< of the entry; "-" for pure numbers and texts
    std::vector<std::string> values;  ///< as the file takes them: plain numbers in the entry's unit, or texts
    std::vector<double>      numbers; ///< the same as numbers; empty where one is none
  };

  /// Reads "Section/Entry=VALUES". VALUES is
  ///   v1, v2, ...      values as the file takes them, with units and formulas: "4 mm, 2.5 mm, 88.9/40 mm"
  ///   v1 | v2 | ...    the same of values that hold commas: "0, 0, 540 | 0, 0, 650 km/h"
  ///   a:b:n            n numbers at equal distances from a to b, both included: "100:300:5", "2 mm:5 mm:4"
  ///
  /// A unit after the last value holds for all of them, one at either end of a range for both ends; else every number
  /// but 0 has one, or none has.
  ///
  /// Throws InputError for a mixture of numbers with and without units, an entry that does not exist, a value that it
  /// does not allow, an empty value, the same value twice unless `may_repeat`, and more than most_points values.
  VariedEntry read_varied_entry(const std::string &text, bool may_repeat = false);

  inline constexpr std::size_t most_points = 10000; ///< of a study
} // namespace birdstrike
