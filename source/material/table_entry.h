#pragma once

#include <birdstrike/core/errors.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace birdstrike
{
  /// A number in [lowest, highest] that replaces `value`, unless the text is "table".
  inline void replace(double &value, const std::string &text, const std::string &entry, const double lowest,
                      const double highest)
  {
    if (text == "table")
      return;
    char        *end    = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(number) || number < lowest || number > highest)
      throw InputError("Blade/Material/" + entry + ": '" + text + "' was read.\nAllowed: 'table' or a number from " +
                       std::to_string(lowest) + " to " + std::to_string(highest) + ".");
    value = number;
  }
} // namespace birdstrike
