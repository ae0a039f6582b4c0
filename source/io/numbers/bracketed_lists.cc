#include "io/numbers/bracketed_lists.h"

#include <deal.II/base/utilities.h>

namespace birdstrike
{
  std::vector<std::string> split_outside_brackets(const std::string &text, const char separator)
  {
    std::vector<std::string> pieces(1);
    int                      depth = 0;
    for (const char letter : text)
      {
        depth += (letter == '(') - (letter == ')');
        if (letter == separator && depth <= 0)
          pieces.emplace_back();
        else
          pieces.back() += letter;
      }
    for (std::string &piece : pieces)
      piece = dealii::Utilities::trim(piece);
    return pieces;
  }

  std::vector<std::string> split_list(const std::string &text)
  {
    std::vector<std::string> items = split_outside_brackets(text, ',');
    if (items.back().empty())
      items.pop_back();
    return items;
  }
} // namespace birdstrike
