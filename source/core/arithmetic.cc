#include "core/parsed_formula.h"

#include <birdstrike/core/expression.h>

#include <cmath>

namespace birdstrike
{
  std::optional<double> evaluate_arithmetic(const std::string &text)
  {
    // muparser takes '1, 2' for its last number, and deal.II ';' for another formula.
    if (text.find_first_not_of(" \t") == std::string::npos || text.find_first_of(",;") != std::string::npos)
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
