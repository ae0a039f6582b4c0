#pragma once

#include <birdstrike/core/errors.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <string>

namespace birdstrike
{
  /// A number in [lowest, highest] that replaces `value`, unless the text is "table"; `entry` with its sections.
  inline void replace(double &value, const std::string &text, const std::string &entry, const double lowest,
                      const double highest)
  {
    if (text == "table")
      return;
    if (!dealii::Patterns::Double(lowest, highest).match(text))
      throw InputError(fmt::format("{}: '{}' was read.\nAllowed: 'table' or a number from {:g} to {:g}.", entry, text,
                                   lowest, highest));
    value = dealii::Utilities::string_to_double(text);
  }
} // namespace birdstrike
