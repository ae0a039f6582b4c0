#pragma once

#include <cstddef>
#include <string>

namespace birdstrike
{
  /// Numbers of the command line, read as the parameter file reads those of its entries: decimal ("010" is ten),
  /// formulas are evaluated, a decimal comma, an empty word and anything else are refused. `option`, "--number", begins
  /// the message of the InputError.
  std::size_t read_option_count(const std::string &option, const std::string &text, int smallest, int largest);
  double      read_option_number(const std::string &option, const std::string &text);
} // namespace birdstrike
