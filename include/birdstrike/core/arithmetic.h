#pragma once

#include <optional>
#include <string>

namespace birdstrike
{
  /// The value of a formula without variables, "2*pi*50" or "sqrt(3)/2", by the parser of all other formulas (muparser
  /// through deal.II's FunctionParser; the constant pi is known). Nothing for a text that is no such formula, and for a
  /// value that is not finite.
  std::optional<double> evaluate_arithmetic(const std::string &text);
} // namespace birdstrike
