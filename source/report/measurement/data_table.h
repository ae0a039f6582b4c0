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
    std::string         written      = {}; ///< the name as it stands in the file, with its unit
    std::string         twice        = {}; ///< says that another column has this name; empty: none has
  };

  /// As io/units.h, and what tables of test rigs have besides: a Greek mu for micro, microstrain, ue, µε.
  std::optional<Unit> parse_column_unit(const std::string &text);

  /// A table of numbers from a text file: a measurement, or a history of a run.
  ///
  /// Text as core/text/text_file.h reads it. Lines that begin with # are comments, empty ones are passed over, so are
  /// what a logger writes above the names (table_layout.h) and the "sep=;" of spreadsheets. Fields are separated by
  /// commas, semicolons, tabulators or blanks. A unit stands behind its name ("force [kN]", "force (kN)", "force / kN";
  /// io/units.h), in a line of its own below the names that holds no number, or, as this program writes it, in a
  /// comment
  /// "# 3: force [kN]"; values are turned into SI units.
  ///
  /// Throws InputError, naming file and line, for a file that cannot be read, a column without a name and a row of
  /// another length; and, once a column is asked for, where this one's name is given twice, its unit is none, or a cell
  /// of it is neither empty nor a number, a decimal comma among it.
  class DataTable
  {
  public:
    explicit DataTable(const std::filesystem::path &file);

    /// The column of a name, with or without its unit; throws InputError that lists those that are there.
    const TableColumn &column(const std::string &name) const;
    bool               has(const std::string &name) const;

    std::vector<std::string>     names() const;
    std::size_t                  line_of_row(std::size_t row) const; ///< of the file, from 1 on
    const std::filesystem::path &file() const;

  private:
    std::filesystem::path    path;
    std::vector<std::size_t> lines_of_rows;
    std::vector<TableColumn> all;

    const TableColumn *find(const std::string &name) const;
  };
} // namespace birdstrike
