#pragma once

#include <birdstrike/io/units.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  struct TableColumn
  {
    std::string         name;
    std::string         unit;              ///< as written; empty: none was, and the values are as they stand
    std::vector<double> values;            ///< SI; NaN: the cell is empty
    std::string         fault        = {}; ///< why the column cannot be used; empty: it can
    std::size_t         line_of_unit = 1;  ///< of the file, from 1 on
  };

  /// As io/units.h, and what tables of test rigs have besides: a Greek mu for micro, microstrain, ue, µε.
  std::optional<Unit> parse_column_unit(const std::string &text);

  /// A table of numbers from a text file: a measurement, or a history of a run.
  ///
  /// Lines that begin with # are comments, empty ones are passed over. The first other line has the names, separated by
  /// commas, semicolons or tabulators (the first of semicolon, tabulator, comma that occurs there). A unit stands
  /// behind its name in square brackets ("force [kN]", io/units.h), in a line of its own below the names that holds no
  /// number, or, as this program writes it, in a comment "# 3: force [kN]"; values are turned into SI units.
  ///
  /// Throws InputError, naming file and line, for a file that cannot be read, a column without a name and a row of
  /// another length; and, once a column is asked for, where this one's name is given twice, its unit is none, or a cell
  /// of it is neither empty nor a number, a decimal comma among it.
  class DataTable
  {
  public:
    explicit DataTable(const std::filesystem::path &file);

    /// The column of a name; throws InputError that lists those that are there.
    const TableColumn &column(const std::string &name) const;
    bool               has(const std::string &name) const;

    std::vector<std::string>     names() const;
    const std::filesystem::path &file() const;

  private:
    std::filesystem::path    path;
    std::vector<TableColumn> all;
  };
} // namespace birdstrike
