#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

/// The small grammars of list entries, whose items are deal.II's Patterns. Each throws InputError
/// that names the entry as it is given here, by its whole path, the piece of text that could not be read and what is
/// allowed.
namespace birdstrike
{
  /// Words between blanks or commas.
  std::vector<std::string> parse_words(std::string text);

  /// "0, 1, 7" -> boundary or material ids.
  std::vector<unsigned int> parse_ids(const std::string &text, const std::string &entry);

  /// `count` numbers separated by blanks or commas.
  std::vector<double> parse_numbers(const std::string &text, std::size_t count, const std::string &entry);

  /// "a: b; c: d" -> (a, b), (c, d) with another separator if wanted.
  std::vector<std::pair<std::string, std::string>> parse_pairs(const std::string &text, const std::string &entry,
                                                               char separator = ';');

  /// Held components of a node, in the order ux uy uz rx ry rz. "clamped" means all, "hinged" the three translations.
  std::array<bool, 6> parse_components(const std::string &text, const std::string &entry);
} // namespace birdstrike
