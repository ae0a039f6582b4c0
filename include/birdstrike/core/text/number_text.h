#pragma once

#include <string>

namespace birdstrike
{
  /// A number of a message: six significant digits, as short as they allow: "0.00427", "1e-07", "-3". In its stead
  /// std::to_string, which has six decimals, would say "0.000000" of a time of 100 ns; a test forbids it.
  std::string number_text(double value);

  /// "(0.1, 0.02, -1e-05)", of three numbers.
  std::string point_text(const double *position);
} // namespace birdstrike
