#pragma once

#include "report/comparison/comparison_table.h"

#include <string>
#include <vector>

namespace birdstrike
{
  /// A quantity that every run may have, by the words of its row in a comparison.
  struct AskedQuantity
  {
    std::string group, quantity;

    std::string name() const; ///< "Tip: peak (mid-chord)"
  };

  /// The one quantity that the words can mean, in any case and order: "tip peak" is "Tip: peak (mid-chord)". A name
  /// may hold further words if no other name holds all of these. A time is meant only where "time" is said. A peak of
  /// the tip is a deflection too. Throws InputError for no quantity, and for several, naming those that may be meant.
  AskedQuantity find_quantity(const std::string &words);

  /// Its row of a run. Throws InputError, naming what the run has, where it has none.
  const ComparisonRow &find_row(const std::vector<ComparisonRow> &rows, const AskedQuantity &asked);

  /// Letters and digits in lower case; all else parts words.
  std::vector<std::string> words_in(std::string text);
} // namespace birdstrike
