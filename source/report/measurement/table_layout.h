#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  struct TableLine
  {
    std::size_t number; ///< in the file, from 1 on
    std::string text;
  };

  /// Where names, units and rows stand among the lines of a table, by their places; what comes before the names is not
  /// of the table.
  struct TableLayout
  {
    char                       separator = ','; ///< blank: any number of blanks and tabulators
    std::size_t                names     = 0;
    std::optional<std::size_t> units     = {};
    std::size_t                first_row = 1;
  };

  /// Without blanks and tabulators around.
  std::string trim_field(const std::string &text);

  /// Fields of a line, without what stands around them. One that begins with a quotation mark ends with one, and
  /// holds separators and doubled marks as letters. Empty where a mark is not closed.
  std::vector<std::string> split_fields(const std::string &line, char separator);

  /// A finite number with a decimal point.
  std::optional<double> parse_cell(const std::string &text);

  /// "force [kN]", "force (kN)", "force / kN" -> "force" and "kN"; round brackets and the stroke only with a unit that
  /// is known, for they stand in names, too.
  void take_unit(std::string &name, std::string &unit);

  /// Of the lines that are no comments and not empty; at least two. Their end, up to 100 lines, shows the separator
  /// (the first of semicolon, tabulator, comma, blanks that most of them have), the number of fields and which of them
  /// are numbers. The first line like these is the first row; the names stand above it, between them at most units.
  /// Where no line is like these, the first one has the names.
  TableLayout find_layout(const std::vector<TableLine> &lines, std::optional<char> separator);
} // namespace birdstrike
