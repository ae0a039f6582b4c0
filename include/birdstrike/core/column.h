#pragma once

#include <string>

namespace birdstrike
{
  /// What a column of a table or a dataset is.
  struct Column
  {
    std::string name;
    std::string unit    = {}; ///< SI, "-" for a pure number
    std::string meaning = {}; ///< in words: of what, in which frame, with which sign
  };
} // namespace birdstrike
