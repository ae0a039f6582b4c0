#include "core/parsed_formula.h"

#include <birdstrike/core/expression.h>

#include <cctype>
#include <cmath>
#include <vector>

namespace birdstrike
{
  namespace
  {
    /// Whether a comma stands outside the brackets of a function, where it separates no arguments.
    bool has_bare_comma(const std::string &text)
    {
      std::vector<bool> is_of_function; // of each open bracket
      for (std::size_t k = 0; k < text.size(); ++k)
        if (text[k] == '(')
          {
            const std::size_t before = k == 0 ? std::string::npos : text.find_last_not_of(" \t", k - 1);
            is_of_function.push_back(before != std::string::npos &&
                                     std::isalnum(static_cast<unsigned char>(text[before])));
          }
        else if (text[k] == ')' && !is_of_function.empty())
          is_of_function.pop_back();
        else if (text[k] == ',' && (is_of_function.empty() || !is_of_function.back()))
          return true;
      return false;
    }
  } // namespace

  std::optional<double> evaluate_arithmetic(const std::string &text)
  {
    // muparser takes '1, 2' for its last number, and deal.II ';' for another formula.
    if (text.find_first_not_of(" \t") == std::string::npos || text.find(';') != std::string::npos ||
        has_bare_comma(text))
      return std::nullopt;
    dealii::FunctionParser<1> function(1);
    try
      {
        compile(function, "no_variable_", text, false, "");
      }
    catch (const InputError &)
      {
        return std::nullopt;
      }
    const double here = function.value(dealii::Point<1>(0.)), there = function.value(dealii::Point<1>(1.));
    return std::isfinite(here) && here == there ? std::optional(here) : std::nullopt;
  }
} // namespace birdstrike
