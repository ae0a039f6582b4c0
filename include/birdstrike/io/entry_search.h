#pragma once

#include <string>

namespace birdstrike
{
  class ParameterTree;

  /// Entries that a word asks for, as text: those of a section or one entry by its path ("Bird", "Bird/Speed",
  /// "Bird/Equation of state"), else those with the word in their path, else in their text; letters without case.
  /// Sections that repeat others ("Bird 2") are named once, unless the word names them. Throws InputError, with the
  /// nearest name, where nothing has the word.
  std::string describe_entries(const ParameterTree &tree, const std::string &word);
} // namespace birdstrike
