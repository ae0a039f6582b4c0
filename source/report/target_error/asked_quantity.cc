#include "report/target_error/asked_quantity.h"
#include "report/study/study_table.h"
#include <birdstrike/core/errors.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

namespace birdstrike
{
  namespace
  {
    using Words = std::set<std::string>;

    Words set_of(const std::string &text)
    {
      const std::vector<std::string> words = words_in(text);
      return {words.begin(), words.end()};
    }

    /// "Tip peak (mid-chord)".
    std::string plain_name(const ComparisonRow &row)
    {
      return row.group + " " + row.quantity;
    }

    /// Without what stands in parentheses.
    std::string short_name(const ComparisonRow &row)
    {
      const std::string name = plain_name(row);
      return name.substr(0, name.find(" ("));
    }

    /// Other words that users have for what a name says.
    std::string_view other_words(const ComparisonRow &row)
    {
      if (row.group != "Tip" || row.unit != "m")
        return "";
      return "deflection displacement";
    }

    bool may_be(const ComparisonRow &row, const Words &wanted)
    {
      const Words known = set_of(plain_name(row) + " " + std::string(other_words(row)));
      return (row.unit != "s" || wanted.contains("time")) && std::ranges::includes(known, wanted);
    }

    bool is_exactly(const ComparisonRow &row, const Words &wanted)
    {
      return wanted == set_of(plain_name(row)) || wanted == set_of(short_name(row));
    }

    std::string list(const std::vector<ComparisonRow> &rows)
    {
      std::string names; // some hold a comma
      for (const ComparisonRow &row : rows)
        names += (names.empty() ? "" : "; ") + plain_name(row);
      return names;
    }

    std::vector<ComparisonRow> responses_among(const std::vector<ComparisonRow> &rows)
    {
      std::vector<ComparisonRow> found;
      std::ranges::copy_if(rows, std::back_inserter(found), is_response);
      return found;
    }
  } // namespace

  std::string AskedQuantity::name() const
  {
    return group + ": " + quantity;
  }

  std::vector<std::string> words_in(std::string text)
  {
    for (char &letter : text)
      letter = std::isalnum(static_cast<unsigned char>(letter)) != 0
                 ? static_cast<char>(std::tolower(static_cast<unsigned char>(letter)))
                 : ' ';
    std::istringstream       in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
      words.push_back(word);
    return words;
  }

  AskedQuantity find_quantity(const std::string &words)
  {
    const std::vector<ComparisonRow> all    = responses_among(ComparisonTable({}).rows());
    const Words                      wanted = set_of(words);
    std::vector<ComparisonRow>       meant;
    for (const ComparisonRow &row : all)
      {
        if (is_exactly(row, wanted))
          return {row.group, row.quantity};
        if (may_be(row, wanted))
          meant.push_back(row);
      }
    if (meant.size() == 1)
      return {meant[0].group, meant[0].quantity};
    if (meant.empty())
      throw InputError("--target-error: no quantity of any run is '" + words + "'.\n  There are: " + list(all) + ".");
    throw InputError("--target-error: '" + words + "' is ambiguous.\n  It may be: " + list(meant) +
                     ".\n  Action: give one of these names, for example \"" + short_name(meant[0]) + "\".");
  }

  const ComparisonRow &find_row(const std::vector<ComparisonRow> &rows, const AskedQuantity &asked)
  {
    for (const ComparisonRow &row : rows)
      if (row.group == asked.group && row.quantity == asked.quantity)
        return row;
    throw InputError("--target-error: this run has no '" + asked.name() +
                     "'.\n  There are: " + list(responses_among(rows)) + ".");
  }
} // namespace birdstrike
