#pragma once

#include "io/parameter_tree.h"

#include <string>
#include <vector>

namespace birdstrike
{
  /// What a person types for numbers, as the plain numbers that the entry takes: "2.5 mm" of an entry in m is "0.0025",
  /// "2*pi*50" of one in 1/s "314.1592653589793". A formula is arithmetic (core/expression.h), a unit follows it after
  /// a blank and is one of the entry's dimension (units.h); functions may have several arguments. A plain number stays
  /// as it is typed.
  ///
  /// Lists: each number has its own unit, or the last one has a unit that holds for all; no other mixture. Texts of
  /// entries with a unit are read piece by piece between semicolons, after the last ':' or '=' ("1: 4 mm; 2: 3 mm");
  /// pieces that are no number with a unit are left as they are, formulas in x, t or s among them.
  ///
  /// Throws InputError for a unit of another dimension, an unknown unit and a decimal comma; any other text passes, to
  /// be refused by the entry's own pattern. `where` begins the message: "case.prm, line 3, section 'Bird'".
  std::string read_typed_numbers(const std::string &text, const KnownEntry &entry, const std::string &where);

  /// Several values of an entry, as lists above: where the last one alone has a unit (of a range `either` end), all
  /// have it. Throws InputError where a number without a unit stands beside others that have one; 0 is 0 in all units
  /// but those of temperature that do not begin at 0 K, and texts are left as they are.
  std::vector<std::string> share_unit(const std::vector<std::string> &values, bool either, const KnownEntry &entry,
                                      const std::string &where);
} // namespace birdstrike
