#pragma once

#include <string>
#include <vector>

namespace birdstrike
{
  /// The pieces between separators outside brackets: "max(1, 2), 3" has two between commas. Outer blanks are removed.
  std::vector<std::string> split_outside_brackets(const std::string &text, char separator);

  /// Between commas, as deal.II splits lists: an empty text has no item, and a comma at the end begins none.
  std::vector<std::string> split_list(const std::string &text);
} // namespace birdstrike
