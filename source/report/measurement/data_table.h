#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace birdstrike
{
  struct TableColumn
  {
    std::string         name;
    std::string         unit;   ///< as written; empty: none was, and the values are as they stand
    std::vector<double> values; ///< SI
  };

  /// A table of numbers from a text file: a measurement, or a history of a run.
  ///
  /// Lines that begin with # are comments, empty ones are passed over. The first other line has the names, separated by
  /// commas, semicolons or tabulators (the first of semicolon, tabulator, comma that occurs there). A unit stands
  /// behind its name in square brackets ("force [kN]", io/units.h), in a line of its own below the names that holds no
  /// number, or, as this program writes it, in a comment "# 3: force [kN]"; values are turned into SI units.
  ///
  /// Throws InputError, naming file and line, for a file that cannot be read, a name without or given twice, a unit
  /// that is none, a row of another length and what is no number, a decimal comma among it.
  class DataTable
  {
  public:
    explicit DataTable(const std::filesystem::path &file);

    /// The column of a name; throws InputError that lists those that are there.
    const TableColumn &column(const std::string &name) const;
    bool               has(const std::string &name) const;

    const std::vector<TableColumn> &columns() const;
    const std::filesystem::path    &file() const;

  private:
    std::filesystem::path    path;
    std::vector<TableColumn> all;
  };
} // namespace birdstrike
